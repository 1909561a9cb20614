/**
 * The point that the CL data programs, to compare the drawn tip with: read from the text of plain GOTO records only.
 */

import type { Triple } from "./contract.ts";
import type { Lines } from "./lines.ts";
import type { Program } from "./program.ts";

export interface ClPoint {
  tip: Triple;
  /** Where the record has one. */
  axis: Triple | null;
}

const NUMBER = "[-+]?(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][-+]?\\d+)?";
const GOTO = new RegExp(`^\\s*GOTO\\s*/\\s*(${NUMBER}(?:\\s*,\\s*${NUMBER}){2}(?:(?:\\s*,\\s*${NUMBER}){3})?)\\s*$`, "i");

/** Records after which a GOTO is not the point on the part, in coordinates of the part. */
const TRANSFORMS = /^\s*(?:TRANS|TRACUT|COPY|ORIGIN|ROTATE|ROTABL|MIRROR|CUTCOM\s*\/\s*(?!OFF))/i;

/** Reasons of a block that ends at the point of its record. */
const AT_THE_POINT = ["record", "approach"];

/** Point and tool axis of a plain `GOTO/x,y,z[,i,j,k]`; `null` for any other record. */
export function parseGoto(record: string): ClPoint | null {
  const match = GOTO.exec(record);
  if (!match) return null;
  const [x, y, z, ...axis] = match[1].split(",").map(Number);
  return { tip: [x, y, z], axis: axis.length === 3 ? [axis[0], axis[1], axis[2]] : null };
}

export class ClPoints {
  /** Whether points can be compared: lengths are mm, and nothing transforms them. */
  readonly comparable: boolean;
  /** Lines of the CL file in a cycle: the tip goes on from the point. */
  private readonly inCycle = new Set<number>();

  constructor(
    private readonly program: Program,
    private readonly text: Lines | null,
  ) {
    let millimetres = false;
    let plain = true;
    let cycle = false;
    for (let number = 1; number <= (text?.count ?? 0); number += 1) {
      const line = text?.line(number) ?? "";
      if (/^\s*UNITS\s*\//i.test(line)) {
        millimetres = /\/\s*MM\s*$/i.test(line);
        plain &&= millimetres;
      }
      if (TRANSFORMS.test(line)) plain = false;
      if (/^\s*CYCLE\s*\//i.test(line)) cycle = !/\/\s*OFF/i.test(line);
      if (cycle) this.inCycle.add(number);
    }
    this.comparable = millimetres && plain;
  }

  /** CL point of a point of the program; `null` where the program is not at it, or it is not known for certain. */
  at(point: number): ClPoint | null {
    const { program, text } = this;
    const clLine = program.clLine[point];
    if (!this.comparable || text === null || this.inCycle.has(clLine)) return null;
    // A record may need several points: only the last of them is at its point.
    if (program.clLine[point + 1] === clLine || !AT_THE_POINT.includes(program.head.reasons[program.reason[point]])) return null;
    return parseGoto(text.line(clLine));
  }
}
