/** The leg of the path under the pointer. */

/** Largest distance of the pointer from the line, px. */
const REACH_PX = 9;

export interface PickInput {
  /** Tips: x, y and z of each point. */
  tip: [Float64Array, Float64Array, Float64Array];
  /** Points to look at: `first` to `last`, both included. */
  first: number;
  last: number;
  /** Whether a leg leads to a point. */
  drawn: (point: number) => boolean;
  /** Clip coordinates from workpiece, in columns. */
  clipFromWorkpiece: ArrayLike<number>;
  width: number;
  height: number;
  /** Pointer, px from the top left corner. */
  x: number;
  y: number;
}

/**
 * Point whose leg is under the pointer, `null` if none is near.
 *
 * Of legs that are about equally near on the screen the one nearest to the eye is taken.
 */
export function pick(input: PickInput): number | null {
  const { tip, clipFromWorkpiece: m, width, height, x, y } = input;
  let best: number | null = null;
  let bestCost = Number.POSITIVE_INFINITY;
  let [beforeX, beforeY, beforeZ] = [0, 0, 0];
  let known = false;
  for (let i = Math.max(input.first - 1, 0); i <= input.last; i += 1) {
    const [px, py, pz] = [tip[0][i], tip[1][i], tip[2][i]];
    const w = m[3] * px + m[7] * py + m[11] * pz + m[15];
    const sx = (((m[0] * px + m[4] * py + m[8] * pz + m[12]) / w + 1) * width) / 2;
    const sy = ((1 - (m[1] * px + m[5] * py + m[9] * pz + m[13]) / w) * height) / 2;
    const sz = (m[2] * px + m[6] * py + m[10] * pz + m[14]) / w;
    if (known && i >= input.first && input.drawn(i)) {
      const dx = sx - beforeX;
      const dy = sy - beforeY;
      const square = dx * dx + dy * dy;
      const along = square > 0 ? Math.min(Math.max(((x - beforeX) * dx + (y - beforeY) * dy) / square, 0), 1) : 1;
      const distance = Math.hypot(x - beforeX - along * dx, y - beforeY - along * dy);
      if (distance <= REACH_PX) {
        // Steps of 3 px, then depth (-1 nearest, 1 farthest).
        const cost = Math.floor(distance / 3) * 4 + beforeZ + along * (sz - beforeZ);
        if (cost < bestCost) {
          bestCost = cost;
          best = i;
        }
      }
    }
    [beforeX, beforeY, beforeZ] = [sx, sy, sz];
    known = Number.isFinite(sx + sy);
  }
  return best;
}
