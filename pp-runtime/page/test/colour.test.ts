import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { test } from "node:test";
import { categoryColour, contrast, luminance, scaleColour, type Rgb, type Theme } from "../src/colour/scale.ts";

const THEMES: Theme[] = ["light", "dark"];

/** Custom properties of the style sheet for a theme. */
function colours(theme: Theme): Map<string, Rgb> {
  const css = readFileSync("src/page.css", "utf8");
  const block = (start: string): string => css.slice(css.indexOf(start), css.indexOf("}", css.indexOf(start)));
  const found = new Map<string, Rgb>();
  const text = block(":root {") + (theme === "dark" ? block(':root[data-theme="dark"] {') : "");
  for (const [, name, hex] of text.matchAll(/--([\w-]+): #([0-9a-f]{6});/g)) {
    found.set(name, [0, 2, 4].map((at) => Number.parseInt(hex.slice(at, at + 2), 16) / 255) as Rgb);
  }
  return found;
}

test("the scale becomes steadily lighter, so that it is right in grey", () => {
  for (const theme of THEMES) {
    for (let i = 1; i <= 100; i += 1) {
      assert.ok(luminance(scaleColour(i / 100, theme)) > luminance(scaleColour((i - 1) / 100, theme)), `${theme} ${i}`);
    }
  }
});

test("values outside the scale have the colour of its ends", () => {
  assert.deepEqual(scaleColour(-3, "light"), scaleColour(0, "light"));
  assert.deepEqual(scaleColour(7, "dark"), scaleColour(1, "dark"));
});

test("the scale has no step: neighbours differ by less than a visible difference of 256 colours", () => {
  for (const theme of THEMES) {
    for (let i = 1; i < 256; i += 1) {
      const [a, b] = [scaleColour((i - 1) / 255, theme), scaleColour(i / 255, theme)];
      assert.ok(Math.max(...a.map((value, channel) => Math.abs(value - b[channel]))) < 0.035, `${theme} ${i}`);
    }
  }
});

test("every line colour can be seen on the ground of the view", () => {
  for (const theme of THEMES) {
    const ground = colours(theme).get("viewport") as Rgb;
    for (let i = 0; i < 16; i += 1) assert.ok(contrast(categoryColour(i, theme), ground) >= 2.5, `${theme} category ${i}`);
    for (let i = 0; i <= 20; i += 1) assert.ok(contrast(scaleColour(i / 20, theme), ground) >= 2, `${theme} scale ${i}`);
  }
});

test("colours of neighbouring operations differ in lightness or hue", () => {
  for (const theme of THEMES) {
    for (let i = 1; i < 16; i += 1) {
      const [a, b] = [categoryColour(i - 1, theme), categoryColour(i, theme)];
      assert.ok(Math.hypot(...a.map((value, channel) => value - b[channel])) > 0.3, `${theme} ${i}`);
    }
  }
});

test("texts have the contrast of WCAG AA, marks and frames of controls that of graphics", () => {
  const texts: [string, string][] = [
    ["text", "ground"], ["text", "surface"], ["text", "raised"], ["text", "current"], ["text", "hovered"], ["text", "match"],
    ["muted", "surface"], ["muted", "raised"], ["muted", "current"], ["muted", "hovered"], ["bad", "bad-ground"], ["bad", "surface"],
    ["good", "good-ground"], ["good", "surface"], ["warn", "warn-ground"], ["code-code", "surface"], ["code-code", "current"],
    ["code-comment", "surface"], ["code-comment", "current"], ["table-arrow", "viewport"], ["head-arrow", "viewport"],
    ["origin", "viewport"], ["surface", "text"],
  ];
  const graphics: [string, string][] = [
    ["control-line", "surface"], ["focus", "surface"], ["accent", "surface"], ["accent", "viewport"], ["hover", "viewport"],
    ["limit", "surface"], ["table-edge", "viewport"], ["head-edge", "viewport"], ["bed-edge", "viewport"],
    ["mark-finding", "surface"], ["mark-rewind", "surface"], ["mark-pole", "surface"], ["mark-retract", "surface"], ["mark-inserted", "surface"],
    ["mark-finding", "viewport"], ["mark-rewind", "viewport"], ["mark-pole", "viewport"], ["mark-retract", "viewport"], ["tick", "viewport"],
  ];
  for (const theme of THEMES) {
    const all = colours(theme);
    for (const [pairs, least] of [[texts, 4.5], [graphics, 3]] as const) {
      for (const [front, back] of pairs) {
        const value = contrast(all.get(front) as Rgb, all.get(back) as Rgb);
        assert.ok(value >= least, `${theme}: --${front} on --${back} has ${value.toFixed(2)}, expected ${least}`);
      }
    }
  }
});
