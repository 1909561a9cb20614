/** Light and dark: as the system is set, until the reader chooses. Colours are those of the style sheet. */

import type { Theme } from "./colour/scale.ts";

export class ThemeSwitch {
  private readonly system = matchMedia("(prefers-color-scheme: dark)");
  private readonly listeners: (() => void)[] = [];
  private chosen: Theme | null = null;

  constructor() {
    this.system.addEventListener("change", () => this.changed());
    this.apply();
  }

  get theme(): Theme {
    return this.chosen ?? (this.system.matches ? "dark" : "light");
  }

  toggle(): void {
    this.chosen = this.theme === "dark" ? "light" : "dark";
    this.changed();
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  private apply(): void {
    document.documentElement.dataset.theme = this.theme;
  }

  private changed(): void {
    this.apply();
    for (const listener of this.listeners) listener();
  }
}

/** Value of a custom property of the style sheet, such as `--accent`. */
export const styleColour = (name: string): string => getComputedStyle(document.body).getPropertyValue(name).trim();
