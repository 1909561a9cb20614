/** Plots over machining time or blocks: axis values, axis speeds, feed and path error, each with its limit. */

import uPlot from "uplot";
import { categoryColour, cssColour, type Theme } from "../colour/scale.ts";
import { lowerBound, type MarkKind, type Program } from "../data/program.ts";
import { button, element } from "../dom.ts";
import { axisUnit, fixed, formatTime, formatValue } from "../format.ts";
import { MARKS } from "../scene/marks.ts";
import type { Hover } from "../selection.ts";
import { styleColour } from "../theme.ts";
import type { Timeline } from "../timeline.ts";

const NOT_COMPARED = "not compared";

/** What is along the x axis. */
export type PlotAxis = "time" | "block";

/** A limit of the points `first` to `last`. */
interface Limit {
  value: number;
  label: "min" | "max" | "tolerance";
  first: number;
  last: number;
}

interface Curve {
  title: string;
  unit: string;
  values: Float64Array;
  /** Limits, each for a run of points. */
  limits: Limit[];
  /** Whether a value is of the whole leg (a speed), not of its end. */
  stepped: boolean;
  fromZero: boolean;
  decimals: number;
  /** Number of the colour. */
  colour: number;
}

interface Tab {
  name: string;
  label: string;
  curves: Curve[];
}

export class Plots {
  readonly root = element("section", { class: "plots", "aria-label": "Plots" });
  private readonly stack = element("div", { class: "plot-stack", id: "plots", tabindex: "0", role: "region", "aria-label": "Plots, with linked cursor" });
  private readonly tabs: Tab[];
  private readonly tabButtons: HTMLButtonElement[];
  private readonly axisButton: HTMLButtonElement;
  private readonly limitsButton: HTMLButtonElement;
  private charts: { plot: uPlot; curve: Curve; readout: HTMLElement }[] = [];
  private tab = 0;
  private x: PlotAxis = "time";
  private toLimits = false;
  private xValues: Float64Array;
  private zoom: [number, number] | null = null;
  private zooming = false;
  private linking = false;

  constructor(
    private readonly program: Program,
    private readonly timeline: Timeline,
    private readonly hover: Hover,
    private theme: Theme,
  ) {
    this.xValues = program.timeS;
    this.tabs = tabsOf(program);
    this.tabButtons = this.tabs.map((tab, i) => {
      const made = element("button", { type: "button", role: "tab", id: `plot-tab-${tab.name}`, "aria-controls": "plots" }, tab.label);
      made.addEventListener("click", () => this.open(i));
      made.addEventListener("keydown", (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (step === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        const next = (i + step + this.tabs.length) % this.tabs.length;
        this.open(next);
        this.tabButtons[next].focus();
      });
      return made;
    });
    this.axisButton = button({ label: "over time", key: "X", press: () => this.toggleAxis() });
    this.limitsButton = button({ label: "to limits", press: () => this.toggleLimits() });
    this.limitsButton.title = "Scale the plots so that the limits are in sight";
    this.limitsButton.setAttribute("aria-pressed", "false");
    const tools = element(
      "div",
      { class: "plot-tools" },
      this.axisButton,
      this.limitsButton,
      button({ label: "−", key: "]", press: () => this.zoomBy(2) }),
      button({ label: "+", key: "[", press: () => this.zoomBy(0.5) }),
      button({ label: "all", key: "\\", press: () => this.setZoom(null) }),
    );
    this.root.append(
      element("header", {}, element("div", { role: "tablist", "aria-label": "Plots", class: "tabs" }, ...this.tabButtons), tools),
      this.stack,
    );
    hover.onChange(() => this.showHover());
    let pending = 0;
    new ResizeObserver(() => {
      cancelAnimationFrame(pending);
      pending = requestAnimationFrame(() => this.resize());
    }).observe(this.stack);
    this.open(0);
  }

  /** Redraws the line of the current position. */
  update(): void {
    const position = this.timeline.position;
    if (this.zoom) this.follow();
    const axes = this.program.axesBetween(position);
    for (const { plot, curve, readout } of this.charts) {
      const before = Math.floor(position);
      const axis = this.program.axes.indexOf(curve.values);
      const value = axis >= 0 ? axes[axis] : curve.values[Math.ceil(position)] ?? curve.values[before];
      readout.textContent = curve.values === this.program.errorUm && this.program.isNotCompared(Math.ceil(position)) ? NOT_COMPARED : `${fixed(value, curve.decimals)} ${curve.unit}`;
      readout.classList.toggle("outside", curve.limits.some((limit) => beyond(value, limit, Math.ceil(position))));
      this.placeNow(plot);
    }
  }

  restyle(theme: Theme): void {
    this.theme = theme;
    this.open(this.tab);
  }

  toggleAxis(): void {
    this.x = this.x === "time" ? "block" : "time";
    this.xValues = this.x === "time" ? this.program.timeS : this.program.blockShare;
    this.axisButton.textContent = this.x === "time" ? "over time" : "over blocks";
    this.zoom = null;
    this.open(this.tab);
  }

  nextTab(): void {
    this.open((this.tab + 1) % this.tabs.length);
  }

  zoomBy(factor: number): void {
    const [from, to] = this.zoom ?? this.whole();
    const now = this.xAt(this.timeline.position);
    const centre = now >= from && now <= to ? now : (from + to) / 2;
    this.setZoom([centre - (centre - from) * factor, centre + (to - centre) * factor]);
  }

  setZoom(zoom: [number, number] | null): void {
    const [low, high] = this.whole();
    let range = zoom;
    if (range) range = [Math.max(range[0], low), Math.min(range[1], high)];
    if (range && range[1] - range[0] >= (high - low) * 0.999) range = null;
    if (range && range[1] - range[0] < (high - low) * 1e-7) return;
    this.zoom = range;
    const [min, max] = range ?? this.whole();
    this.zooming = true;
    for (const { plot } of this.charts) plot.setScale("x", { min, max });
    this.zooming = false;
    this.update();
    this.showHover();
  }

  private toggleLimits(): void {
    this.toLimits = !this.toLimits;
    this.limitsButton.setAttribute("aria-pressed", String(this.toLimits));
    this.open(this.tab);
  }

  private whole(): [number, number] {
    const last = this.program.count - 1;
    const [from, to] = [this.xValues[0] ?? 0, this.xValues[last] ?? 1];
    return to > from ? [from, to] : [from, from + 1];
  }

  private xAt(position: number): number {
    const before = Math.floor(position);
    const after = Math.min(before + 1, this.program.count - 1);
    return this.xValues[before] + (position - before) * (this.xValues[after] - this.xValues[before]);
  }

  /** Point that ends at or after an x value. */
  private pointAt(x: number): number {
    return Math.min(lowerBound(this.xValues, x), this.program.count - 1);
  }

  /** Keeps the current position in sight while zoomed. */
  private follow(): void {
    if (!this.zoom || this.zooming) return;
    const now = this.xAt(this.timeline.position);
    const [from, to] = this.zoom;
    if (now >= from && now <= to) return;
    const [low, high] = this.whole();
    const span = to - from;
    const start = Math.min(Math.max(now - 0.2 * span, low), high - span);
    this.setZoom([start, start + span]);
  }

  private open(index: number): void {
    this.tab = index;
    this.tabButtons.forEach((each, i) => {
      each.setAttribute("aria-selected", String(i === index));
      each.tabIndex = i === index ? 0 : -1;
    });
    for (const { plot } of this.charts) plot.destroy();
    this.charts = [];
    this.stack.replaceChildren();
    this.stack.setAttribute("aria-label", this.tabs[index].label);
    const { curves } = this.tabs[index];
    curves.forEach((curve, i) => this.addChart(curve, i === curves.length - 1));
    this.update();
  }

  private chartSize(last: boolean): { width: number; height: number } {
    const count = this.tabs[this.tab].curves.length;
    const room = this.stack.clientHeight - 21 - count;
    const height = Math.max(Math.floor(room / count), 36);
    return { width: Math.max(this.stack.clientWidth - 178, 120), height: height + (last ? 20 : 0) };
  }

  private resize(): void {
    this.charts.forEach(({ plot }, i) => plot.setSize(this.chartSize(i === this.charts.length - 1)));
    this.update();
  }

  private addChart(curve: Curve, last: boolean): void {
    const readout = element("span", { class: "readout" });
    const note = curve.values === this.program.errorUm && this.notCompared().length > 0 ? [element("span", { class: "chart-limits" }, `grey: ${NOT_COMPARED}`)] : [];
    const limits = [...new Set(curve.limits.map((limit) => `${limit.label} ${formatValue(limit.value)}`))].slice(0, 4).join(", ");
    const host = element("div", { class: "chart" });
    const name = element("span", { class: "chart-name" }, curve.title);
    const colour = cssColour(categoryColour(curve.colour, this.theme));
    name.style.setProperty("--sample", colour);
    const row = element("div", { class: "chart-row" }, element("div", { class: "chart-head" }, element("div", { class: "chart-title" }, name, readout), element("span", { class: "chart-limits", title: limits }, limits), ...note), host);
    this.stack.append(row);
    const [min, max] = this.zoom ?? this.whole();
    const grid = { stroke: styleColour("--grid"), width: 1 };
    const text = styleColour("--muted");
    const font = "11px system-ui, sans-serif";
    const plot = new uPlot(
      {
        ...this.chartSize(last),
        legend: { show: false },
        padding: [4, 8, last ? 0 : 2, 0],
        cursor: {
          y: false,
          points: { show: false },
          drag: { x: true, y: false, setScale: false },
          bind: { dblclick: () => () => null },
        },
        scales: {
          x: { time: false, min, max, auto: false },
          y: { range: (_, smallest: number | null, largest: number | null) => this.yRange(curve, smallest, largest) },
        },
        axes: [
          {
            show: last,
            stroke: text,
            grid,
            ticks: { show: false },
            font,
            size: 20,
            gap: 2,
            values: (_, splits) => splits.map((value) => this.xText(value)),
          },
          { stroke: text, grid, ticks: { show: false }, font, size: 54, gap: 4, space: 15, values: (_, splits) => splits.map(formatValue) },
        ],
        series: [
          {},
          {
            stroke: colour,
            width: 1.25,
            pxAlign: 0,
            points: { show: false },
          },
        ],
        hooks: {
          drawClear: [
            (self) => {
              this.drawMarks(self);
              if (curve.values === this.program.errorUm) this.drawNotCompared(self);
            },
          ],
          draw: [(self) => this.drawLimits(self, curve)],
          setCursor: [(self) => this.cursorMoved(self)],
          setSelect: [(self) => this.selected(self)],
        },
      },
      (curve.stepped ? steps(this.xValues, curve.values) : [this.xValues, plottable(curve.values)]) as uPlot.AlignedData,
      host,
    );
    const now = element("div", { class: "now" });
    const link = element("div", { class: "linked" });
    plot.over.append(now, link);
    plot.over.addEventListener("pointerleave", () => this.hover.set(null));
    let pressedAt = 0;
    plot.over.addEventListener("pointerdown", (event) => {
      pressedAt = event.clientX;
    });
    plot.over.addEventListener("click", (event) => {
      if (Math.abs(event.clientX - pressedAt) > 4) return;
      const x = plot.posToVal(event.offsetX, "x");
      this.timeline.pause();
      if (this.x === "time") this.timeline.seekTime(x);
      else this.timeline.seek(this.pointAt(x));
    });
    plot.over.addEventListener(
      "wheel",
      (event) => {
        if (!event.ctrlKey && !event.shiftKey) return;
        event.preventDefault();
        const [from, to] = this.zoom ?? this.whole();
        const centre = plot.posToVal(event.offsetX, "x");
        const factor = Math.exp(Math.sign(event.deltaY || event.deltaX) * 0.25);
        this.setZoom([centre - (centre - from) * factor, centre + (to - centre) * factor]);
      },
      { passive: false },
    );
    this.charts.push({ plot, curve, readout });
  }

  /** Range of the values in sight, with the limits that are near. */
  private yRange(curve: Curve, smallest: number | null, largest: number | null): [number, number] {
    let [low, high] = [smallest ?? 0, largest ?? 1];
    if (curve.fromZero) low = Math.min(low, 0);
    for (const limit of curve.limits) {
      // A limit that is near is always in sight, one that is far away where it is asked for.
      const near = limit.value <= high + 0.35 * (high - low) && limit.value >= low - 0.35 * (high - low);
      if (this.toLimits || near) [low, high] = [Math.min(low, limit.value), Math.max(high, limit.value)];
    }
    const span = high - low;
    if (span < 1e-9) return [low - 1, high + 1];
    return [curve.fromZero ? low : low - 0.08 * span, high + 0.1 * span];
  }

  private xText(value: number): string {
    if (this.x === "time") return formatTime(value).replace(/\.0$/, "");
    const block = Math.floor(value);
    const { program } = this;
    return block !== value || block >= program.blocks || block < 0 ? "" : `line ${program.line[program.blockFirst[block]]}`;
  }

  /** Stretches near the pole and retracts as bands, rewinds and findings as lines, inserted points as ticks. */
  private drawMarks(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const { program } = this;
    const place = (x: number): number => plot.valToPos(x, "x", true);
    const [from, to] = [bbox.left, bbox.left + bbox.width];
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    let lastTick = Number.NEGATIVE_INFINITY;
    for (const { kind, first, last } of program.stretches) {
      const left = place(this.xValues[Math.max(first - 1, 0)]);
      const right = place(this.xValues[last]);
      if (right < from || left > to) continue;
      ctx.fillStyle = styleColourOf(kind);
      if (kind === "inserted") {
        if (right < lastTick + 2) continue;
        lastTick = right;
        ctx.fillRect(left, bbox.top + bbox.height - 4 * devicePixelRatio, Math.max(right - left, 1), 4 * devicePixelRatio);
        continue;
      }
      const wide = Math.max(right - left, 1.5 * devicePixelRatio);
      ctx.globalAlpha = kind === "rewind" ? 0.45 : 0.2;
      ctx.fillRect(left, bbox.top, wide, bbox.height);
      ctx.globalAlpha = 1;
      ctx.fillRect(left, bbox.top, wide, 3 * devicePixelRatio);
    }
    ctx.fillStyle = styleColour(MARKS.finding.colour);
    for (const finding of program.head.findings) {
      for (const { first, last } of program.findingStretches(finding)) {
        const left = place(this.xValues[Math.max(first - 1, 0)]);
        const wide = Math.max(place(this.xValues[last]) - left, 2 * devicePixelRatio);
        if (left + wide < from || left > to) continue;
        ctx.globalAlpha = 0.22;
        ctx.fillRect(left, bbox.top, wide, bbox.height);
        ctx.globalAlpha = 1;
        ctx.fillRect(left, bbox.top, 2 * devicePixelRatio, bbox.height);
        ctx.fillRect(left, bbox.top, wide, 3 * devicePixelRatio);
      }
    }
    ctx.restore();
  }

  /** Runs of feed points whose path error is not known. */
  private notCompared(): { first: number; last: number }[] {
    const runs: { first: number; last: number }[] = [];
    for (let i = 0; i < this.program.count; i += 1) {
      if (!this.program.isNotCompared(i)) continue;
      const open = runs.at(-1);
      if (open && open.last === i - 1) open.last = i;
      else runs.push({ first: i, last: i });
    }
    return runs;
  }

  /** Grounds the gaps of the path error, with a note where it has room. */
  private drawNotCompared(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const [from, to] = [bbox.left, bbox.left + bbox.width];
    const limited = (x: number): number => Math.min(Math.max(plot.valToPos(x, "x", true), from), to);
    ctx.save();
    ctx.font = `${11 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.textAlign = "center";
    ctx.textBaseline = "middle";
    for (const { first, last } of this.notCompared()) {
      const left = limited(this.xValues[Math.max(first - 1, 0)]);
      const wide = limited(this.xValues[last]) - left;
      if (wide <= 0) continue;
      ctx.fillStyle = styleColour("--grid");
      ctx.fillRect(left, bbox.top, wide, bbox.height);
      if (wide < ctx.measureText(NOT_COMPARED).width + 8 * devicePixelRatio) continue;
      ctx.fillStyle = styleColour("--muted");
      ctx.fillText(NOT_COMPARED, left + wide / 2, bbox.top + bbox.height / 2);
    }
    ctx.restore();
  }

  private drawLimits(plot: uPlot, curve: Curve): void {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.strokeStyle = styleColour("--limit");
    ctx.lineWidth = 1.25 * devicePixelRatio;
    ctx.setLineDash([6 * devicePixelRatio, 4 * devicePixelRatio]);
    for (const limit of curve.limits) {
      const y = plot.valToPos(limit.value, "y", true);
      if (y < bbox.top - 1 || y > bbox.top + bbox.height + 1) continue;
      ctx.beginPath();
      const edge = (point: number): number =>
        Math.min(Math.max(plot.valToPos(this.xValues[point], "x", true), bbox.left), bbox.left + bbox.width);
      ctx.moveTo(limit.first === 0 ? bbox.left : edge(limit.first), y);
      ctx.lineTo(limit.last === this.program.count - 1 ? bbox.left + bbox.width : edge(limit.last), y);
      ctx.stroke();
    }
    ctx.restore();
  }

  private cursorMoved(plot: uPlot): void {
    const { left } = plot.cursor;
    if (this.linking || left === undefined || left < 0) return;
    this.linking = true;
    this.hover.set(this.pointAt(plot.posToVal(left, "x")));
    this.linking = false;
  }

  private selected(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width < 5) return;
    const zoom: [number, number] = [plot.posToVal(left, "x"), plot.posToVal(left + width, "x")];
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
    this.setZoom(zoom);
  }

  private placeNow(plot: uPlot): void {
    place(plot, ".now", this.xAt(this.timeline.position));
  }

  private showHover(): void {
    const { point } = this.hover;
    for (const { plot } of this.charts) place(plot, ".linked", point === null ? null : this.xValues[point]);
  }
}

/** Puts a line over a plot at an x value. */
function place(plot: uPlot, selector: string, x: number | null): void {
  const line = plot.over.querySelector<HTMLElement>(selector);
  if (!line) return;
  const at = x === null ? -1 : plot.valToPos(x, "x");
  line.hidden = at < 0 || at > plot.over.clientWidth;
  line.style.transform = `translateX(${at.toFixed(1)}px)`;
}

const styleColourOf = (kind: MarkKind): string => styleColour(MARKS[kind].colour);

/** Whether the value of a point is past a limit. */
function beyond(value: number, limit: Limit, point: number): boolean {
  if (point < limit.first || point > limit.last) return false;
  return limit.label === "min" ? value < limit.value - 1e-6 : value > limit.value + 1e-6;
}

/** Values as uPlot takes them: where one is unknown a list with gaps. */
function plottable(values: Float64Array): ArrayLike<number | null> {
  if (!values.some((value) => Number.isNaN(value))) return values;
  return Array.from(values, (value) => (Number.isNaN(value) ? null : value));
}

/** Each value from the end of the leg before to the end of its own: two places for one point. */
function steps(x: Float64Array, values: Float64Array): [Float64Array, ArrayLike<number | null>] {
  const xs = new Float64Array(2 * x.length);
  const ys = new Float64Array(2 * x.length);
  for (let i = 0; i < x.length; i += 1) {
    xs[2 * i] = x[Math.max(i - 1, 0)];
    xs[2 * i + 1] = x[i];
    ys[2 * i] = ys[2 * i + 1] = values[i];
  }
  return [xs, plottable(ys)];
}

function tabsOf(program: Program): Tab[] {
  const { joints } = program.head.machine;
  const free = joints.flatMap((joint, i) => (joint.held ? [] : [{ joint, i }]));
  const whole = { first: 0, last: program.count - 1 };
  const runs = program.placementRuns();
  const travel = (axis: number): Limit[] =>
    runs.flatMap(({ placement, first, last }) => {
      const [min, max] = program.limits(axis, placement);
      const low: Limit[] = min === null ? [] : [{ value: min, label: "min", first, last }];
      return max === null ? low : [...low, { value: max, label: "max", first, last }];
    });
  const base = { fromZero: false, stepped: false, decimals: 3 };
  return [
    {
      name: "axes",
      label: "Axis values",
      curves: free.map(({ joint, i }) => ({
        ...base,
        title: joint.letter,
        unit: axisUnit(joint),
        values: program.axes[i],
        limits: travel(i),
        colour: i,
      })),
    },
    {
      name: "speeds",
      label: "Axis speeds",
      curves: free.map(({ joint, i }) => ({
        ...base,
        title: joint.letter,
        unit: `${axisUnit(joint)}/min`,
        values: program.speeds[i],
        limits: joint.speed === null ? [] : [{ value: joint.speed, label: "max", ...whole }],
        stepped: true,
        fromZero: true,
        decimals: 0,
        colour: i,
      })),
    },
    {
      name: "feed",
      label: "Feed and error",
      curves: [
        { ...base, title: "Feed", unit: "mm/min", values: program.feed, limits: [], stepped: true, fromZero: true, decimals: 0, colour: 0 },
        {
          ...base,
          title: "Path error",
          unit: "µm",
          values: program.errorUm,
          limits: [{ value: program.head.tolerance_mm * 1000, label: "tolerance", ...whole }],
          stepped: true,
          fromZero: true,
          decimals: 2,
          colour: 1,
        },
      ],
    },
  ];
}
