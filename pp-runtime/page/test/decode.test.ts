import assert from "node:assert/strict";
import { test } from "node:test";
import { deflateRawSync } from "node:zlib";
import type { Column } from "../src/data/contract.ts";
import { bytesOfBase64, decodeColumns, textOfBytes, unpack } from "../src/data/decode.ts";

/** Bytes of values, lowest bytes first: as a column has them. */
const planes = (bytes: Uint8Array, width: number): Uint8Array =>
  Uint8Array.from(Array.from({ length: width }, (_, place) => [...bytes.filter((_, i) => i % width === place)]).flat());

const base64 = (bytes: Uint8Array): string => Buffer.from(bytes).toString("base64");

test("compressed and plain bytes unpack to the same bytes", async () => {
  const bytes = Uint8Array.from({ length: 5000 }, (_, i) => (i * 7 + (i >> 3)) & 255);
  assert.deepEqual(await unpack(base64(deflateRawSync(bytes)), true), bytes);
  assert.deepEqual(await unpack(base64(bytes), false), bytes);
  assert.deepEqual(bytesOfBase64(base64(bytes)), bytes);
});

test("differences add up to values, and one scale is applied to each sum", () => {
  const columns: Column[] = [{ name: "axis.C", type: "q32", scale: 1e-5 }];
  const bytes = Buffer.alloc(16);
  [3_600_000, -1, 2, -2_000_000_000].forEach((difference, i) => bytes.writeInt32LE(difference, 4 * i));
  const values = decodeColumns({ columns, points: 4 }, planes(bytes, 4)).get("axis.C");
  assert.deepEqual([...(values ?? [])], [3_600_000 * 1e-5, 3_599_999 * 1e-5, 3_600_001 * 1e-5, -1_996_399_999 * 1e-5]);
});

test("columns of all types follow each other, at any offset", () => {
  const columns: Column[] = [
    { name: "kind", type: "u8" },
    { name: "operation", type: "u16" },
    { name: "feed", type: "f32" },
  ];
  const whole = Buffer.alloc(1 + 7);
  const bytes = whole.subarray(1);
  bytes.writeUInt8(200, 0);
  bytes.writeUInt16LE(65_000, 1);
  bytes.writeFloatLE(1500.5, 3);
  const decoded = decodeColumns({ columns, points: 1 }, bytes);
  assert.deepEqual([...decoded.entries()].map(([name, values]) => [name, values[0]]), [
    ["kind", 200],
    ["operation", 65_000],
    ["feed", 1500.5],
  ]);
});

test("a column has the lowest bytes of all values first", () => {
  const decoded = decodeColumns({ columns: [{ name: "operation", type: "u16" }], points: 3 }, Uint8Array.from([1, 2, 3, 0, 1, 2]));
  assert.deepEqual([...(decoded.get("operation") ?? [])], [1, 258, 515]);
});

test("columns that are too short or too long are refused", () => {
  const columns: Column[] = [{ name: "feed", type: "f32" }];
  assert.throws(() => decodeColumns({ columns, points: 2 }, new Uint8Array(7)), /7 bytes, expected 8/);
  assert.throws(() => decodeColumns({ columns, points: 2 }, new Uint8Array(9)), /9 bytes, expected 8/);
});

test("bytes that are not UTF-8 are read as Latin-1", () => {
  assert.equal(textOfBytes(Uint8Array.from([0x52, 0xfc])), "Rü");
  assert.equal(textOfBytes(new TextEncoder().encode("Rü")), "Rü");
});
