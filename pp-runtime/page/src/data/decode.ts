/**
 * Columns of numbers and texts as they are embedded in the page: base64, raw DEFLATE.
 *
 * A column has the lowest bytes of all its values, then their next bytes, and so on: equal bytes are neighbours.
 */

import type { Column, ColumnType, Head } from "./contract.ts";

const BYTES: Record<ColumnType, number> = { f32: 4, u16: 2, u8: 1, q32: 4 };

/** Bytes of a base64 text; white space in it is skipped. */
export function bytesOfBase64(text: string): Uint8Array<ArrayBuffer> {
  const binary = atob(text);
  const bytes = new Uint8Array(binary.length);
  for (let i = 0; i < binary.length; i += 1) bytes[i] = binary.charCodeAt(i);
  return bytes;
}

/** Bytes of an embedded text, inflated if it is compressed. */
export async function unpack(base64: string, compressed: boolean): Promise<Uint8Array<ArrayBuffer>> {
  const bytes = bytesOfBase64(base64);
  if (!compressed) return bytes;
  const inflated = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate-raw"));
  return new Uint8Array(await new Response(inflated).arrayBuffer());
}

/** Text of bytes: UTF-8 if they are, otherwise each byte is one character (Latin-1). */
export function textOfBytes(bytes: Uint8Array): string {
  try {
    return new TextDecoder("utf-8", { fatal: true }).decode(bytes);
  } catch {
    return new TextDecoder("latin1").decode(bytes);
  }
}

/** The columns of a program by name, every value as f64; unknown values are NaN. */
export function decodeColumns(head: Pick<Head, "columns" | "points">, bytes: Uint8Array): Map<string, Float64Array> {
  const expected = head.columns.reduce((sum, column) => sum + BYTES[column.type] * head.points, 0);
  if (bytes.byteLength !== expected) {
    throw new Error(`the columns have ${bytes.byteLength} bytes, expected ${expected} for ${head.points} points`);
  }
  const columns = new Map<string, Float64Array>();
  let offset = 0;
  for (const column of head.columns) {
    const end = offset + BYTES[column.type] * head.points;
    columns.set(column.name, decodeColumn(column, valueByValue(bytes.subarray(offset, end), head.points), head.points));
    offset = end;
  }
  return columns;
}

/** The bytes of a column with those of each value together, little endian. */
function valueByValue(bytes: Uint8Array, points: number): DataView {
  const width = points > 0 ? bytes.length / points : 0;
  const values = new Uint8Array(bytes.length);
  for (let place = 0; place < width; place += 1) {
    for (let i = 0; i < points; i += 1) values[i * width + place] = bytes[place * points + i];
  }
  return new DataView(values.buffer);
}

function decodeColumn(column: Column, view: DataView, points: number): Float64Array {
  const values = new Float64Array(points);
  switch (column.type) {
    case "f32":
      for (let i = 0; i < points; i += 1) values[i] = view.getFloat32(4 * i, true);
      break;
    case "u16":
      for (let i = 0; i < points; i += 1) values[i] = view.getUint16(2 * i, true);
      break;
    case "u8":
      for (let i = 0; i < points; i += 1) values[i] = view.getUint8(i);
      break;
    case "q32": {
      // The sum is an integer, exact in f64; the scale is applied once, so no error builds up.
      const scale = column.scale ?? 1;
      let sum = 0;
      for (let i = 0; i < points; i += 1) {
        sum += view.getInt32(4 * i, true);
        values[i] = sum * scale;
      }
      break;
    }
  }
  return values;
}
