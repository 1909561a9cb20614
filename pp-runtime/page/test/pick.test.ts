import assert from "node:assert/strict";
import { test } from "node:test";
import { pick, type PickInput } from "../src/scene/pick.ts";

/** Looks along -z at the square from -1 to 1; 200 x 200 px. */
const input = (points: [number, number, number][], x: number, y: number): PickInput => ({
  tip: [0, 1, 2].map((axis) => Float64Array.from(points, (point) => point[axis])) as PickInput["tip"],
  first: 0,
  last: points.length - 1,
  drawn: (point) => point > 0,
  clipFromWorkpiece: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1],
  width: 200,
  height: 200,
  x,
  y,
});

const cross: [number, number, number][] = [[-1, 0, 0], [1, 0, 0], [0, 1, 0.5], [0, -1, 0.5]];

test("the leg under the pointer is found, and none away from the path", () => {
  assert.equal(pick(input(cross, 20, 102)), 1);
  assert.equal(pick(input(cross, 101, 180)), 3);
  assert.equal(pick(input(cross, 20, 180)), null);
});

test("of two legs under the pointer the nearer one to the eye is found", () => {
  assert.equal(pick(input(cross, 100, 100)), 3);
});

test("a leg that is not drawn is not found", () => {
  assert.equal(pick({ ...input(cross, 20, 102), drawn: (point) => point > 1 }), null);
  assert.equal(pick({ ...input(cross, 20, 102), first: 2 }), null);
});
