import assert from "node:assert/strict";
import { test } from "node:test";
import type { Joint, Machine, Triple } from "../src/data/contract.ts";
import { jointMatrix, inverseRigid, multiply, transformPoint, identity, type Matrix } from "../src/kinematics/chain.ts";
import { centreLineText, lineDistance, motionText } from "../src/kinematics/words.ts";
import { layOut } from "../src/scene/layout.ts";
import { cross, dot, subtract } from "../src/kinematics/vector.ts";

const joint = (letter: string, direction: Triple, sign: 1 | -1): Joint => ({
  letter, rotary: "ABC".includes(letter), held: false, direction, point: [0, 0, 0], sign, min: null, max: null, speed: null,
});

/** One axis on the table side or on the head side. */
const machine = (side: "table" | "head", one: Joint): Machine => ({
  name: "one axis", joints: [one], tool_axis: [0, 0, 1], frame_after: side === "table" ? 1 : 0,
});

const text = (side: "table" | "head", letter: string, direction: Triple, sign: 1 | -1): string => motionText(machine(side, joint(letter, direction, sign)), 0);

test("a positive word turns the table against the tool's sense on the part, and the head with it", () => {
  assert.equal(text("table", "C", [0, 0, 1], 1), "C+ turns the table clockwise, seen from above (from Z+)");
  assert.equal(text("table", "C", [0, 0, 1], -1), "C+ turns the table anticlockwise, seen from above (from Z+)");
  assert.equal(text("table", "C", [0, 0, -1], 1), "C+ turns the table anticlockwise, seen from above (from Z+)");
  assert.equal(text("head", "C", [0, 0, 1], 1), "C+ turns the head anticlockwise, seen from above (from Z+)");
  assert.equal(text("head", "B", [0, 1, 0], -1), "B+ turns the head clockwise, seen from Y+");
  assert.equal(text("table", "A", [1, 0, 0], 1), "A+ turns the table clockwise, seen from X+");
});

test("an inclined centre line is looked along from its upper end", () => {
  const h = Math.SQRT1_2;
  assert.equal(text("table", "B", [0, h, -h], 1), "B+ turns the table anticlockwise, seen from the end (0.0000, −0.7071, 0.7071) of its centre line");
  assert.equal(text("head", "B", [0, h, -h], 1), "B+ turns the head clockwise, seen from the end (0.0000, −0.7071, 0.7071) of its centre line");
});

test("a positive word moves a table towards minus, a head towards plus, and a sign changes both", () => {
  assert.equal(text("table", "Y", [0, 1, 0], 1), "Y+ moves the table towards Y−");
  assert.equal(text("table", "Y", [0, 1, 0], -1), "Y+ moves the table towards Y+");
  assert.equal(text("head", "Z", [0, 0, 1], 1), "Z+ moves the head towards Z+");
  assert.equal(text("head", "X", [0.6, 0, 0.8], -1), "X+ moves the head towards (−0.6000, 0.0000, −0.8000)");
});

/** A place of the body of the only joint, seen from the bed: the inverse of its matrix on the table side. */
function fromBed(side: "table" | "head", one: Joint, value: number, place: Triple): Triple {
  const m: Matrix = multiply(identity(), jointMatrix(one, one.point, value));
  return transformPoint(side === "table" ? inverseRigid(m) : m, place);
}

test("words and arrow are what the chain does to a place of the body", () => {
  for (const side of ["table", "head"] as const) {
    for (const sign of [1, -1] as const) {
      const c = joint("C", [0, 0, 1], sign);
      const [, y] = fromBed(side, c, 1, [1, 0, 0]);
      assert.equal(text(side, "C", [0, 0, 1], sign).includes("anticlockwise"), y > 0, `C ${side} ${sign}`);
      const x = joint("X", [1, 0, 0], sign);
      assert.equal(text(side, "X", [1, 0, 0], sign).endsWith("X+"), fromBed(side, x, 1, [0, 0, 0])[0] > 0, `X ${side} ${sign}`);
      for (const one of [c, x]) {
        const layout = layOut({ machine: machine(side, one), points: [[0, 0, 0]], gaugeMm: 100, box: { min: [-10, -10, 0], max: [10, 10, 20] }, travel: [{ min: null, max: null, low: -10, high: 10 }] });
        const { path } = layout.arrows[0];
        const start: Triple = path.kind === "arc" ? [path.centre[0] + path.from[0], path.centre[1] + path.from[1], path.centre[2] + path.from[2]] : path.from;
        const moved = subtract(fromBed(side, one, 0.1, start), start);
        const arrow = path.kind === "arc" ? cross(path.axis, path.from) : path.direction;
        assert.ok(dot(moved, arrow) > 0, `arrow ${one.letter} ${side} ${sign}`);
      }
    }
  }
});

test("the coordinate along a centre line is not named, and lines have the distance of their nearest points", () => {
  assert.equal(centreLineText([0, 0, 1], [1.5, -2, 77]), "X 1.500  Y −2.000");
  assert.equal(centreLineText([0, -1, 0], [1, 2, 3]), "X 1.000  Z 3.000");
  assert.equal(centreLineText([0, 0.6, 0.8], [1, 2, 3]), "X 1.000  Y 2.000  Z 3.000");
  assert.ok(Math.abs(lineDistance({ direction: [0, 0, 1], point: [3, 5, 9] }, { direction: [0, 1, 0], point: [-1, 44, 2] }) - 4) < 1e-12);
  assert.ok(Math.abs(lineDistance({ direction: [0, 0, 1], point: [3, 4, 9] }, { direction: [0, 0, -1], point: [0, 0, 2] }) - 5) < 1e-12);
});
