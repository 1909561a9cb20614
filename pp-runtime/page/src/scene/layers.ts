/** What can be shown and hidden. */

export interface Layer {
  name: string;
  label: string;
  /** Class of the colour sample before the label; none without one. */
  sample: string | null;
  visible: boolean;
  /** Key that switches it. */
  key: string | null;
  apply: (visible: boolean) => void;
}

export class Layers {
  readonly list: Layer[] = [];
  private readonly listeners: (() => void)[] = [];

  add(layer: Layer): void {
    this.list.push(layer);
    layer.apply(layer.visible);
  }

  get(name: string): Layer | undefined {
    return this.list.find((layer) => layer.name === name);
  }

  set(name: string, visible: boolean): void {
    const layer = this.get(name);
    if (!layer) return;
    layer.visible = visible;
    layer.apply(visible);
    for (const listener of this.listeners) listener();
  }

  toggle(name: string): void {
    this.set(name, !this.get(name)?.visible);
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }
}
