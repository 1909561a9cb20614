/** The lines of a stock while it is cut: which parts of them are material at a line of the program. */

import type { Triple } from "../data/contract.ts";
import type { Parts, Stage } from "../data/simulation.ts";

export class StockLines {
  readonly counts: Triple;
  readonly low: Triple;
  readonly pitch: Triple;
  /** Lower and upper ends of the material of each line, ascending. */
  private spans: number[][] = [];
  /** Number of parts that are removed. */
  private done = 0;
  private readonly first: Triple;

  constructor(private readonly stage: Stage) {
    const [low, high] = stage.corners;
    const [x, y, z] = stage.counts;
    this.counts = stage.counts;
    this.low = low;
    this.pitch = [0, 1, 2].map((axis) => (high[axis] - low[axis]) / stage.counts[axis]) as Triple;
    this.first = [0, y * z, y * z + z * x];
    this.reset();
  }

  /** Removes what the lines of the program up to one have removed; whether something has changed. */
  seek(line: number): boolean {
    const { removed } = this.stage;
    const wanted = upperBound(removed.line, line);
    if (wanted === this.done) return false;
    if (wanted < this.done) this.reset();
    for (; this.done < wanted; this.done += 1) this.remove(removed, this.done);
    return true;
  }

  /** Material of a line of a family, by its numbers in both directions across. */
  material(family: number, i: number, j: number): number[] {
    return this.spans[this.first[family] + j * this.counts[(family + 1) % 3] + i];
  }

  /** Volume by the lines along Z, mm³. */
  volume(): number {
    let length = 0;
    for (let number = this.first[2]; number < this.spans.length; number += 1) {
      const spans = this.spans[number];
      for (let i = 0; i < spans.length; i += 2) length += spans[i + 1] - spans[i];
    }
    return length * this.pitch[0] * this.pitch[1];
  }

  private reset(): void {
    const [x, y, z] = this.counts;
    const { material } = this.stage;
    this.spans = Array.from({ length: y * z + z * x + x * y }, () => []);
    for (let i = 0; i < material.stockLine.length; i += 1) this.spans[material.stockLine[i]].push(material.low[i], material.high[i]);
    this.done = 0;
  }

  private remove(parts: Parts, index: number): void {
    const number = parts.stockLine[index];
    const [low, high] = [parts.low[index], parts.high[index]];
    const before = this.spans[number];
    const after: number[] = [];
    for (let i = 0; i < before.length; i += 2) {
      const [from, to] = [before[i], before[i + 1]];
      if (to <= low || from >= high) {
        after.push(from, to);
        continue;
      }
      if (from < low) after.push(from, low);
      if (to > high) after.push(high, to);
    }
    this.spans[number] = after;
  }
}

/** Number of ascending values that are not above a limit. */
function upperBound(values: Float64Array, limit: number): number {
  let [low, high] = [0, values.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if (values[middle] <= limit) low = middle + 1;
    else high = middle;
  }
  return low;
}
