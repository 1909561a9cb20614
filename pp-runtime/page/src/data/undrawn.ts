/** Motions of the program that are not drawn: to a machine position, where the machine zero is not configured. */

import { lowerBound, type Program } from "./program.ts";

export const NOT_DRAWN = "not drawn: a motion in machine coordinates (set `machine_zero` in the configuration)";

export class Undrawn {
  /** Lines with a motion in machine coordinates that has no point, in order. */
  readonly lines: number[];

  constructor(private readonly program: Program) {
    this.lines = program.head.path.undrawn;
  }

  has(line: number): boolean {
    return this.lines[lowerBound(this.lines, line)] === line;
  }

  /** Lines that are not drawn between a point and the point before it; none where the motion between them is drawn. */
  before(point: number): number[] {
    const { line } = this.program;
    if (!this.program.isStart(point)) return [];
    const from = point === 0 ? 0 : line[point - 1];
    return this.lines.slice(lowerBound(this.lines, from + 1), lowerBound(this.lines, line[point]));
  }
}

/** A list of lines, shortened. */
export function linesText(lines: number[]): string {
  const shown = lines.slice(0, 12).join(", ");
  return `${lines.length === 1 ? "line" : "lines"} ${shown}${lines.length > 12 ? ` and ${lines.length - 12} more` : ""}`;
}
