/**
 * The result of a simulation: findings as places to jump to, deviations, clearances, volumes, and what was not checked.
 */

import { deviationColour, limitsOf, plainColour } from "../colour/deviation.ts";
import { cssColour, type Theme } from "../colour/scale.ts";
import type { Triple } from "../data/contract.ts";
import type { DesignFigures, Region, Simulation } from "../data/simulation.ts";
import { element, fill } from "../dom.ts";
import { fixed, formatTime, formatValue } from "../format.ts";

export interface SimulationEvents {
  /** Goes to a line and marks a place: of the set-up of that line, or of the machined stock. */
  showPlace: (line: number | null, place: Triple, onStock: boolean) => void;
}

/** Longest list of one kind. */
const MOST_ENTRIES = 200;

/** Longest list of clearances. */
const MOST_CLEARANCES = 12;

/** Size of the chart of the removal. */
const CHART = { width: 300, height: 70 };

interface Jump {
  line: number | null;
  place: Triple;
  onStock: boolean;
}

export class SimulationPanel {
  readonly root = element("section", { class: "panel", id: "simulation-panel", "aria-label": "Simulation" });
  private readonly legend = element("div", { class: "legend" });
  private readonly jumps: Jump[] = [];
  private current = -1;

  constructor(
    private readonly simulation: Simulation,
    private readonly events: SimulationEvents,
    theme: Theme,
  ) {
    const { figures } = simulation;
    const { design, findings } = figures;
    const gouges = design ? design.gouge_count + (design.exceeds_stock_mm > limitsOf(design).gouge ? 1 : 0) : 0;
    const clean = figures.collisions === 0 && gouges === 0;
    this.root.append(element("h2", {}, "Simulation"), element("p", { class: clean ? "good" : "bad" }, simulation.line));
    if (design) this.root.append(this.legend);
    this.addEntries(
      `Collisions (${figures.collisions})`,
      findings.map((found) => this.entry(lines(found.line, found.last_line, found.cl_line), found.text, { line: found.line, place: found.place_mm, onStock: false })),
      figures.collisions,
      "none",
    );
    if (design) this.addDesign(design);
    if (figures.clearances.length > 0) this.addClearances();
    this.addRemoval();
    this.addSentences("Tool table", figures.tool_table);
    this.addSentences("Not checked", figures.not_checked);
    this.addSentences("Assumed", figures.assumed);
    this.root.append(
      element("p", { class: "note" }, `Cut surfaces are within ${formatValue(figures.tolerance_mm)} mm of the programmed motion; lines of the stock are ${formatValue(Math.max(...figures.pitch_mm))} mm apart, nothing thinner is seen.`),
    );
    this.restyle(theme);
  }

  /** Goes to the next or previous finding. */
  step(by: 1 | -1): void {
    if (this.jumps.length === 0) return;
    this.current = this.current < 0 ? (by === 1 ? 0 : this.jumps.length - 1) : (this.current + by + this.jumps.length) % this.jumps.length;
    this.jump(this.jumps[this.current]);
  }

  restyle(theme: Theme): void {
    const { design } = this.simulation.figures;
    if (!design) return;
    const { gouge, rest } = limitsOf(design);
    const entries: [string, string][] = [
      [cssColour(deviationColour(-6, theme)), `gouge, ${formatValue(6 * gouge)} mm and more`],
      [cssColour(deviationColour(-1.07, theme)), `gouge, from ${formatValue(gouge)} mm`],
      [cssColour(deviationColour(0, theme)), "on the design"],
      [cssColour(deviationColour(1.07, theme)), `rest material, from ${formatValue(rest)} mm`],
      [cssColour(deviationColour(6, theme)), `rest material, ${formatValue(6 * rest)} mm and more`],
      [cssColour(plainColour(theme)), "not compared"],
    ];
    fill(
      this.legend,
      element(
        "ul",
        {},
        ...entries.map(([colour, label]) => {
          const sample = element("span", { class: "sample" });
          sample.style.setProperty("--sample", colour);
          return element("li", {}, sample, label);
        }),
      ),
    );
  }

  private jump(jump: Jump): void {
    this.events.showPlace(jump.line, jump.place, jump.onStock);
  }

  private entry(place: string, text: string, jump: Jump, finding = true): HTMLElement {
    const mark = finding ? element("span", { class: "mark mark-finding" }) : "";
    const made = element(
      "button",
      { type: "button", class: "entry" },
      element("span", { class: "place" }, mark, place),
      element("span", { class: "text" }, text),
    );
    const index = this.jumps.length;
    if (finding) this.jumps.push(jump);
    made.addEventListener("click", () => {
      if (finding) this.current = index;
      this.jump(jump);
    });
    return made;
  }

  private addEntries(title: string, entries: HTMLElement[], count: number, none: string): void {
    this.root.append(element("h2", {}, title));
    if (entries.length === 0) {
      this.root.append(element("p", { class: "good" }, none));
      return;
    }
    const shown = entries.slice(0, MOST_ENTRIES);
    this.root.append(element("ol", { class: "entries" }, ...shown.map((entry) => element("li", {}, entry))));
    if (count > shown.length) this.root.append(element("p", { class: "note" }, `and ${count - shown.length} more`));
  }

  private addDesign(design: DesignFigures): void {
    const region = (found: Region): HTMLElement =>
      this.entry(found.line === null ? (found.blank ? "as the blank" : "line unknown") : lines(found.line, found.line, found.cl_line ?? 0), found.text, {
        line: found.line,
        place: found.place_mm,
        onStock: true,
      });
    const { gouge, rest } = limitsOf(design);
    if (design.exceeds_stock_mm > gouge) {
      this.root.append(element("p", { class: "bad" }, `The design exceeds the box of the stock by ${fixed(design.exceeds_stock_mm, 3)} mm and is not compared there.`));
    }
    this.addEntries(`Gouges (${design.gouge_count})`, design.gouges.map(region), design.gouge_count, `none: the largest is ${fixed(design.largest_gouge_mm, 3)} mm, allowed are ${fixed(gouge, 3)} mm`);
    this.addEntries(`Rest material (${design.rest_count})`, design.rests.map(region), design.rest_count, `none: the largest is ${fixed(design.largest_rest_mm, 3)} mm, allowed are ${fixed(rest, 3)} mm`);
    this.root.append(element("h2", {}, "Distance from the design"), histogram(design));
  }

  private addClearances(): void {
    const { clearances } = this.simulation.figures;
    this.addEntries(
      "Smallest clearances",
      clearances.slice(0, MOST_CLEARANCES).map((each) =>
        this.entry(`${fixed(each.distance_mm, 2)} mm`, `${each.bodies[0]} and ${each.bodies[1]}, line ${each.line}, tool ${each.tool}`, { line: each.line, place: each.place_mm, onStock: false }, false),
      ),
      clearances.length,
      "none",
    );
  }

  private addRemoval(): void {
    const { operations, removed_mm3, engagement } = this.simulation.figures;
    const rows = operations.map((each) =>
      element(
        "tr",
        {},
        element("td", {}, `${each.operation}`),
        element("td", {}, `T${each.tool}`),
        element("td", {}, formatValue(each.removed_mm3 / 1e3)),
        element("td", {}, each.cutting_min > 0 ? formatTime(60 * each.cutting_min) : "–"),
        element("td", {}, each.largest_mm3_per_min === null ? "–" : formatValue(each.largest_mm3_per_min / 1e3)),
      ),
    );
    const titles = ["operation", "tool", "cm³", "in material", "most cm³/min"];
    this.root.append(
      element("h2", {}, `Removed: ${formatValue(removed_mm3 / 1e3)} cm³`),
      element("table", { class: "figures" }, element("thead", {}, element("tr", {}, ...titles.map((title) => element("th", {}, title)))), element("tbody", {}, ...rows)),
    );
    const { removed_mm3: steps, step_min } = engagement;
    if (steps.length > 1) this.root.append(chart(steps.map((volume) => volume / step_min / 1e3), step_min * steps.length));
  }

  private addSentences(title: string, sentences: string[]): void {
    if (sentences.length === 0) return;
    this.root.append(element("h2", {}, title), element("ul", { class: "warnings" }, ...sentences.map((text) => element("li", {}, text))));
  }
}

const lines = (first: number, last: number, clLine: number): string => `${last > first ? `lines ${first} to ${last}` : `line ${first}`}, CL line ${clLine}`;

/** Number of ends of the stock by their distance from the design. */
function histogram(design: DesignFigures): HTMLElement {
  const total = design.histogram.reduce((sum, each) => sum + each.ends, 0) || 1;
  const most = Math.max(...design.histogram.map((each) => each.ends), 1);
  const label = (from: number | null, to: number | null): string =>
    from === null ? `below ${formatValue(to ?? 0)}` : to === null ? `above ${formatValue(from)}` : `${formatValue(from)} to ${formatValue(to)}`;
  const rows = design.histogram
    .filter((each) => each.ends > 0)
    .map((each) => {
      const bar = element("span", { class: (each.to_mm ?? 1) <= 0 ? "bar inside" : "bar" });
      bar.style.width = `${((100 * each.ends) / most).toFixed(1)}%`;
      return element("tr", {}, element("td", {}, label(each.from_mm, each.to_mm)), element("td", {}, `${((100 * each.ends) / total).toFixed(2)} %`), element("td", { class: "bars" }, bar));
    });
  return element(
    "table",
    { class: "figures histogram" },
    element("thead", {}, element("tr", {}, element("th", {}, "mm (below 0: inside)"), element("th", {}, "share"), element("th", {}))),
    element("tbody", {}, ...rows),
  );
}

/** Rate of removal over the time at feed. */
function chart(rates: number[], minutes: number): HTMLElement {
  const namespace = "http://www.w3.org/2000/svg";
  const most = Math.max(...rates, 1e-9);
  const { width, height } = CHART;
  const svg = document.createElementNS(namespace, "svg");
  svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
  svg.setAttribute("class", "removal-chart");
  svg.setAttribute("role", "img");
  svg.setAttribute("aria-label", `Rate of removal over ${formatValue(minutes)} min at feed, at most ${formatValue(most)} cm³/min`);
  const area = document.createElementNS(namespace, "path");
  const steps = rates.map((rate, i) => {
    const y = (height - (rate / most) * (height - 2)).toFixed(1);
    return `L${((i / rates.length) * width).toFixed(1)} ${y}L${(((i + 1) / rates.length) * width).toFixed(1)} ${y}`;
  });
  area.setAttribute("d", `M0 ${height}${steps.join("")}L${width} ${height}Z`);
  svg.append(area);
  const figure = element("figure", { class: "removal" });
  figure.append(svg, element("figcaption", {}, `Rate of removal over ${formatTime(60 * minutes)} at feed; the top is ${formatValue(most)} cm³/min.`));
  return figure;
}
