import assert from "node:assert/strict";
import { test } from "node:test";
import type { Program } from "../src/data/program.ts";
import { Undrawn } from "../src/data/undrawn.ts";

/** Points by their lines; a path begins at those of `starts`. */
function undrawn(lines: number[], line: number[], starts: number[]): Undrawn {
  const head = { path: { rapids_apart: false, undrawn: lines } };
  return new Undrawn({ head, line, isStart: (point: number) => starts.includes(point) } as unknown as Program);
}

test("a line is not drawn if the data of the page lists it", () => {
  const found = undrawn([3, 9], [5, 6, 12], [0, 2]);
  assert.deepEqual([3, 5, 8, 9, 12].map((line) => found.has(line)), [true, false, false, true, false]);
});

test("motions that are not drawn are before the point at which the next path begins", () => {
  const found = undrawn([3, 9, 10], [5, 6, 12], [0, 2]);
  assert.deepEqual([0, 1, 2].map((point) => found.before(point)), [[3], [], [9, 10]]);
});
