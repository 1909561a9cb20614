/** What one block is: its text, CL record, the reason for it, axis values. For the side panel and under the pointer. */

import type { Lines } from "../data/lines.ts";
import type { Program } from "../data/program.ts";
import { linesText, NOT_DRAWN, type Undrawn } from "../data/undrawn.ts";
import { element, fill } from "../dom.ts";
import { axisUnit, fixed, formatTime, formatValue } from "../format.ts";

export class BlockCard {
  readonly root: HTMLElement;

  constructor(
    private readonly program: Program,
    private readonly programText: Lines,
    private readonly clText: Lines | null,
    private readonly undrawn: Undrawn,
    /** The short form has no times and no operation. */
    private readonly short: boolean,
  ) {
    this.root = element("div", { class: short ? "block-card short" : "block-card" });
  }

  show(point: number): void {
    const { program } = this;
    const line = program.line[point];
    const facts: [string, Node | string][] = [];
    const record = this.clText?.line(program.clLine[point]).trim();
    if (program.clLine[point] > 0) {
      facts.push(["CL line", record ? textWith(String(program.clLine[point]), record) : String(program.clLine[point])]);
    }
    const reason = program.reasonText(point);
    if (reason !== null) facts.push(["Why", reason]);
    const motion = program.isStart(point) ? "first known position" : program.kindText(point);
    const hidden = this.undrawn.before(point);
    const feed = program.isRapid(point) || program.isStart(point) ? "" : `, ${formatValue(program.feed[point])} mm/min`;
    facts.push(["Motion", motion + feed]);
    if (hidden.length > 0) facts.push(["Before", `${linesText(hidden)} ${NOT_DRAWN}`]);
    if (this.short) {
      const axes = program.head.machine.joints.map((joint, i) => `${joint.letter} ${fixed(program.axes[i][point], 3)}${joint.rotary ? "°" : ""}`);
      facts.push(["Axes", axes.join("  ")]);
    } else {
      const operation = program.head.operations[program.operation[point]];
      if (operation) facts.push(["Operation", `${operation.number}. ${operation.name}${operation.mode ? ` (${operation.mode})` : ""}`]);
      const speeds = program.head.machine.joints.flatMap((joint, i) => {
        const speed = program.speeds[i][point];
        return Number.isFinite(speed) && speed > 0.05 ? [`${joint.letter} ${formatValue(speed)} ${axisUnit(joint)}/min`] : [];
      });
      if (speeds.length > 0) facts.push(["Axis speeds", speeds.join("  ")]);
      if (program.head.set_ups.length > 1) facts.push(["Set-up", program.setUpAt(point).name]);
      facts.push(["Time", formatTime(program.countedS[point])]);
    }
    if (Number.isFinite(program.errorUm[point])) {
      facts.push(["Path error", `${formatValue(program.errorUm[point])} µm of ${formatValue(program.head.tolerance_mm * 1000)}`]);
    } else if (program.isNotCompared(point)) {
      facts.push(["Path error", "not compared"]);
    }
    const list = element("dl", { class: "facts" });
    for (const [name, value] of facts) list.append(element("dt", {}, name), element("dd", {}, value));
    this.fill(line, list);
  }

  /** A line of the program without a point of its own. */
  showLine(line: number): void {
    const list = element("dl", { class: "facts" });
    list.append(element("dt", {}, "Motion"), element("dd", {}, this.undrawn.has(line) ? NOT_DRAWN : "none; the position is the last one before this line"));
    this.fill(line, list);
  }

  private fill(line: number, list: HTMLElement): void {
    for (const finding of this.program.head.findings) {
      if (line < finding.line || line > finding.last_line) continue;
      list.append(element("dt", { class: "bad" }, "Finding"), element("dd", {}, finding.text));
    }
    fill(
      this.root,
      element(
        "div",
        { class: "block-text" },
        element("span", { class: "line-number" }, String(line)),
        element("code", {}, this.programText.line(line) || "(empty line)"),
      ),
      list,
    );
  }
}

/** A number with the text of its record. */
function textWith(number: string, text: string): DocumentFragment {
  const fragment = document.createDocumentFragment();
  fragment.append(`${number}  `, element("code", {}, text));
  return fragment;
}
