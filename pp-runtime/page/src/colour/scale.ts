/**
 * Colours for values and for categories, readable with the usual kinds of colour blindness.
 *
 * The scale for values runs from indigo through blue, teal and green to yellow; its lightness rises steadily, so that
 * it is also right in grey. On a light background it ends before the yellow becomes too pale to see, on a dark one it
 * begins later. It is given in OKLCh (lightness, chroma, hue), in which equal steps look equal.
 */

/** Red, green and blue of sRGB, each from 0 to 1. */
export type Rgb = [number, number, number];

export type Theme = "light" | "dark";

/** Lightness at both ends of the scale. */
const LIGHTNESS: Record<Theme, [number, number]> = { light: [0.3, 0.72], dark: [0.5, 0.93] };

/** Share of the scale, hue in degrees, chroma. */
const STOPS: [number, number, number][] = [
  [0, 292, 0.15],
  [0.25, 256, 0.14],
  [0.5, 205, 0.11],
  [0.75, 152, 0.14],
  [1, 102, 0.16],
];

/** Colour of a share of the scale, 0 to 1. */
export function scaleColour(share: number, theme: Theme): Rgb {
  const t = Math.min(Math.max(share, 0), 1);
  const upper = Math.max(1, STOPS.findIndex((stop) => stop[0] >= t));
  const [from, hueFrom, chromaFrom] = STOPS[upper - 1];
  const [to, hueTo, chromaTo] = STOPS[upper];
  const part = (t - from) / (to - from);
  const [dark, light] = LIGHTNESS[theme];
  return fromOklch(dark + t * (light - dark), chromaFrom + part * (chromaTo - chromaFrom), hueFrom + part * (hueTo - hueFrom));
}

/** OKLCh to sRGB; chroma is reduced until the colour exists in sRGB. */
export function fromOklch(lightness: number, chroma: number, hueDegrees: number): Rgb {
  const hue = (hueDegrees * Math.PI) / 180;
  for (let c = chroma; ; c -= 0.001) {
    const linear = linearOfOklab(lightness, c * Math.cos(hue), c * Math.sin(hue));
    if (c <= 0 || linear.every((value) => value >= -1e-6 && value <= 1 + 1e-6)) {
      return linear.map((value) => gamma(Math.min(Math.max(value, 0), 1))) as Rgb;
    }
  }
}

function linearOfOklab(lightness: number, a: number, b: number): Rgb {
  const l = (lightness + 0.3963377774 * a + 0.2158037573 * b) ** 3;
  const m = (lightness - 0.1055613458 * a - 0.0638541728 * b) ** 3;
  const s = (lightness - 0.0894841775 * a - 1.291485548 * b) ** 3;
  return [
    4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
    -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
    -0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s,
  ];
}

const gamma = (value: number): number => (value <= 0.0031308 ? 12.92 * value : 1.055 * value ** (1 / 2.4) - 0.055);
const linear = (value: number): number => (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4);

/** Relative luminance as WCAG 2 defines it. */
export const luminance = ([r, g, b]: Rgb): number => 0.2126 * linear(r) + 0.7152 * linear(g) + 0.0722 * linear(b);

/** Contrast of two colours as WCAG 2 defines it, 1 to 21. */
export function contrast(a: Rgb, b: Rgb): number {
  const [low, high] = [luminance(a), luminance(b)].sort((x, y) => x - y);
  return (high + 0.05) / (low + 0.05);
}

/** Lightness, chroma and hue of the colours of operations: neighbours differ in hue and in lightness. */
const CATEGORIES: [number, number, number][] = [
  [0.5, 0.15, 255],
  [0.62, 0.16, 50],
  [0.6, 0.12, 170],
  [0.52, 0.19, 350],
  [0.66, 0.14, 90],
  [0.45, 0.16, 300],
  [0.66, 0.11, 225],
  [0.5, 0.12, 140],
];

/** Colour of a category; after eight they repeat, lighter or darker. */
export function categoryColour(index: number, theme: Theme): Rgb {
  const [lightness, chroma, hue] = CATEGORIES[index % CATEGORIES.length];
  const round = Math.floor(index / CATEGORIES.length) % 2;
  const shift = (theme === "dark" ? 0.17 : 0) + (theme === "dark" ? -0.1 : -0.12) * round;
  return fromOklch(lightness + shift, chroma, hue);
}

export const cssColour = (colour: Rgb): string => `rgb(${colour.map((value) => Math.round(value * 255)).join(" ")})`;
