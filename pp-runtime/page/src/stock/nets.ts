/**
 * The surface of the lines of a stock: surface nets.
 *
 * Where three lines cross there is a node, in material or not. A cell between eight nodes that are not alike has a
 * vertex: the mean of the places at which its edges enter or leave the material. Every such edge makes a face of the
 * four cells around it.
 */

import type { StockLines } from "./lines.ts";

export interface Surface {
  positions: Float32Array;
  faces: Uint32Array;
}

export function surfaceOf(stock: StockLines): Surface {
  const [nx, ny, nz] = stock.counts;
  const node = (axis: number, index: number): number => stock.low[axis] + (index - 0.5) * stock.pitch[axis];
  // Nodes with a border that is not material.
  const [w, h] = [nx + 2, ny + 2];
  const solid = new Uint8Array(w * h * (nz + 2));
  for (let j = 1; j <= ny; j += 1) {
    for (let i = 1; i <= nx; i += 1) {
      const spans = stock.material(2, i - 1, j - 1);
      for (let s = 0; s < spans.length; s += 2) {
        const first = Math.max(1, Math.ceil((spans[s] - stock.low[2]) / stock.pitch[2] + 0.5));
        const last = Math.min(nz, Math.floor((spans[s + 1] - stock.low[2]) / stock.pitch[2] + 0.5));
        for (let k = first; k <= last; k += 1) solid[(k * h + j) * w + i] = 1;
      }
    }
  }
  const crossing = (axis: number, at: number[], inside: boolean): number => {
    const [low, high] = [node(axis, at[axis]), node(axis, at[axis] + 1)];
    const spans = stock.material(axis, at[(axis + 1) % 3] - 1, at[(axis + 2) % 3] - 1) ?? [];
    let found = Number.NaN;
    for (let s = inside ? 1 : 0; s < spans.length; s += 2) {
      const end = spans[s];
      if (end >= low && end <= high && !(inside ? found <= end : found >= end)) found = end;
    }
    return Number.isNaN(found) ? (low + high) / 2 : found;
  };
  const [cw, ch] = [nx + 1, ny + 1];
  const cells = new Int32Array(cw * ch * (nz + 1)).fill(-1);
  const positions: number[] = [];
  const offsets = [0, 1, w, w + 1, w * h, w * h + 1, w * h + w, w * h + w + 1];
  for (let k = 0; k <= nz; k += 1) {
    for (let j = 0; j <= ny; j += 1) {
      for (let i = 0; i <= nx; i += 1) {
        const base = (k * h + j) * w + i;
        let mask = 0;
        for (let corner = 0; corner < 8; corner += 1) mask |= solid[base + offsets[corner]] << corner;
        if (mask === 0 || mask === 255) continue;
        const sum = [0, 0, 0];
        let count = 0;
        for (let axis = 0; axis < 3; axis += 1) {
          for (let corner = 0; corner < 8; corner += 1) {
            if ((corner >> axis) & 1) continue;
            const here = (mask >> corner) & 1;
            if (here === ((mask >> (corner | (1 << axis))) & 1)) continue;
            const at = [i + (corner & 1), j + ((corner >> 1) & 1), k + (corner >> 2)];
            for (let other = 0; other < 3; other += 1) sum[other] += other === axis ? crossing(axis, at, here === 1) : node(other, at[other]);
            count += 1;
          }
        }
        cells[(k * ch + j) * cw + i] = positions.length / 3;
        positions.push(sum[0] / count, sum[1] / count, sum[2] / count);
      }
    }
  }
  const faces: number[] = [];
  const cell = (i: number, j: number, k: number): number => cells[(k * ch + j) * cw + i];
  const face = (a: number, b: number, c: number, d: number, below: boolean): void => {
    if (below) faces.push(a, b, c, a, c, d);
    else faces.push(a, d, c, a, c, b);
  };
  for (let k = 0; k <= nz; k += 1) {
    for (let j = 0; j <= ny; j += 1) {
      for (let i = 0; i <= nx; i += 1) {
        const base = (k * h + j) * w + i;
        const here = solid[base] === 1;
        if (i > 0 && j > 0 && here !== (solid[base + w * h] === 1)) {
          face(cell(i - 1, j - 1, k), cell(i, j - 1, k), cell(i, j, k), cell(i - 1, j, k), here);
        }
        if (j > 0 && k > 0 && here !== (solid[base + 1] === 1)) {
          face(cell(i, j - 1, k - 1), cell(i, j, k - 1), cell(i, j, k), cell(i, j - 1, k), here);
        }
        if (i > 0 && k > 0 && here !== (solid[base + w] === 1)) {
          face(cell(i - 1, j, k - 1), cell(i - 1, j, k), cell(i, j, k), cell(i, j, k - 1), here);
        }
      }
    }
  }
  return { positions: new Float32Array(positions), faces: new Uint32Array(faces) };
}
