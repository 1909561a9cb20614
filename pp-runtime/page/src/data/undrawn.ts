/** Motions of the program that are not drawn: to a machine position, where the machine zero is not configured. */

import { tokens, type Lines } from "./lines.ts";
import { lowerBound, type Program } from "./program.ts";

/** Words of a motion in machine coordinates on each control. */
const MACHINE_POSITION: Record<string, RegExp> = {
  heidenhain: /\bM9[12]\b/i,
  siemens: /\b(?:G0?53|G153|SUPA|G7[45])\b(?=.*\b[A-Z]\d?\s*=?\s*[-+.\d])/i,
};
const MACHINE_POSITION_ISO = /\bG(?:53|28|30)(?!\.?\d)/i;

export const NOT_DRAWN = "not drawn: a motion in machine coordinates (set `machine_zero` in the configuration)";

/** Whether a block without its comments moves to a machine position. */
export function inMachineCoordinates(line: string, control: string): boolean {
  const block = tokens(line, control)
    .filter((token) => token.kind !== "comment")
    .map((token) => token.text)
    .join("");
  return (MACHINE_POSITION[control] ?? MACHINE_POSITION_ISO).test(block);
}

export class Undrawn {
  /** Lines with a motion in machine coordinates that has no point, in order. */
  readonly lines: number[] = [];

  constructor(
    private readonly program: Program,
    text: Lines,
  ) {
    const { joints } = program.head.machine;
    const unknown = program.head.placements.some(({ zero }) => joints.some((joint, i) => !joint.rotary && (zero?.[i] ?? null) === null));
    if (!unknown) return;
    const drawn = new Set(program.line);
    for (let line = 1; line <= text.count; line += 1) {
      if (!drawn.has(line) && inMachineCoordinates(text.line(line), program.head.control)) this.lines.push(line);
    }
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
