/** Vectors of three numbers. */

import type { Triple } from "../data/contract.ts";

export const add = (a: Triple, b: Triple): Triple => [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
export const subtract = (a: Triple, b: Triple): Triple => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
export const scale = (a: Triple, factor: number): Triple => [a[0] * factor, a[1] * factor, a[2] * factor];
export const dot = (a: Triple, b: Triple): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
export const length = (a: Triple): number => Math.hypot(a[0], a[1], a[2]);
export const cross = (a: Triple, b: Triple): Triple => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

/** Unit vector of `a`; `a` must not be zero. */
export const unit = (a: Triple): Triple => scale(a, 1 / length(a));

/** `a` without its part along the unit vector `direction`. */
export const perpendicular = (a: Triple, direction: Triple): Triple => subtract(a, scale(direction, dot(a, direction)));

/** A unit vector perpendicular to the unit vector `direction`, as near to `wanted` as possible. */
export function perpendicularUnit(direction: Triple, wanted: Triple): Triple {
  for (const candidate of [wanted, [0, 1, 0], [1, 0, 0]] as Triple[]) {
    const rest = perpendicular(candidate, direction);
    if (length(rest) > 1e-3) return unit(rest);
  }
  return [0, 0, 1];
}
