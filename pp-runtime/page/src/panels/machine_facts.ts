/** The machine that the program was checked for: what someone compares with the real one, axis by axis. */

import type { Joint } from "../data/contract.ts";
import { Program } from "../data/program.ts";
import { linesText, NOT_DRAWN, type Undrawn } from "../data/undrawn.ts";
import { element, fill } from "../dom.ts";
import { axisUnit, fixed, formatValue, toolText } from "../format.ts";
import { bodyOf, centreLineText, lineDistance, motionText } from "../kinematics/words.ts";

export class MachinePanel {
  readonly root = element("section", { class: "panel", "aria-label": "Machine" });
  private readonly centreLines: { joint: number; node: HTMLElement }[] = [];
  private readonly placementText = element("p", { class: "note" });
  private placement = -1;

  constructor(
    private readonly program: Program,
    private readonly undrawn: Undrawn,
  ) {
    const { machine, control } = program.head;
    this.root.append(
      element("h2", {}, "Machine"),
      element("dl", { class: "facts" }, element("dt", {}, "Name"), element("dd", {}, machine.name), element("dt", {}, "Control"), element("dd", {}, control)),
      element("p", { class: "compare" }, "The check compares the program with the CL data for this machine. Compare every sign and every centre line with the real machine."),
      ...this.gaps(),
      element("h2", {}, "Axes from the workpiece to the tool"),
      element("ol", { class: "machine-axes" }, ...machine.joints.map((_, i) => element("li", {}, this.axis(i)))),
      this.placementText,
    );
  }

  /** Shows the centre lines of the set-up and tool at a position. */
  update(position: number): void {
    const index = this.program.placement[Math.floor(position)];
    if (index === this.placement) return;
    this.placement = index;
    const placement = this.program.head.placements[index];
    const { machine, set_ups } = this.program.head;
    const rotary = machine.joints.flatMap((joint, i) => (joint.rotary ? [i] : []));
    const line = (i: number): { direction: Joint["direction"]; point: Joint["point"] } => ({ direction: machine.joints[i].direction, point: placement.points[i] });
    for (const { joint, node } of this.centreLines) {
      const next = rotary[rotary.indexOf(joint) + 1];
      // Between table and head are linear axes: only centre lines on one side keep their distance.
      const distance = next === undefined || bodyOf(machine, joint) !== bodyOf(machine, next) ? "" : `; ${fixed(lineDistance(line(joint), line(next)), 3)} mm from the centre line of ${machine.joints[next].letter}`;
      fill(node, `${centreLineText(machine.joints[joint].direction, placement.points[joint])}${distance}`);
    }
    const setUp = set_ups[placement.set_up];
    this.placementText.textContent = `Directions and centre lines with all axes at zero; centre lines in mm from the workpiece origin${setUp ? ` of ${setUp.name}` : ""}, tool ${toolText(this.program.toolOfNumber(placement.tool))}.`;
  }

  private gaps(): HTMLElement[] {
    const { lines } = this.undrawn;
    return lines.length === 0 ? [] : [element("p", { class: "compare" }, `${linesText(lines)} ${NOT_DRAWN}`)];
  }

  private axis(index: number): HTMLElement {
    const { program } = this;
    const { machine } = program.head;
    const joint = machine.joints[index];
    const unit = axisUnit(joint);
    const side = bodyOf(machine, index);
    const facts: [string, string | HTMLElement][] = [];
    if (joint.held) facts.push(["Held", `at ${fixed(program.axes[index][0], 3)} ${unit}`]);
    if (joint.rotary) {
      const node = element("span");
      this.centreLines.push({ joint: index, node });
      facts.push(["Centre line", node]);
    }
    const limits = joint.min === null && joint.max === null ? "none configured" : `${text(joint.min)} … ${text(joint.max)} ${unit}${joint.rotary ? "" : ", machine coordinates"}`;
    facts.push(["Limits", limits], ["Speed", joint.speed === null ? "none configured" : `${formatValue(joint.speed)} ${unit}/min`]);
    const list = element("dl", { class: "facts" });
    for (const [name, value] of facts) list.append(element("dt", {}, name), element("dd", {}, value));
    return element(
      "div",
      { class: `machine-axis ${side}${joint.held ? " held" : ""}` },
      element("p", { class: "axis-title" }, element("strong", {}, joint.letter), ` ${joint.rotary ? "rotary" : "linear"}, ${side} side${joint.held ? ", held" : ""}`),
      element("p", { class: "axis-motion" }, motionText(machine, index)),
      list,
    );
  }
}

const text = (limit: number | null): string => (limit === null ? "unlimited" : formatValue(limit));
