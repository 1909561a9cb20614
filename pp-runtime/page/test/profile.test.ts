import assert from "node:assert/strict";
import { test } from "node:test";
import { outline } from "../src/scene/profile.ts";

test("a tool is divided at its flute length, on its outline", () => {
  const { cutting, shank, unknown } = outline({ profile: [[0, 0], [0, 5], [20, 5], [60, 9]], flute_length: 40, gauge_length: 60 });
  assert.deepEqual(cutting, [[0, 0], [0, 5], [20, 5], [40, 7]]);
  assert.deepEqual(shank, [[40, 7], [60, 9]]);
  assert.equal(unknown, null);
});

test("without a flute length all of the profile cuts", () => {
  const { cutting, shank } = outline({ profile: [[0, 0], [3, 3], [50, 3]], flute_length: null, gauge_length: 50 });
  assert.deepEqual(cutting, [[0, 0], [3, 3], [50, 3]]);
  assert.deepEqual(shank, []);
});

test("a flute longer than the profile ends with it", () => {
  const { cutting, shank } = outline({ profile: [[0, 0], [0, 3], [50, 3]], flute_length: 80, gauge_length: 50 });
  assert.deepEqual(cutting.at(-1), [50, 3]);
  assert.deepEqual(shank, []);
});

test("a profile that begins away from the axis has a flat end", () => {
  assert.deepEqual(outline({ profile: [[0, 4], [10, 4]], flute_length: null, gauge_length: 10 }).cutting[0], [0, 0]);
});

test("what is not known up to the gauge line is named, and nothing is drawn for an unknown shape", () => {
  assert.deepEqual(outline({ profile: [[0, 0], [0, 4], [70, 4]], flute_length: null, gauge_length: 120 }).unknown, [70, 120]);
  assert.deepEqual(outline({ profile: null, flute_length: 20, gauge_length: 90 }), { cutting: [], shank: [], unknown: [0, 90] });
  assert.equal(outline({ profile: null, flute_length: null, gauge_length: null }).unknown, null);
});
