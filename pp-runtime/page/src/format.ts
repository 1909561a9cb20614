/** Numbers as text. */

import type { Joint, Tool } from "./data/contract.ts";

/** Minus sign as printed: as wide as plus, unlike the hyphen. */
const minus = (text: string): string => text.replace("-", "−");

export const axisUnit = (joint: Joint): string => (joint.rotary ? "°" : "mm");

/** A value with a fixed number of decimals; a dash where it is unknown. */
export function fixed(value: number, decimals: number): string {
  if (!Number.isFinite(value)) return "–";
  const text = value.toFixed(decimals);
  return minus(Number(text) === 0 ? text.replace("-", "") : text);
}

/** A value with about four digits. */
export function formatValue(value: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value);
  return fixed(value, size >= 1000 ? 0 : size >= 100 ? 1 : size >= 1 ? 2 : 3).replace(/(\.\d*?)0+$/, "$1").replace(/\.$/, "");
}

/** Machining time as h:mm:ss or m:ss.s. */
export function formatTime(seconds: number): string {
  if (!Number.isFinite(seconds)) return "–";
  const tenths = Math.round(seconds * 10);
  const hours = Math.floor(tenths / 36000);
  const minutes = Math.floor(tenths / 600) % 60;
  const rest = (tenths % 600) / 10;
  const two = (value: string): string => value.padStart(value.includes(".") ? 4 : 2, "0");
  return hours > 0 ? `${hours}:${two(String(minutes))}:${two(String(Math.floor(rest)))}` : `${minutes}:${two(rest.toFixed(1))}`;
}

/** A tool in a line. */
export function toolText(tool: Tool): string {
  if (tool.number === 0) return "none yet";
  const gauge = tool.gauge_length === null ? "gauge length unknown" : `gauge ${formatValue(tool.gauge_length)}`;
  return [`T${tool.number}`, tool.name || (tool.kind === "unknown" ? "" : tool.kind), gauge].filter((part) => part !== "").join(" · ");
}
