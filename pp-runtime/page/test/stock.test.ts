import assert from "node:assert/strict";
import { test } from "node:test";
import type { Parts, Stage } from "../src/data/simulation.ts";
import { deviationColour } from "../src/colour/deviation.ts";
import { StockLines } from "../src/stock/lines.ts";
import { surfaceOf, type Surface } from "../src/stock/nets.ts";

/** A block of 10 x 8 x 6 mm with lines 1 mm apart, from which line 7 of the program cuts a slot and line 9 the corner. */
function stage(): Stage {
  const counts: [number, number, number] = [10, 8, 6];
  const cuts = [
    { line: 7, low: [3, -1, 2], high: [6, 9, 7] },
    { line: 9, low: [8, 6, -1], high: [11, 9, 7] },
  ];
  const parts = (): { stockLine: number[]; low: number[]; high: number[]; line: number[] } => ({ stockLine: [], low: [], high: [], line: [] });
  const [material, removed] = [parts(), parts()];
  let first = 0;
  for (let family = 0; family < 3; family += 1) {
    const [u, v] = [(family + 1) % 3, (family + 2) % 3];
    for (let j = 0; j < counts[v]; j += 1) {
      for (let i = 0; i < counts[u]; i += 1) {
        const number = first + j * counts[u] + i;
        material.stockLine.push(number);
        material.low.push(0);
        material.high.push(counts[family]);
        material.line.push(0);
        for (const cut of cuts) {
          const inside = (axis: number, index: number): boolean => cut.low[axis] < index + 0.5 && index + 0.5 < cut.high[axis];
          if (!inside(u, i) || !inside(v, j)) continue;
          removed.stockLine.push(number);
          removed.low.push(cut.low[family]);
          removed.high.push(cut.high[family]);
          removed.line.push(cut.line);
        }
      }
    }
    first += counts[u] * counts[v];
  }
  const order = removed.line.map((_, i) => i).sort((a, b) => removed.line[a] - removed.line[b]);
  const typed = (from: typeof material, indices: number[]): Parts => {
    const of = (values: number[]): Float64Array => Float64Array.from(indices.map((i) => values[i]));
    return { stockLine: of(from.stockLine), low: of(from.low), high: of(from.high), line: of(from.line) };
  };
  return { setUp: 0, corners: [[0, 0, 0], [10, 8, 6]], counts, material: typed(material, material.line.map((_, i) => i)), removed: typed(removed, order) };
}

/** Volume inside a surface, and whether each edge has a face on both sides. */
function measure({ positions, faces }: Surface): { volume: number; closed: boolean } {
  let six = 0;
  const edges = new Map<string, number>();
  for (let f = 0; f < faces.length; f += 3) {
    const [a, b, c] = [0, 1, 2].map((i) => Array.from(positions.subarray(3 * faces[f + i], 3 * faces[f + i] + 3)));
    six += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
    for (let i = 0; i < 3; i += 1) {
      const [from, to] = [faces[f + i], faces[f + ((i + 1) % 3)]];
      const [key, sense] = from < to ? [`${from} ${to}`, 1] : [`${to} ${from}`, -1];
      edges.set(key, (edges.get(key) ?? 0) + sense);
    }
  }
  return { volume: six / 6, closed: [...edges.values()].every((sum) => sum === 0) };
}

test("the stock loses what the lines of the program up to the position remove, forwards and backwards", () => {
  const lines = new StockLines(stage());
  const [whole, slot, corner] = [480, 480 - 3 * 8 * 4, 480 - 3 * 8 * 4 - 2 * 2 * 6];
  for (const [line, volume] of [[6, whole], [7, slot], [8, slot], [9, corner], [100, corner], [8, slot], [0, whole]]) {
    lines.seek(line);
    assert.ok(Math.abs(lines.volume() - volume) < 1e-9, `line ${line}: ${lines.volume()}, not ${volume}`);
  }
  assert.equal(lines.seek(5), false);
  assert.equal(lines.seek(7), true);
});

test("the surface of the stock is closed, faces outwards and has about its volume", () => {
  const lines = new StockLines(stage());
  for (const line of [0, 7, 9]) {
    lines.seek(line);
    const surface = surfaceOf(lines);
    const { volume, closed } = measure(surface);
    assert.ok(closed, `line ${line}`);
    assert.ok(volume < lines.volume() && volume > 0.8 * lines.volume(), `line ${line}: ${volume} of ${lines.volume()}`);
    // On planes it is exact.
    const top = Array.from(surface.positions).filter((_, i) => i % 3 === 2);
    assert.ok(Math.max(...top) <= 6 + 1e-6 && top.filter((z) => Math.abs(z - 6) < 1e-6).length > 10);
  }
});

test("gouges are red, rest material is blue, and both stand out from what is within the limits", () => {
  for (const theme of ["light", "dark"] as const) {
    const [gouge, rest] = [deviationColour(-1.1, theme), deviationColour(1.1, theme)];
    assert.ok(gouge[0] > gouge[2] + 0.2 && rest[2] > rest[0] + 0.2, `${gouge} ${rest}`);
    for (const share of [-1, 1]) {
      const [within, beyond] = [deviationColour(share, theme), deviationColour(1.06 * share, theme)];
      const step = Math.hypot(...within.map((value, i) => value - beyond[i]));
      assert.ok(step > 0.25, `${theme}, ${share}: ${step}`);
    }
  }
});
