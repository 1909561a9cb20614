/** The outline of a tool in its meridian plane. */

import type { Tool } from "../data/contract.ts";

/** Height above the tip and radius, mm. */
export type ProfilePoint = [number, number];

export interface ToolOutline {
  /** What cuts: up to the flute length where it is given. Empty where the shape is unknown. */
  cutting: ProfilePoint[];
  /** What does not cut, from there up to the end of the profile. */
  shank: ProfilePoint[];
  /**
   * From the end of the profile to the gauge line nothing is known: a thin line is drawn. `null` where nothing is
   * missing.
   */
  unknown: [number, number] | null;
}

/** The tool from its tip to its gauge line. */
export function outline(tool: Pick<Tool, "profile" | "flute_length" | "gauge_length">): ToolOutline {
  const profile = closedAtTip(tool.profile ?? []);
  const top = profile.at(-1)?.[0] ?? 0;
  const cut = Math.min(tool.flute_length ?? top, top);
  const [cutting, shank] = profile.length < 2 ? [[], []] : split(profile, cut);
  return { cutting, shank, unknown: tool.gauge_length !== null && top < tool.gauge_length - 1e-6 ? [top, tool.gauge_length] : null };
}

/** A profile that does not begin on the axis gets a flat end. */
function closedAtTip(profile: ProfilePoint[]): ProfilePoint[] {
  if (profile.length === 0 || profile[0][1] < 1e-9) return profile;
  return [[profile[0][0], 0], ...profile];
}

/** A profile in two parts at a height, both with a point there. */
function split(profile: ProfilePoint[], height: number): [ProfilePoint[], ProfilePoint[]] {
  const lower = profile.filter((point) => point[0] <= height);
  const upper = profile.filter((point) => point[0] > height);
  if (upper.length === 0) return [lower, []];
  const a = lower.at(-1);
  if (!a) return [[], upper];
  const b = upper[0];
  const share = (height - a[0]) / (b[0] - a[0]);
  const cut: ProfilePoint = [height, a[1] + share * (b[1] - a[1])];
  if (height - a[0] > 1e-9) lower.push(cut);
  return [lower, [cut, ...upper]];
}
