/** The point under the pointer, whichever part of the page it is in; all parts show it. */
export class Hover {
  point: number | null = null;
  private readonly listeners: (() => void)[] = [];

  set(point: number | null): void {
    if (point === this.point) return;
    this.point = point;
    for (const listener of this.listeners) listener();
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }
}
