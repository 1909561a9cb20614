/**
 * The machine in words, as someone stands before it: how a body moves while the value of its axis grows, and where it
 * turns.
 */

import type { Machine, Triple } from "../data/contract.ts";
import { fixed } from "../format.ts";
import { bodyMotion } from "../scene/layout.ts";
import { cross, dot, length, perpendicular, subtract } from "./vector.ts";

const LETTERS = ["X", "Y", "Z"] as const;

/** Sine of an angle below which two directions are parallel. */
const PARALLEL = 1e-6;

/** Coordinate axis that a unit vector is parallel to, and its sign; `null` for an inclined one. */
function coordinateAxis(direction: Triple): { index: number; sign: 1 | -1 } | null {
  const index = direction.findIndex((value) => Math.abs(value) > 1 - PARALLEL ** 2);
  return index < 0 || Math.hypot(...direction.filter((_, i) => i !== index)) > PARALLEL ? null : { index, sign: direction[index] > 0 ? 1 : -1 };
}

const directionText = (direction: Triple): string => `(${direction.map((value) => fixed(value, 4)).join(", ")})`;

/** Whether a joint carries the table or the head. */
export const bodyOf = (machine: Machine, joint: number): "table" | "head" => (joint < machine.frame_after ? "table" : "head");

/**
 * What a positive word does to the body of an axis, all axes at zero. The arrow in the scene is drawn from the same
 * vector.
 */
export function motionText(machine: Machine, joint: number): string {
  const { letter, rotary } = machine.joints[joint];
  const motion = bodyMotion(machine, joint);
  const body = bodyOf(machine, joint);
  const along = coordinateAxis(motion);
  if (!rotary) {
    const towards = along ? `${LETTERS[along.index]}${along.sign > 0 ? "+" : "−"}` : directionText(motion);
    return `${letter}+ moves the ${body} towards ${towards}`;
  }
  // A right-handed rotation is anticlockwise where its axis points towards the eye.
  const sense = (anticlockwise: boolean): string => (anticlockwise ? "anticlockwise" : "clockwise");
  if (along) {
    const from = along.index === 2 ? "above (from Z+)" : `${LETTERS[along.index]}+`;
    return `${letter}+ turns the ${body} ${sense(along.sign > 0)}, seen from ${from}`;
  }
  // An inclined centre line is looked along from its upper end.
  const [x, y, z] = motion;
  const upwards = Math.abs(z) > PARALLEL ? z > 0 : Math.abs(y) > PARALLEL ? y > 0 : x > 0;
  const end: Triple = upwards ? motion : [-x, -y, -z];
  return `${letter}+ turns the ${body} ${sense(upwards)}, seen from the end ${directionText(end)} of its centre line`;
}

/** Where a centre line is: the coordinates that place it; the one along it is of no meaning. */
export function centreLineText(direction: Triple, point: Triple): string {
  const along = coordinateAxis(direction);
  return LETTERS.flatMap((letter, i) => (along?.index === i ? [] : [`${letter} ${fixed(point[i], 3)}`])).join("  ");
}

/** Shortest distance between two centre lines, mm. */
export function lineDistance(a: { direction: Triple; point: Triple }, b: { direction: Triple; point: Triple }): number {
  const between = subtract(b.point, a.point);
  const across = cross(a.direction, b.direction);
  const size = length(across);
  if (size < PARALLEL) return length(perpendicular(between, a.direction));
  return Math.abs(dot(between, across)) / size;
}
