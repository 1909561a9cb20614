/** The position display: axis values as on the control, their limits, and the tip on the workpiece. */

import type { ClPoints } from "../data/cl_point.ts";
import { Program } from "../data/program.ts";
import { element, fill } from "../dom.ts";
import { axisUnit, fixed, formatValue, toolText } from "../format.ts";
import { cross, dot, length, subtract } from "../kinematics/vector.ts";
import type { Stage } from "../scene/stage.ts";
import type { Timeline } from "../timeline.ts";

interface AxisRow {
  value: HTMLElement;
  bar: HTMLElement;
  row: HTMLElement;
  limits: HTMLElement;
}

export class PositionPanel {
  readonly root = element("section", { class: "panel position", "aria-label": "Position" });
  private readonly rows: AxisRow[];
  private placement = -1;
  private readonly tip = element("dd");
  private readonly axis = element("dd");
  private readonly cl = element("dl", { class: "facts cl-point" });
  private readonly feed = element("dd");
  private readonly tool = element("dd");

  constructor(
    private readonly program: Program,
    private readonly timeline: Timeline,
    private readonly stage: Stage,
    private readonly clPoints: ClPoints,
  ) {
    const { joints, frame_after } = program.head.machine;
    this.rows = joints.map((joint, i) => this.row(i, i < frame_after ? "table" : "head", joint.held));
    this.root.append(
      element("h2", {}, "axis values (from the zero position)"),
      element("div", { class: "axes" }, ...this.rows.map((row) => row.row)),
      element(
        "dl",
        { class: "facts" },
        element("dt", {}, "tip on the part"),
        this.tip,
        element("dt", {}, "Tool axis"),
        this.axis,
        element("dt", {}, "Feed"),
        this.feed,
        element("dt", {}, "Tool"),
        this.tool,
      ),
      this.cl,
    );
    this.cl.hidden = !clPoints.comparable;
    fill(this.cl, ...["CL point", "difference", "CL tool axis", "difference"].flatMap((name) => [element("dt", {}, name), element("dd", {}, "–")]));
  }

  update(): void {
    const { program, timeline } = this;
    const axes = program.axesBetween(timeline.position);
    const placement = program.placement[Math.floor(timeline.position)];
    program.head.machine.joints.forEach((joint, i) => {
      const { value, bar, row, limits } = this.rows[i];
      const [min, max] = program.limits(i, placement);
      if (placement !== this.placement) {
        limits.textContent = joint.held ? "held" : limitsText(min, max, joint.min !== null || joint.max !== null);
        bar.parentElement?.toggleAttribute("hidden", min === null || max === null);
      }
      value.textContent = fixed(axes[i], 3);
      row.classList.toggle("outside", (min !== null && axes[i] < min - 1e-6) || (max !== null && axes[i] > max + 1e-6));
      if (min !== null && max !== null) {
        const share = (axes[i] - min) / (max - min || 1);
        bar.style.left = `${(100 * Math.min(Math.max(share, 0), 1)).toFixed(2)}%`;
      }
    });
    this.placement = placement;
    const point = timeline.point;
    this.tip.textContent = this.stage.machine.drawnTip().map((value) => fixed(value, 3)).join("  ");
    this.axis.textContent = this.stage.machine.drawnToolAxis().map((value) => fixed(value, 4)).join("  ");
    this.showClPoint();
    this.feed.textContent = program.isStart(point)
      ? "–"
      : program.isRapid(point)
        ? "rapid"
        : `${formatValue(program.feed[point])} mm/min`;
    const tool = program.toolAt(Math.floor(timeline.position));
    this.tool.textContent = toolText(tool);
  }

  /** The point of the CL record, where the position is at it, and how far the drawn tip is from it. */
  private showClPoint(): void {
    const { point, position } = this.timeline;
    const programmed = position === point ? this.clPoints.at(point) : null;
    // Its room stays, so that what is below does not jump from block to block.
    this.cl.style.visibility = programmed === null ? "hidden" : "visible";
    if (programmed === null) return;
    const { machine } = this.stage;
    const tolerance = this.program.head.tolerance_mm;
    const difference = length(subtract(machine.drawnTip(), programmed.tip));
    const entries: [string, HTMLElement][] = [
      ["CL point", element("dd", {}, programmed.tip.map((value) => fixed(value, 3)).join("  "))],
      ["difference", element("dd", difference > tolerance ? { class: "bad" } : {}, `${fixed(difference, 4)} mm of ${formatValue(tolerance)}`)],
    ];
    if (programmed.axis !== null) {
      const drawn = machine.drawnToolAxis();
      const degrees = (Math.atan2(length(cross(drawn, programmed.axis)), dot(drawn, programmed.axis)) * 180) / Math.PI;
      entries.push(["CL tool axis", element("dd", {}, programmed.axis.map((value) => fixed(value, 4)).join("  "))], ["difference", element("dd", {}, `${fixed(degrees, 4)}°`)]);
    }
    fill(this.cl, ...entries.flatMap(([name, value]) => [element("dt", {}, name), value]));
  }

  private row(index: number, side: string, held: boolean): AxisRow {
    const joint = this.program.head.machine.joints[index];
    const value = element("span", { class: "value" });
    const bar = element("span", { class: "needle" });
    const limits = element("span", { class: "limits" });
    const row = element(
      "div",
      { class: `axis ${side}${held ? " held" : ""}` },
      element("span", { class: "letter" }, joint.letter),
      value,
      element("span", { class: "unit" }, axisUnit(joint)),
      element("span", { class: "travel" }, element("span", { class: "track" }, bar), limits),
    );
    return { value, bar, row, limits };
  }
}

function limitsText(min: number | null, max: number | null, configured: boolean): string {
  if (min === null && max === null) return configured ? "limits unknown: no machine zero" : "no limits";
  return `${min === null ? "" : formatValue(min)} … ${max === null ? "" : formatValue(max)}`;
}
