/** Findings, operations and marks as places to jump to. */

import { categoryColour, cssColour, type Theme } from "../colour/scale.ts";
import type { MarkKind, Program } from "../data/program.ts";
import { element, fill } from "../dom.ts";
import { formatTime } from "../format.ts";
import { MARKS } from "../scene/marks.ts";

export interface ListEvents {
  seek: (point: number) => void;
  /** Goes to a line, which may have no point. */
  showLine: (line: number) => void;
}

/** Longest list of marks of one kind. */
const MOST_ENTRIES = 200;

export class FindingsPanel {
  readonly root = element("section", { class: "panel", id: "findings", "aria-label": "Findings and marks" });

  constructor(
    private readonly program: Program,
    private readonly events: ListEvents,
  ) {
    const { findings, warnings } = program.head;
    this.root.append(element("h2", {}, findings.length === 0 ? "Findings" : `Findings (${findings.length})`));
    if (findings.length === 0) {
      this.root.append(element("p", { class: "good" }, "The check found nothing: the program agrees with its CL data, for the machine of the tab Machine."));
    } else {
      this.root.append(element("ol", { class: "entries" }, ...findings.map((_, i) => element("li", {}, this.finding(i)))));
    }
    if (warnings.length > 0) {
      this.root.append(
        element("h2", {}, `Warnings (${warnings.length})`),
        element("ul", { class: "warnings" }, ...warnings.map((text) => element("li", {}, text))),
      );
    }
    for (const kind of ["rewind", "retract", "pole"] as MarkKind[]) this.addMarks(kind);
  }

  /** Goes to the next or previous finding, seen from a line. */
  step(by: 1 | -1, from: number): void {
    const lines = this.program.head.findings.map((finding) => finding.line).sort((a, b) => a - b);
    const next = by === 1 ? lines.find((line) => line > from) : lines.findLast((line) => line < from);
    const line = next ?? (by === 1 ? lines[0] : lines.at(-1));
    if (line !== undefined) this.events.showLine(line);
  }

  private finding(index: number): HTMLElement {
    const finding = this.program.head.findings[index];
    const lines = finding.last_line > finding.line ? `lines ${finding.line} to ${finding.last_line}` : `line ${finding.line}`;
    const entry = element(
      "button",
      { type: "button", class: "entry" },
      element("span", { class: "place" }, element("span", { class: "mark mark-finding" }), `${lines}, CL line ${finding.cl_line}`),
      element("span", { class: "text" }, finding.text),
    );
    if (finding.help !== null) entry.append(element("span", { class: "help" }, finding.help));
    entry.addEventListener("click", () => this.events.showLine(finding.line));
    return entry;
  }

  private addMarks(kind: MarkKind): void {
    const stretches = this.program.stretches.filter((stretch) => stretch.kind === kind);
    if (stretches.length === 0) return;
    const { label } = MARKS[kind];
    const entries = stretches.slice(0, MOST_ENTRIES).map((stretch) => {
      const from = this.program.line[stretch.first];
      const to = this.program.line[stretch.last];
      const entry = element(
        "button",
        { type: "button", class: "entry one-line" },
        element("span", { class: `mark mark-${kind}` }),
        from === to ? `line ${from}` : `lines ${from} to ${to}`,
        element("span", { class: "when" }, formatTime(this.program.countedS[stretch.first])),
      );
      entry.addEventListener("click", () => this.events.seek(stretch.first));
      return element("li", {}, entry);
    });
    const more = stretches.length > MOST_ENTRIES ? element("p", { class: "note" }, `and ${stretches.length - MOST_ENTRIES} more`) : "";
    this.root.append(
      element(
        "details",
        {},
        element("summary", {}, `${label.charAt(0).toUpperCase()}${label.slice(1)} (${stretches.length})`),
        element("ol", { class: "entries" }, ...entries),
        more,
      ),
    );
  }
}

export class OperationsPanel {
  readonly root = element("section", { class: "panel", "aria-label": "Operations" });
  private readonly list = element("ol", { class: "entries" });
  private current = -1;

  constructor(
    private readonly program: Program,
    private readonly events: ListEvents,
    theme: Theme,
  ) {
    this.root.append(element("h2", {}, "Operations"), this.list);
    this.restyle(theme);
  }

  restyle(theme: Theme): void {
    fill(this.list, ...this.program.head.operations.map((_, i) => element("li", {}, this.operation(i, theme))));
    this.mark();
  }

  update(point: number): void {
    const operation = this.program.operation[point];
    if (operation === this.current) return;
    this.current = operation;
    this.mark();
  }

  private mark(): void {
    [...this.list.children].forEach((item, i) => {
      const entry = item.firstElementChild;
      if (i === this.current) entry?.setAttribute("aria-current", "true");
      else entry?.removeAttribute("aria-current");
    });
  }

  private operation(index: number, theme: Theme): HTMLElement {
    const { operations, set_ups } = this.program.head;
    const operation = operations[index];
    const sample = element("span", { class: "sample" });
    sample.style.setProperty("--sample", cssColour(categoryColour(index, theme)));
    const facts = [`T${operation.tool}`, operation.mode, set_ups.length > 1 ? (set_ups[operation.set_up]?.name ?? "") : "", formatTime(operation.seconds)];
    const entry = element(
      "button",
      { type: "button", class: "entry" },
      element("span", { class: "place" }, sample, `${operation.number}. ${operation.name}`),
      element("span", { class: "help" }, facts.filter((fact) => fact !== "").join(" · ")),
    );
    entry.disabled = operation.points === 0;
    entry.addEventListener("click", () => this.events.seek(operation.first_point));
    return entry;
  }
}
