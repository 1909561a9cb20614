/** The program text: only the lines in sight are elements, so its length does not matter. */

import type { Finding } from "../data/contract.ts";
import { tokens, type Lines } from "../data/lines.ts";
import { lowerBound, type MarkKind, type Program } from "../data/program.ts";
import { element } from "../dom.ts";
import { MARKS } from "../scene/marks.ts";
import { styleColour } from "../theme.ts";

/** Height of a line, px; also in the style sheet. */
const LINE_PX = 20;

/** Tallest element that every browser can scroll, px. */
const TALLEST_PX = 8_000_000;

export interface TextPaneEvents {
  select: (line: number) => void;
  hover: (line: number | null) => void;
}

export class TextPane {
  readonly root = element("section", { class: "text-pane", "aria-label": "Program text" });
  readonly searchField = element("input", {
    type: "search",
    id: "search",
    placeholder: "Search (/)",
    "aria-label": "Search the program",
    autocomplete: "off",
    spellcheck: "false",
  });
  private readonly found = element("span", { class: "found", role: "status" });
  private readonly scroller = element("div", {
    id: "program",
    class: "program",
    tabindex: "0",
    role: "listbox",
    "aria-label": "Lines of the program",
  });
  private readonly spacer = element("div", { class: "spacer" });
  private readonly rows = element("div", { class: "rows", role: "presentation" });
  private readonly ruler = element("canvas", { class: "ruler", "aria-hidden": "true" });
  private readonly marks = new Map<number, Set<MarkKind>>();
  private readonly findings: Finding[];
  private readonly insertedTexts = new Map<number, string>();
  private readonly digits: number;
  private readonly control: string;
  private matches: number[] = [];
  private current = 0;
  private hovered = 0;
  private rowsShown = "";

  constructor(
    private readonly lines: Lines,
    program: Program,
    private readonly events: TextPaneEvents,
  ) {
    this.control = program.head.control;
    this.findings = program.head.findings;
    this.digits = String(lines.count).length;
    this.collectMarks(program);
    this.spacer.style.height = `${this.heightPx}px`;
    // As wide as the longest line, so that the scroll bar does not change with the lines in sight.
    this.spacer.style.minWidth = `calc(${lines.longest + this.digits}ch + 50px)`;
    this.spacer.append(this.rows);
    this.scroller.append(this.spacer);
    const previous = element("button", { type: "button", class: "small", "aria-label": "Previous match", title: "Previous match (Shift+Enter)" }, "↑");
    const next = element("button", { type: "button", class: "small", "aria-label": "Next match", title: "Next match (Enter)" }, "↓");
    previous.addEventListener("click", () => this.nextMatch(-1));
    next.addEventListener("click", () => this.nextMatch(1));
    const title = element("h2", {}, program.head.program);
    title.title = program.head.program;
    this.root.append(
      element("header", {}, title, element("div", { class: "search" }, this.searchField, this.found, previous, next)),
      element("div", { class: "text-body" }, this.scroller, this.ruler),
    );
    this.listen();
    new ResizeObserver(() => {
      this.render();
      this.drawRuler();
    }).observe(this.scroller);
  }

  /** Marks the line of the block under way, and brings it into sight where that is wanted. */
  setCurrent(line: number, inSight = true): void {
    if (line === this.current) return;
    this.current = line;
    if (inSight) this.reveal(line);
    this.render();
    this.drawRuler();
  }

  get currentLine(): number {
    return this.current;
  }

  setHover(line: number | null): void {
    if ((line ?? 0) === this.hovered) return;
    this.hovered = line ?? 0;
    this.render();
  }

  restyle(): void {
    this.drawRuler();
  }

  /** Goes to the next or previous line that matches the search, seen from the current line. */
  nextMatch(by: 1 | -1): void {
    if (this.matches.length === 0) return;
    const at = lowerBound(this.matches, by === 1 ? this.current + 1 : this.current) + (by === 1 ? 0 : -1);
    const index = (at + this.matches.length) % this.matches.length;
    this.found.textContent = `${index + 1} / ${this.matches.length}`;
    const line = this.matches[index];
    this.events.select(line);
    // A line that is no block (a comment) does not become current.
    this.reveal(line);
    this.current = line;
    this.render();
    this.drawRuler();
  }

  private get heightPx(): number {
    return Math.min(this.lines.count * LINE_PX, TALLEST_PX);
  }

  /** Line at the top of the pane, with a fraction. */
  private get topLine(): number {
    const scrollable = this.heightPx - this.scroller.clientHeight;
    if (this.heightPx === this.lines.count * LINE_PX || scrollable <= 0) return this.scroller.scrollTop / LINE_PX;
    const hidden = this.lines.count - this.scroller.clientHeight / LINE_PX;
    return (this.scroller.scrollTop / scrollable) * hidden;
  }

  private reveal(line: number): void {
    const inSight = this.scroller.clientHeight / LINE_PX;
    const top = this.topLine;
    if (line - 1 >= top + 2 && line <= top + inSight - 3) return;
    const wanted = Math.min(Math.max(line - 1 - inSight * 0.4, 0), Math.max(this.lines.count - inSight, 0));
    const exact = this.heightPx === this.lines.count * LINE_PX;
    const hidden = Math.max(this.lines.count - inSight, 1e-9);
    this.scroller.scrollTop = exact ? wanted * LINE_PX : (wanted / hidden) * (this.heightPx - this.scroller.clientHeight);
  }

  private render(): void {
    const top = this.topLine;
    const first = Math.max(1, Math.floor(top) - 5);
    const last = Math.min(this.lines.count, Math.ceil(top + this.scroller.clientHeight / LINE_PX) + 5);
    const key = `${first} ${last} ${this.current} ${this.hovered} ${this.searchField.value} ${top === Math.floor(top) ? "" : top.toFixed(2)}`;
    if (key === this.rowsShown) return;
    this.rowsShown = key;
    const shift = this.scroller.scrollTop - (top - (first - 1)) * LINE_PX;
    this.rows.style.transform = `translateY(${shift.toFixed(1)}px)`;
    const rows: HTMLElement[] = [];
    for (let line = first; line <= last; line += 1) rows.push(this.row(line));
    this.rows.replaceChildren(...rows);
    this.scroller.setAttribute("aria-activedescendant", `line-${this.current}`);
  }

  private row(line: number): HTMLElement {
    const row = element("div", { class: "line", role: "option", id: `line-${line}`, "data-line": line, "aria-selected": String(line === this.current) });
    if (line === this.current) row.setAttribute("aria-current", "true");
    if (line === this.hovered) row.classList.add("hovered");
    const gutter = element("span", { class: "gutter" });
    for (const kind of this.marks.get(line) ?? []) gutter.append(element("span", { class: `mark mark-${kind}`, title: kind === "inserted" ? (this.insertedTexts.get(line) ?? MARKS.inserted.label) : MARKS[kind].label }));
    const number = element("span", { class: "line-number" }, String(line).padStart(this.digits));
    const text = element("span", { class: "code" });
    const source = this.lines.line(line);
    const wanted = this.searchField.value;
    for (const token of tokens(source, this.control)) {
      text.append(token.kind === "word" ? highlighted(token.text, wanted) : element("span", { class: `token-${token.kind}` }, highlighted(token.text, wanted)));
    }
    const found = this.findings.filter((finding) => line >= finding.line && line <= finding.last_line);
    if (found.length > 0) {
      row.title = found.map((finding) => finding.text).join("\n");
      row.classList.add("has-finding");
      if (found.some((finding) => finding.line === line)) gutter.prepend(element("span", { class: "mark mark-finding", title: MARKS.finding.label }));
    }
    row.append(gutter, number, text);
    return row;
  }

  private collectMarks(program: Program): void {
    const mark = (line: number, kind: MarkKind): void => {
      const set = this.marks.get(line) ?? new Set();
      set.add(kind);
      this.marks.set(line, set);
    };
    for (const { kind, first, last } of program.stretches) {
      for (let block = program.block[first]; block <= program.block[last]; block += 1) {
        const line = program.line[program.blockFirst[block]];
        mark(line, kind);
        if (kind === "inserted") this.insertedTexts.set(line, `inserted block: ${program.reasonText(program.blockFirst[block]) ?? "reason unknown"}`);
      }
    }
  }

  /** Marks of the whole program beside the scroll bar. */
  private drawRuler(): void {
    const { clientWidth: width, clientHeight: height } = this.ruler;
    if (width === 0 || height === 0) return;
    const ratio = devicePixelRatio;
    this.ruler.width = width * ratio;
    this.ruler.height = height * ratio;
    const context = this.ruler.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    const y = (line: number): number => ((line - 0.5) / this.lines.count) * height;
    const order: MarkKind[] = ["pole", "retract", "rewind"];
    for (const kind of order) {
      context.fillStyle = styleColour(MARKS[kind].colour);
      for (const [line, kinds] of this.marks) if (kinds.has(kind)) context.fillRect(2, y(line) - 1, width, 2);
    }
    context.fillStyle = styleColour(MARKS.finding.colour);
    for (const { line, last_line } of this.findings) {
      const top = y(line - 0.5);
      context.fillRect(0, top, width, Math.max(y(last_line + 0.5) - top, 4));
    }
    context.fillStyle = styleColour("--accent");
    context.fillRect(0, y(this.current) - 1, width, 2.5);
  }

  private listen(): void {
    const lineOf = (event: Event): number | null => {
      const row = (event.target as Element).closest<HTMLElement>("[data-line]");
      return row ? Number(row.dataset.line) : null;
    };
    this.scroller.addEventListener("scroll", () => this.render(), { passive: true });
    this.scroller.addEventListener("click", (event) => {
      const line = lineOf(event);
      if (line !== null && getSelection()?.isCollapsed !== false) this.events.select(line);
    });
    this.scroller.addEventListener("pointerover", (event) => this.events.hover(lineOf(event)));
    this.scroller.addEventListener("pointerleave", () => this.events.hover(null));
    this.scroller.addEventListener("keydown", (event) => {
      const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
      if (step === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      event.stopPropagation();
      const line = Math.min(Math.max(this.current + step, 1), this.lines.count);
      this.events.select(line);
      this.current = line;
      this.reveal(line);
      this.render();
      this.drawRuler();
    });
    this.ruler.addEventListener("click", (event) => {
      this.events.select(Math.max(1, Math.ceil((event.offsetY / this.ruler.clientHeight) * this.lines.count)));
    });
    let pending = 0;
    this.searchField.addEventListener("input", () => {
      clearTimeout(pending);
      pending = window.setTimeout(() => this.search(), 150);
    });
    this.searchField.addEventListener("keydown", (event) => {
      if (event.key === "Enter") {
        event.preventDefault();
        clearTimeout(pending);
        this.search();
        this.nextMatch(event.shiftKey ? -1 : 1);
      } else if (event.key === "Escape") {
        this.searchField.value = "";
        this.search();
        this.scroller.focus();
      }
    });
  }

  private search(): void {
    const wanted = this.searchField.value;
    // A number with a colon in front is a line.
    const line = /^:(\d+)$/.exec(wanted);
    this.matches = line ? [Math.min(Math.max(Number(line[1]), 1), this.lines.count)] : this.lines.search(wanted);
    this.found.textContent = wanted === "" ? "" : this.matches.length === 0 ? "none" : String(this.matches.length);
    this.render();
  }
}

/** Text in which every place of `wanted` is marked. */
function highlighted(text: string, wanted: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  const needle = wanted.toLowerCase();
  const lower = text.toLowerCase();
  let from = 0;
  if (needle !== "" && lower.length === text.length) {
    for (let at = lower.indexOf(needle); at >= 0; at = lower.indexOf(needle, from)) {
      fragment.append(text.slice(from, at), element("mark", {}, text.slice(at, at + needle.length)));
      from = at + needle.length;
    }
  }
  fragment.append(text.slice(from));
  return fragment;
}
