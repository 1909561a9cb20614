/**
 * Forward kinematics of the chain: the product of its joints from the workpiece to the tool.
 *
 * `workpiece_from_tool = J0 · J1 · … · Jn`, each for the zero position shifted by its axis value:
 * linear `Trans(sign·q·direction)`, rotary `Trans(point) · Rot(direction, sign·q) · Trans(-point)`.
 * With all axes at zero the tip is at the workpiece origin.
 */

import type { Joint, Machine, Triple } from "../data/contract.ts";
import { cross, dot, length } from "./vector.ts";

/** A 4 x 4 matrix in columns: element (row, column) at `4·column + row`. */
export type Matrix = number[];

export const RAD_PER_DEGREE = Math.PI / 180;

export const identity = (): Matrix => [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** `a · b`. */
export function multiply(a: Matrix, b: Matrix): Matrix {
  const product = new Array<number>(16);
  for (let column = 0; column < 4; column += 1) {
    for (let row = 0; row < 4; row += 1) {
      product[4 * column + row] =
        a[row] * b[4 * column] +
        a[4 + row] * b[4 * column + 1] +
        a[8 + row] * b[4 * column + 2] +
        a[12 + row] * b[4 * column + 3];
    }
  }
  return product;
}

/** The inverse of a rotation with a translation. */
export function inverseRigid(m: Matrix): Matrix {
  const [x, y, z] = [m[12], m[13], m[14]];
  return [
    m[0], m[4], m[8], 0,
    m[1], m[5], m[9], 0,
    m[2], m[6], m[10], 0,
    -(m[0] * x + m[1] * y + m[2] * z),
    -(m[4] * x + m[5] * y + m[6] * z),
    -(m[8] * x + m[9] * y + m[10] * z),
    1,
  ];
}

export const transformPoint = (m: Matrix, p: Triple): Triple => [
  m[0] * p[0] + m[4] * p[1] + m[8] * p[2] + m[12],
  m[1] * p[0] + m[5] * p[1] + m[9] * p[2] + m[13],
  m[2] * p[0] + m[6] * p[1] + m[10] * p[2] + m[14],
];

export const transformDirection = (m: Matrix, d: Triple): Triple => [
  m[0] * d[0] + m[4] * d[1] + m[8] * d[2],
  m[1] * d[0] + m[5] * d[1] + m[9] * d[2],
  m[2] * d[0] + m[6] * d[1] + m[10] * d[2],
];

/** Rotation by `angleRad` about the unit vector `axis` through the point `p`, right-handed. */
export function rotationAbout(axis: Triple, p: Triple, angleRad: number): Matrix {
  const [x, y, z] = axis;
  const c = Math.cos(angleRad);
  const s = Math.sin(angleRad);
  const t = 1 - c;
  const m: Matrix = [
    t * x * x + c, t * x * y + s * z, t * x * z - s * y, 0,
    t * x * y - s * z, t * y * y + c, t * y * z + s * x, 0,
    t * x * z + s * y, t * y * z - s * x, t * z * z + c, 0,
    0, 0, 0, 1,
  ];
  const turned = transformDirection(m, p);
  m[12] = p[0] - turned[0];
  m[13] = p[1] - turned[1];
  m[14] = p[2] - turned[2];
  return m;
}

/** Matrix of one joint at an axis value in mm or degrees; `point` is a point of its centre line. */
export function jointMatrix(joint: Joint, point: Triple, value: number): Matrix {
  if (joint.rotary) return rotationAbout(joint.direction, point, joint.sign * value * RAD_PER_DEGREE);
  const m = identity();
  for (let i = 0; i < 3; i += 1) m[12 + i] = joint.sign * value * joint.direction[i];
  return m;
}

/**
 * Axis value of one joint as its matrix shows it, mm or degrees.
 *
 * A matrix cannot show complete revolutions: the angle is the one nearest to `near`.
 */
export function jointValue(joint: Joint, m: Matrix, near: number): number {
  if (!joint.rotary) return joint.sign * dot([m[12], m[13], m[14]], joint.direction);
  // The rotation's antisymmetric part is sin·direction, its trace 1 + 2 cos.
  const sine: Triple = [(m[6] - m[9]) / 2, (m[8] - m[2]) / 2, (m[1] - m[4]) / 2];
  const cosine = (m[0] + m[5] + m[10] - 1) / 2;
  const angle = (joint.sign * Math.atan2(dot(sine, joint.direction), cosine)) / RAD_PER_DEGREE;
  return angle + 360 * Math.round((near - angle) / 360);
}

/** Workpiece from tool. */
export function forward(machine: Machine, points: Triple[], axes: ArrayLike<number>): Matrix {
  let product = identity();
  machine.joints.forEach((joint, i) => {
    product = multiply(product, jointMatrix(joint, points[i], axes[i]));
  });
  return product;
}

/**
 * How far the tool axis is from the pole of the two free rotary axes: sine of an angle, 0 at the pole.
 *
 * The speed of the tool axis is `a₁ × t` for one rotary axis and `a₂ × t` for the other; near the pole they are
 * parallel and a small change of the tool axis needs a large rotation. `null` for a machine without two free rotary
 * axes.
 */
export function poleMeasure(machine: Machine, axes: ArrayLike<number>): number | null {
  const directions: Triple[] = [];
  let product = identity();
  const origin: Triple = [0, 0, 0];
  for (let i = 0; i < machine.joints.length; i += 1) {
    const joint = machine.joints[i];
    if (!joint.rotary) continue;
    if (!joint.held) directions.push(transformDirection(product, joint.direction));
    product = multiply(product, jointMatrix(joint, origin, axes[i]));
  }
  if (directions.length !== 2) return null;
  const tool = transformDirection(product, machine.tool_axis);
  const first = cross(directions[0], tool);
  const second = cross(directions[1], tool);
  const largest = Math.max(length(first), length(second));
  return largest < 1e-12 ? 0 : length(cross(first, second)) / largest;
}
