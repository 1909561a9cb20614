import assert from "node:assert/strict";
import { test } from "node:test";
import { ClPoints, parseGoto } from "../src/data/cl_point.ts";
import { Lines } from "../src/data/lines.ts";
import type { Program } from "../src/data/program.ts";

test("only a plain GOTO is read", () => {
  assert.deepEqual(parseGoto("GOTO/-73.0701,-50.6440,12.7732,-0.56,-.35,0.75"), { tip: [-73.0701, -50.644, 12.7732], axis: [-0.56, -0.35, 0.75] });
  assert.deepEqual(parseGoto("  GOTO / 1, 2. ,-3E1"), { tip: [1, 2, -30], axis: null });
  for (const record of ["GOTO/P1", "GOTO/1,2", "GOTO/1,2,3,4", "GOTO/1,2,3,4,5,6,7", "GODLTA/1,2,3", "GOTO/1,2,3 $", "FEDRAT/MMPM,100"]) {
    assert.equal(parseGoto(record), null, record);
  }
});

/** A program whose points are at the given CL lines, for the given reasons. */
const program = (clLine: number[], reason: number[]): Program => ({ clLine, reason, head: { reasons: ["record", "tolerance", "approach"] } }) as unknown as Program;

const known = (cl: string[], clLine: number[], reason: number[]): boolean[] => {
  const points = new ClPoints(program(clLine, reason), new Lines(cl.join("\n")));
  return clLine.map((_, point) => points.at(point) !== null);
};

test("a point is compared where the program is at the point of its record", () => {
  const cl = ["UNITS/MM", "GOTO/1,2,3", "GOTO/4,5,6,0,0,1"];
  assert.deepEqual(known(cl, [2, 2, 3, 3], [2, 2, 1, 0]), [false, true, false, true]);
  assert.deepEqual(known(cl, [2, 3], [0, 1]), [true, false]);
});

test("nothing is compared in inches, in cycles, and after a transformation", () => {
  const go = "GOTO/1,2,3";
  assert.deepEqual(known(["UNITS/INCHES", go], [2], [0]), [false]);
  assert.deepEqual(known(["$$ no units", go], [2], [0]), [false]);
  assert.deepEqual(known(["UNITS/MM", "TRANS/0,0,5", go], [3], [0]), [false]);
  assert.deepEqual(known(["UNITS/MM", "CUTCOM/LEFT", go], [3], [0]), [false]);
  assert.deepEqual(known(["UNITS/MM", "CYCLE/DRILL,DEPTH,5", go, "CYCLE/OFF", "GOTO/0,0,9"], [3, 5], [0, 0]), [false, true]);
});
