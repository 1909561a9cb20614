/** Columns of numbers and texts as they are embedded in the page: base64, raw DEFLATE, little endian. */

import type { Column, ColumnType, Head } from "./contract.ts";

const BYTES: Record<ColumnType, number> = { f32: 4, u32: 4, u16: 2, u8: 1, q32: 4 };

/** Difference that marks a value as unknown (`q32`). */
const UNKNOWN = -0x8000_0000;

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
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const columns = new Map<string, Float64Array>();
  let offset = 0;
  for (const column of head.columns) {
    columns.set(column.name, decodeColumn(column, view, offset, head.points));
    offset += BYTES[column.type] * head.points;
  }
  return columns;
}

function decodeColumn(column: Column, view: DataView, start: number, points: number): Float64Array {
  const values = new Float64Array(points);
  switch (column.type) {
    case "f32":
      for (let i = 0; i < points; i += 1) values[i] = view.getFloat32(start + 4 * i, true);
      break;
    case "u32":
      for (let i = 0; i < points; i += 1) values[i] = view.getUint32(start + 4 * i, true);
      break;
    case "u16":
      for (let i = 0; i < points; i += 1) values[i] = view.getUint16(start + 2 * i, true);
      break;
    case "u8":
      for (let i = 0; i < points; i += 1) values[i] = view.getUint8(start + i);
      break;
    case "q32": {
      // The sum is an integer, exact in f64; the scale is applied once, so no error builds up.
      const scale = column.scale ?? 1;
      let sum = 0;
      for (let i = 0; i < points; i += 1) {
        const difference = view.getInt32(start + 4 * i, true);
        if (difference === UNKNOWN) {
          values[i] = Number.NaN;
        } else {
          sum += difference;
          values[i] = sum * scale;
        }
      }
      break;
    }
  }
  return values;
}
