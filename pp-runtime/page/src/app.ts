/** The page as a whole: its parts, how they are laid out, and what each of them does to the others. */

import { colourings, type Colouring } from "./colour/colouring.ts";
import type { PageData } from "./data/document.ts";
import type { Triple } from "./data/contract.ts";
import { ClPoints } from "./data/cl_point.ts";
import { Undrawn } from "./data/undrawn.ts";
import { button, element, icon } from "./dom.ts";
import { Keyboard, type CommandGroup } from "./keyboard.ts";
import { BlockCard } from "./panels/block_card.ts";
import { DisplayPanel } from "./panels/display.ts";
import { FindingsPanel, OperationsPanel } from "./panels/lists.ts";
import { MachinePanel } from "./panels/machine_facts.ts";
import { Plots } from "./panels/plots.ts";
import { SimulationPanel } from "./panels/simulation.ts";
import { PositionPanel } from "./panels/position.ts";
import { TextPane } from "./panels/text_pane.ts";
import { Transport } from "./panels/transport.ts";
import { Hover } from "./selection.ts";
import type { Fixed } from "./scene/machine.ts";
import type { StockShown } from "./scene/simulated.ts";
import { Stage } from "./scene/stage.ts";
import { STANDARD_VIEWS, type StandardView } from "./scene/view.ts";
import { splitter } from "./splitter.ts";
import { ThemeSwitch } from "./theme.ts";
import { Timeline } from "./timeline.ts";

/** Sheets of the side panel. */
const SHEETS = ["now", "machine", "display", "findings", "simulation", "operations"] as const;
type Sheet = (typeof SHEETS)[number];

const SHEET_LABELS: Record<Sheet, string> = { now: "Position", machine: "Machine", display: "Display", findings: "Findings", simulation: "Simulation", operations: "Operations" };

const VIEW_ICONS: Record<string, string> = {
  fit: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M7 7h6v6H7z",
  machine: "M3 7V3h4M13 3h4v4M17 13v4h-4M7 17H3v-4M10 6v5M7.5 11h5M8 14h4",
  iso: "M10 2.5l6.5 3.7v7.6L10 17.5l-6.5-3.7V6.2zM10 10l6.5-3.8M10 10v7.5M10 10L3.5 6.2",
  tool: "M8 3h4v7l-2 4-2-4zM10 14v3M6 17h8",
};

export class App {
  readonly timeline: Timeline;
  readonly stage: Stage;
  readonly colourings: Colouring[];
  colouring: Colouring;
  private readonly theme = new ThemeSwitch();
  private readonly hover = new Hover();
  private readonly text: TextPane;
  private readonly plots: Plots;
  private readonly position: PositionPanel;
  private readonly machine: MachinePanel;
  private readonly display: DisplayPanel;
  private readonly findings: FindingsPanel;
  private readonly operations: OperationsPanel;
  private readonly simulation: SimulationPanel | null;
  private readonly transport: Transport;
  private readonly blockCard: BlockCard;
  private readonly hoverCard: BlockCard;
  private readonly viewport = element("div", { id: "viewport", class: "viewport" });
  private readonly sheets = new Map<Sheet, HTMLElement>();
  private readonly sheetTabs = new Map<Sheet, HTMLButtonElement>();
  private readonly grid: HTMLElement;
  private hoverPlace: { x: number; y: number } | null = null;
  private shownPoint = -1;
  private started = false;

  constructor(
    private readonly data: PageData,
    root: HTMLElement,
  ) {
    const { program, programText, clText } = data;
    const { theme } = this.theme;
    const undrawn = new Undrawn(program);
    this.timeline = new Timeline(program);
    this.colourings = colourings(program);
    this.colouring = this.colourings[0];

    this.text = new TextPane(programText, program, {
      select: (line) => (undrawn.has(line) ? this.showLine(line) : this.select(line)),
      hover: (line) => this.hover.set(line === null ? null : this.exactPointOfLine(line)),
    });
    this.plots = new Plots(program, this.timeline, this.hover, theme);
    this.transport = new Transport(program, this.timeline, theme);
    this.blockCard = new BlockCard(program, programText, clText, undrawn, false);
    this.hoverCard = new BlockCard(program, programText, clText, undrawn, true);
    this.hoverCard.root.classList.add("hover-card");
    this.hoverCard.root.hidden = true;

    const side = element("aside", { class: "side", "aria-label": "Details" });
    this.grid = element("div", { class: "grid" });
    const lower = element("div", { class: "lower" }, this.plots.root);
    const middle = element("div", { class: "middle" }, this.viewport, this.transport.root);
    this.grid.append(
      this.text.root,
      splitter("Width of the program text", "column", this.grid, "--text-width", 150, 900),
      middle,
      side,
      splitter("Height of the plots", "row", this.grid, "--plots-height", 90, 620),
      lower,
    );
    root.append(this.header(), this.grid);
    document.body.classList.add("app");

    this.stage = new Stage(
      program,
      this.viewport,
      {
        hover: (point, x, y) => {
          this.hoverPlace = point === null ? null : { x, y };
          this.hover.set(point);
          this.placeHoverCard();
        },
        click: (point) => {
          this.timeline.pause();
          this.timeline.seek(point);
        },
      },
      this.colouring,
      theme,
      data.simulation,
    );
    this.viewport.append(this.viewTools(), this.restTools(), ...this.stockTools(), this.hoverCard.root);
    this.position = new PositionPanel(program, this.timeline, this.stage, new ClPoints(program, clText));
    this.machine = new MachinePanel(program, undrawn);
    const choices = { colour: (name: string) => this.setColouring(name), hold: (fixed: Fixed) => this.setFixed(fixed) };
    this.display = new DisplayPanel(this.colourings, this.stage, choices, program.head.path.rapids_apart);
    const events = { seek: (point: number) => this.jump(point), showLine: (line: number) => this.showLine(line) };
    this.findings = new FindingsPanel(program, events);
    this.operations = new OperationsPanel(program, events, theme);
    const showPlace = (line: number | null, place: Triple, onStock: boolean): void => this.showPlace(line, place, onStock);
    this.simulation = data.simulation && new SimulationPanel(data.simulation, { showPlace }, theme);
    this.fillSide(side);
    new Keyboard(this.commands());

    this.timeline.onChange(() => this.update());
    this.hover.onChange(() => this.showHover());
    this.theme.onChange(() => this.restyle());
    this.display.showColouring(this.colouring, theme);
    this.openSheet(program.head.findings.length > 0 ? "findings" : this.simulation ? "simulation" : "now");
    this.showChoices();
    this.update();
    this.started = true;
    this.stage.lookFirst();
  }

  setColouring(name: string): void {
    const colouring = this.colourings.find((each) => each.name === name);
    if (!colouring) throw new Error(`no colouring \`${name}\`; there are ${this.colourings.map((each) => each.name).join(", ")}`);
    this.colouring = colouring;
    this.stage.colour(colouring);
    this.display.showColouring(colouring, this.theme.theme);
  }

  setFixed(fixed: Fixed): void {
    this.stage.setFixed(fixed);
    this.showChoices();
  }

  /** Goes to a line of the program, or to the nearest block after it. */
  select(line: number): void {
    const point = this.data.program.pointOfLine(line);
    if (point !== null) this.jump(point);
  }

  /** Goes to a line of the program that may have no point: the position is then the last one before it. */
  showLine(line: number): void {
    const { program } = this.data;
    const exact = this.exactPointOfLine(line);
    this.jump(exact ?? program.pointBefore(line));
    if (exact !== null) return;
    this.text.setCurrent(line);
    this.blockCard.showLine(line);
  }

  setStock(stock: StockShown): void {
    this.stage.setStock(stock);
    this.showChoices();
  }

  /** Goes to a line and marks a place of its set-up, or of the machined stock. */
  private showPlace(line: number | null, place: Triple, onStock: boolean): void {
    if (line !== null) this.showLine(line);
    const placement = this.data.program.placementAt(this.timeline.point);
    this.stage.markPlace(place, onStock ? null : placement.set_up);
  }

  drawnTip(): Triple {
    return this.stage.machine.drawnTip();
  }

  private jump(point: number): void {
    this.timeline.pause();
    this.timeline.seek(point);
  }

  private exactPointOfLine(line: number): number | null {
    const point = this.data.program.pointOfLine(line);
    return point !== null && this.data.program.line[point] === line ? point : null;
  }

  private update(): void {
    const { point, position } = this.timeline;
    const { program } = this.data;
    this.stage.seek(position);
    this.position.update();
    this.machine.update(position);
    this.plots.update();
    if (point !== this.shownPoint || this.text.currentLine !== program.line[point]) {
      this.shownPoint = point;
      // At first the program is shown from its first line.
      this.text.setCurrent(program.line[point], this.started);
      this.operations.update(point);
      this.blockCard.show(point);
    }
  }

  private showHover(): void {
    const { point } = this.hover;
    this.stage.hover(point);
    this.text.setHover(point === null ? null : this.data.program.line[point]);
    if (point !== null) this.hoverCard.show(point);
    this.placeHoverCard();
  }

  /** The card is in the lower corner that the pointer is not near, and only while the pointer is on the path. */
  private placeHoverCard(): void {
    const card = this.hoverCard.root;
    card.hidden = this.hoverPlace === null || this.hover.point === null;
    if (this.hoverPlace === null || card.hidden) return;
    const { width, height } = this.stage.view.size;
    const left = this.hoverPlace.x < width / 2 ? width - card.offsetWidth - 8 : 8;
    const top = height - card.offsetHeight - 8;
    card.style.transform = `translate(${left.toFixed(0)}px, ${Math.max(top, 8).toFixed(0)}px)`;
  }

  private restyle(): void {
    const { theme } = this.theme;
    this.stage.restyle(theme);
    this.display.showColouring(this.colouring, theme);
    this.plots.restyle(theme);
    this.transport.restyle(theme);
    this.operations.restyle(theme);
    this.simulation?.restyle(theme);
    this.text.restyle();
  }

  private header(): HTMLElement {
    const { head } = this.data.program;
    const title = element("h1", {}, head.program);
    const facts = element("p", {}, `${head.machine.name} · ${head.control} · from ${head.cl}`);
    const found = head.findings.length;
    const badge = element(
      "button",
      { type: "button", class: found > 0 ? "badge bad" : "badge good" },
      found > 0 ? `${found} finding${found > 1 ? "s" : ""}` : "agrees with the CL data",
    );
    badge.title = "for the machine of the tab Machine: signs and centre lines must be compared with the real one";
    badge.addEventListener("click", () => this.openSheet(found > 0 ? "findings" : "machine"));
    const warnings = head.warnings.length;
    const warning = element("button", { type: "button", class: "badge warn" }, `${warnings} warning${warnings > 1 ? "s" : ""}`);
    warning.addEventListener("click", () => this.openSheet("findings"));
    const simulated = this.simulationBadge();
    const summary = button({ label: "Summary", key: "S", id: "summary-toggle", press: () => this.toggleSummary() });
    summary.setAttribute("aria-pressed", "false");
    return element(
      "header",
      { class: "top" },
      element("div", { class: "title" }, title, facts),
      badge,
      ...(simulated ? [simulated] : []),
      ...(warnings > 0 ? [warning] : []),
      element("span", { class: "stretch" }),
      summary,
      button({ label: "Light or dark", icon: icon("M10 3a7 7 0 1 0 7 7 5.5 5.5 0 0 1-7-7z"), key: "D", press: () => this.theme.toggle() }),
      button({ label: "Keys", icon: icon("M7.3 7.2a2.8 2.8 0 1 1 3.9 2.6c-.8.4-1.2.9-1.2 1.9M10 14.6v.6"), key: "?", press: () => this.keyboardHelp() }),
    );
  }

  private simulationBadge(): HTMLElement | null {
    const figures = this.data.simulation?.figures;
    if (!figures) return null;
    const { collisions, design } = figures;
    const gouges = design?.gouge_count ?? 0;
    const count = (number: number, what: string): string => `${number === 0 ? "no" : number} ${what}${number === 1 ? "" : "s"}`;
    const text = [count(collisions, "collision"), ...(design ? [count(gouges, "gouge")] : [])].join(", ");
    const badge = element("button", { type: "button", class: collisions + gouges > 0 ? "badge bad" : "badge good" }, text);
    badge.title = this.data.simulation?.line ?? "";
    badge.addEventListener("click", () => this.openSheet("simulation"));
    return badge;
  }

  private keyboardHelp(): void {
    const dialog = document.getElementById("help-dialog");
    if (dialog instanceof HTMLDialogElement) dialog.showModal();
  }

  private toggleSummary(): void {
    const shown = document.body.classList.toggle("show-summary");
    this.timeline.pause();
    document.getElementById("summary-toggle")?.setAttribute("aria-pressed", String(shown));
    this.stage.view.request();
  }

  private viewTools(): HTMLElement {
    const views = element("div", { class: "view-tools", role: "toolbar", "aria-label": "Views" });
    views.append(
      button({ label: "Fit the path", icon: icon(VIEW_ICONS.fit), key: "F", press: () => this.stage.fit(false) }),
      button({ label: "Fit the machine", icon: icon(VIEW_ICONS.machine), key: "Shift+F", press: () => this.stage.fit(true) }),
      button({ label: "Isometric", icon: icon(VIEW_ICONS.iso), key: "1", press: () => this.stage.look("iso") }),
      button({ label: "Along the tool axis", icon: icon(VIEW_ICONS.tool), key: "8", press: () => this.stage.lookAlongTool() }),
    );
    for (const name of ["top", "front", "right"] as StandardView[]) {
      const { label, key } = STANDARD_VIEWS[name];
      views.append(button({ label, key, press: () => this.stage.look(name) }));
    }
    return views;
  }

  /** What is at rest: the bed, as one stands before the machine, or the part, in whose coordinates the path is. */
  private restTools(): HTMLElement {
    const group = element("div", { class: "rest-tools", role: "group", "aria-label": "At rest" });
    for (const [fixed, label] of [["machine", "Machine"], ["part", "Part"]] as [Fixed, string][]) {
      const made = button({ label, press: () => this.setFixed(fixed) });
      made.title = `${label} at rest (B)`;
      made.dataset.fixed = fixed;
      group.append(made);
    }
    return group;
  }

  /** Which stock is shown; nothing without a simulation. */
  private stockTools(): HTMLElement[] {
    const { simulated } = this.stage;
    if (!simulated) return [];
    const group = element("div", { class: "rest-tools stock-tools", role: "group", "aria-label": "Stock" });
    const choices: [StockShown, string][] = [["result", "Machined stock"], ["cut", "As it is cut"], ["off", "No stock"]];
    for (const [stock, label] of choices) {
      if (stock === "cut" && !simulated.hasStages) continue;
      const made = button({ label, press: () => this.setStock(stock) });
      made.title = `${label} (G)`;
      made.dataset.stock = stock;
      group.append(made);
    }
    return [group];
  }

  /** Shows the choices of the display as they are now. */
  private showChoices(): void {
    this.display.update();
    for (const each of this.viewport.querySelectorAll<HTMLElement>("[data-fixed]")) {
      each.setAttribute("aria-pressed", String(each.dataset.fixed === this.stage.fixed));
    }
    for (const each of this.viewport.querySelectorAll<HTMLElement>("[data-stock]")) {
      each.setAttribute("aria-pressed", String(each.dataset.stock === this.stage.simulated?.stock));
    }
  }

  private fillSide(side: HTMLElement): void {
    const contents: Record<Sheet, HTMLElement[]> = {
      now: [this.position.root, element("section", { class: "panel", "aria-label": "Block" }, element("h2", {}, "Block"), this.blockCard.root)],
      machine: [this.machine.root],
      display: [this.display.root],
      findings: [this.findings.root],
      simulation: this.simulation ? [this.simulation.root] : [],
      operations: [this.operations.root],
    };
    const names = SHEETS.filter((name) => contents[name].length > 0);
    const tablist = element("div", { class: "tabs", role: "tablist", "aria-label": "Details" });
    for (const name of names) {
      const tab = element("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": `sheet-${name}` }, SHEET_LABELS[name]);
      tab.addEventListener("click", () => this.openSheet(name));
      tab.addEventListener("keydown", (event) => {
        const step = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
        if (step === undefined) return;
        event.preventDefault();
        event.stopPropagation();
        const next = names[(names.indexOf(name) + step + names.length) % names.length];
        this.openSheet(next);
        this.sheetTabs.get(next)?.focus();
      });
      const sheet = element("div", { class: "sheet", role: "tabpanel", id: `sheet-${name}`, "aria-labelledby": `tab-${name}`, tabindex: "0" }, ...contents[name]);
      this.sheets.set(name, sheet);
      this.sheetTabs.set(name, tab);
      tablist.append(tab);
      side.append(sheet);
    }
    side.prepend(tablist);
    this.openSheet("now");
  }

  private openSheet(wanted: Sheet): void {
    for (const name of SHEETS) {
      const open = name === wanted;
      const tab = this.sheetTabs.get(name);
      const sheet = this.sheets.get(name);
      if (!tab || !sheet) continue;
      sheet.hidden = !open;
      tab.setAttribute("aria-selected", String(open));
      tab.tabIndex = open ? 0 : -1;
    }
  }

  private nextColouring(by: 1 | -1): void {
    const index = (this.colourings.indexOf(this.colouring) + by + this.colourings.length) % this.colourings.length;
    this.setColouring(this.colourings[index].name);
    this.openSheet("display");
  }

  private commands(): CommandGroup[] {
    const { timeline, stage } = this;
    const cycle = <Value>(values: Value[], now: Value): Value => values[(values.indexOf(now) + 1) % values.length];
    const updated = (change: () => void) => (): void => {
      change();
      this.showChoices();
    };
    return [
      {
        title: "Playback",
        commands: [
          { keys: [" "], label: "play or pause", run: () => timeline.toggle() },
          { keys: ["ArrowRight"], label: "next block", run: () => timeline.stepBlock(1) },
          { keys: ["ArrowLeft"], label: "previous block", run: () => timeline.stepBlock(-1) },
          { keys: ["Shift+ArrowRight"], label: "next point", run: () => timeline.stepPoint(1) },
          { keys: ["Shift+ArrowLeft"], label: "previous point", run: () => timeline.stepPoint(-1) },
          { keys: ["PageDown"], label: "next operation", run: () => timeline.stepOperation(1) },
          { keys: ["PageUp"], label: "previous operation", run: () => timeline.stepOperation(-1) },
          { keys: ["Home"], label: "first point", run: () => this.jump(0) },
          { keys: ["End"], label: "last point", run: () => this.jump(this.data.program.count - 1) },
          { keys: ["+", "="], shown: "+", label: "faster", run: () => timeline.stepPace(1) },
          { keys: ["-"], shown: "−", label: "slower", run: () => timeline.stepPace(-1) },
        ],
      },
      {
        title: "View",
        commands: [
          { keys: ["f"], label: "fit the path", run: () => stage.fit(false) },
          { keys: ["Shift+f"], label: "fit the machine", run: () => stage.fit(true) },
          ...(Object.keys(STANDARD_VIEWS) as StandardView[]).map((name) => ({
            keys: [STANDARD_VIEWS[name].key],
            label: STANDARD_VIEWS[name].label.toLowerCase(),
            run: () => stage.look(name),
          })),
          { keys: ["8"], label: "along the tool axis", run: () => stage.lookAlongTool() },
          { keys: ["t"], label: "centre on the tool", run: () => stage.centreOnTool() },
          { keys: [","], label: "zoom out", run: () => stage.view.zoomBy(0.8) },
          { keys: ["."], label: "zoom in", run: () => stage.view.zoomBy(1.25) },
          { keys: ["i"], label: "orbit up", run: () => stage.view.orbitBy(0, 0.13) },
          { keys: ["k"], label: "orbit down", run: () => stage.view.orbitBy(0, -0.13) },
          { keys: ["j"], label: "orbit left", run: () => stage.view.orbitBy(-0.13, 0) },
          { keys: ["o"], label: "orbit right", run: () => stage.view.orbitBy(0.13, 0) },
          ...([["Shift+i", "up", 0, -1], ["Shift+k", "down", 0, 1], ["Shift+j", "left", 1, 0], ["Shift+o", "right", -1, 0]] as const).map(([key, name, x, y]) => ({
            keys: [key as string],
            label: `pan ${name}`,
            run: () => stage.view.panBy(40 * x, 40 * y),
          })),
        ],
      },
      {
        title: "Display",
        commands: [
          { keys: ["c"], label: "next colouring", run: () => this.nextColouring(1) },
          { keys: ["Shift+c"], label: "previous colouring", run: () => this.nextColouring(-1) },
          { keys: ["a"], label: "tool axis ticks", run: () => stage.layers.toggle("ticks") },
          { keys: ["l"], label: "axis arrows", run: () => stage.layers.toggle("arrows") },
          { keys: ["b"], label: "part or bed at rest", run: () => this.setFixed(cycle(["part", "machine"], stage.fixed)) },
          { keys: ["m"], label: "bodies: solid, clear, off", run: updated(() => stage.setMachineStyle(cycle(["solid", "ghost", "off"], stage.machineStyle))) },
          { keys: ["h"], label: "path: all, done, operation", run: updated(() => stage.setExtent(cycle(["whole", "done", "operation"], stage.extent))) },
          ...(this.data.simulation
            ? [
                { keys: ["g"], label: "stock: machined, as it is cut, none", run: () => this.setStock(cycle(["result", "cut", "off"], stage.simulated?.stock ?? "off")) },
                { keys: ["e"], label: "design", run: () => stage.layers.toggle("design") },
              ]
            : []),
          { keys: ["d"], label: "light or dark", run: () => this.theme.toggle() },
          { keys: ["s"], label: "summary", run: () => this.toggleSummary() },
        ],
      },
      {
        title: "Text and plots",
        commands: [
          { keys: ["/"], label: "search; :120 is line 120", run: () => this.text.searchField.focus() },
          { keys: ["n"], label: "next finding", run: () => this.findings.step(1, this.text.currentLine) },
          { keys: ["Shift+n"], label: "previous finding", run: () => this.findings.step(-1, this.text.currentLine) },
          ...(this.simulation
            ? [
                { keys: ["v"], label: "next finding of the simulation", run: () => this.simulation?.step(1) },
                { keys: ["Shift+v"], label: "previous finding of the simulation", run: () => this.simulation?.step(-1) },
              ]
            : []),
          { keys: ["p"], label: "next plots", run: () => this.plots.nextTab() },
          { keys: ["x"], label: "plots over time or blocks", run: () => this.plots.toggleAxis() },
          { keys: ["["], label: "plots: zoom in", run: () => this.plots.zoomBy(0.5) },
          { keys: ["]"], label: "plots: zoom out", run: () => this.plots.zoomBy(2) },
          { keys: ["\\"], label: "plots: all", run: () => this.plots.setZoom(null) },
        ],
      },
    ];
  }
}
