import assert from "node:assert/strict";
import { test } from "node:test";
import { Group, Matrix4, Vector3 } from "three";
import type { Joint, Machine, Triple } from "../src/data/contract.ts";
import { forward, inverseRigid, jointMatrix, jointValue, multiply, poleMeasure, transformPoint } from "../src/kinematics/chain.ts";
import { visibleSense } from "../src/scene/layout.ts";


const joint = (letter: string, rotary: boolean, direction: Triple, sign: 1 | -1 = 1): Joint => ({
  letter,
  rotary,
  held: false,
  direction,
  point: [0, 0, 0],
  sign,
  min: null,
  max: null,
  speed: null,
});

const near = (actual: ArrayLike<number>, expected: ArrayLike<number>, tolerance: number): void => {
  assert.equal(actual.length, expected.length);
  for (let i = 0; i < actual.length; i += 1) {
    assert.ok(Math.abs(actual[i] - expected[i]) <= tolerance, `${i}: ${actual[i]}, expected ${expected[i]}`);
  }
};

const table: Machine = {
  name: "C B | X Y Z",
  joints: [
    joint("C", true, [0, 0, 1]),
    joint("B", true, [0, 1, 0]),
    joint("X", false, [1, 0, 0]),
    joint("Y", false, [0, 1, 0]),
    joint("Z", false, [0, 0, 1]),
  ],
  tool_axis: [0, 0, 1],
  frame_after: 2,
};

test("the tip of a table with two rotary axes agrees with its equations written out", () => {
  // Both centre lines at height d above the workpiece origin: tip = d + Rz(c) Ry(b) (X, Y, Z - d).
  const d = 70;
  const points: Triple[] = [[0, 0, d], [0, 0, d], [0, 0, 0], [0, 0, 0], [0, 0, 0]];
  for (const [c, b, x, y, z] of [[30, 40, 10, -20, 5], [-170, 95, 1, 2, 3], [725, -3, -40, 8, 60]]) {
    const [cr, br] = [(c * Math.PI) / 180, (b * Math.PI) / 180];
    const u = Math.cos(br) * x + Math.sin(br) * (z - d);
    const w = -Math.sin(br) * x + Math.cos(br) * (z - d);
    const expected = [Math.cos(cr) * u - Math.sin(cr) * y, Math.sin(cr) * u + Math.cos(cr) * y, w + d];
    near(transformPoint(forward(table, points, [c, b, x, y, z]), [0, 0, 0]), expected, 1e-11);
  }
});

test("a joint is the product of two translations and a rotation", () => {
  // The library's own matrices, which share no code with ours.
  const slanted = joint("B", true, [0.36, 0.48, 0.8], -1);
  const point: Triple = [12, -7, 33];
  const expected = new Matrix4()
    .makeTranslation(...point)
    .multiply(new Matrix4().makeRotationAxis(new Vector3(...slanted.direction), (-1 * 77 * Math.PI) / 180))
    .multiply(new Matrix4().makeTranslation(-12, 7, -33));
  near(jointMatrix(slanted, point, 77), expected.elements, 1e-12);
});

test("the scene graph is the product of the joints", () => {
  const points: Triple[] = [[1, 2, 70], [3, 4, 60], [0, 0, 0], [0, 0, 0], [0, 0, 0]];
  const axes = [123, -34, 10, 20, 30];
  const root = new Group();
  let link = root;
  table.joints.forEach((each, i) => {
    const next = new Group();
    next.matrixAutoUpdate = false;
    next.matrix.fromArray(jointMatrix(each, points[i], axes[i]));
    link.add(next);
    link = next;
  });
  root.updateMatrixWorld(true);
  near(link.matrixWorld.elements, forward(table, points, axes), 1e-11);
});

test("an axis value is read back from its matrix, on the revolution asked for", () => {
  for (const sign of [1, -1] as const) {
    for (const value of [-725.5, -180, -90, 0, 12.25, 179.999, 360, 1800.125]) {
      const rotary = joint("C", true, [0, 0.6, 0.8], sign);
      assert.ok(Math.abs(jointValue(rotary, jointMatrix(rotary, [5, 6, 7], value), value + 100) - value) < 1e-9);
      const linear = joint("X", false, [0.6, 0, 0.8], sign);
      assert.ok(Math.abs(jointValue(linear, jointMatrix(linear, [0, 0, 0], value), 0) - value) < 1e-12 * 2000);
    }
  }
});

test("a matrix times its inverse is the identity", () => {
  const m = multiply(jointMatrix(joint("A", true, [1, 0, 0]), [1, 2, 3], 33), jointMatrix(joint("X", false, [0, 0.6, 0.8]), [0, 0, 0], 9));
  near(multiply(m, inverseRigid(m)), new Matrix4().elements, 1e-12);
});

test("the pole of a tilting table is where the tool axis is on the centre line of C", () => {
  for (const b of [0, 0.5, 30, 90]) {
    assert.ok(Math.abs((poleMeasure(table, [77, b, 1, 2, 3]) ?? -1) - Math.sin((b * Math.PI) / 180)) < 1e-12);
  }
  const held: Machine = { ...table, joints: table.joints.map((each) => (each.letter === "B" ? { ...each, held: true } : each)) };
  assert.equal(poleMeasure(held, [0, 0, 0, 0, 0]), null);
});

test("on the machine a table moves against the tool, a head with it, and a sign turns both", () => {
  assert.deepEqual(table.joints.map((_, i) => visibleSense(table, i)), [-1, -1, 1, 1, 1]);
  const backwards: Machine = { ...table, joints: table.joints.map((each) => ({ ...each, sign: -1 })) };
  assert.deepEqual(backwards.joints.map((_, i) => visibleSense(backwards, i)), [1, 1, -1, -1, -1]);
});
