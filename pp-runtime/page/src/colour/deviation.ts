/**
 * Colours for the distance of the machined stock from the design: red inside it, blue outside, darker beyond the
 * limits.
 */

import type { DesignFigures } from "../data/simulation.ts";
import { fromOklch, type Rgb, type Theme } from "./scale.ts";

/** Distances from which something is a gouge or rest material, mm. */
export interface DeviationLimits {
  gouge: number;
  rest: number;
}

/** The limits of a comparison: its tolerances with what design and simulation may be off. */
export function limitsOf(design: DesignFigures): DeviationLimits {
  const besides = design.design_tolerance_mm + design.certified_mm;
  return { gouge: design.gouge_tolerance_mm + besides, rest: design.rest_tolerance_mm + besides };
}

const GOUGE_HUE = 27;
const REST_HUE = 255;

/** From this many limits on the colour stays. */
const MOST = 6;

/** Steps of the table to either side. */
const STEPS = 96;

/** Colour of a share of the limit: -1 is at that of gouges, 1 at that of rest material. */
export function deviationColour(share: number, theme: Theme): Rgb {
  const hue = share < 0 ? GOUGE_HUE : REST_HUE;
  const size = Math.min(Math.abs(share), MOST);
  const light = theme === "light" ? 0.84 : 0.72;
  if (size <= 1) return fromOklch(light - 0.06 * size, 0.012 + 0.05 * size, hue);
  const beyond = (size - 1) / (MOST - 1);
  return fromOklch(light - 0.2 - 0.16 * beyond, 0.15 + 0.05 * beyond, hue);
}

/** Colour where the distance is not known, or there is no design. */
export const plainColour = (theme: Theme): Rgb => fromOklch(theme === "light" ? 0.8 : 0.68, 0.035, 95);

/** Colours of vertices: three numbers each. */
export function deviationColours(deviations: Float64Array | null, count: number, limits: DeviationLimits | null, theme: Theme, linear: (colour: Rgb) => Rgb): Float32Array {
  const colours = new Float32Array(3 * count);
  const plain = linear(plainColour(theme));
  const table = Array.from({ length: 2 * STEPS + 1 }, (_, i) => linear(deviationColour(((i - STEPS) / STEPS) * MOST, theme)));
  for (let i = 0; i < count; i += 1) {
    const value = deviations && limits ? deviations[i] : Number.NaN;
    let colour = plain;
    if (limits && Number.isFinite(value)) {
      const limit = Math.max(value < 0 ? limits.gouge : limits.rest, 1e-6);
      const steps = (value / limit / MOST) * STEPS;
      // Just beyond a limit is beyond it in the table, too.
      colour = table[STEPS + Math.max(-STEPS, Math.min(STEPS, value < 0 ? Math.floor(steps) : Math.ceil(steps)))];
    }
    colours.set(colour, 3 * i);
  }
  return colours;
}
