/** Play, pause, steps, pace and the slider over the machining time, with a strip of operations and marks. */

import { categoryColour, cssColour, type Theme } from "../colour/scale.ts";
import type { Program } from "../data/program.ts";
import { button, element, icon } from "../dom.ts";
import { formatTime } from "../format.ts";
import { MARKS, markedPoints } from "../scene/marks.ts";
import { styleColour } from "../theme.ts";
import { PACES, type Timeline } from "../timeline.ts";

const ICONS = {
  play: "M6 4.5v11l9-5.5z",
  pause: "M6 4.5h2.5v11H6zM11.5 4.5H14v11h-2.5z",
  next: "M5 5v10l6-5zM13.5 5v10",
  previous: "M15 5v10l-6-5zM6.5 5v10",
  start: "M15.5 5v10l-5-5zM9.5 5v10l-5-5zM3.5 5v10",
  end: "M4.5 5v10l5-5zM10.5 5v10l5-5zM16.5 5v10",
};

export class Transport {
  readonly root = element("section", { class: "transport", "aria-label": "Playback" });
  private readonly playButton: HTMLButtonElement;
  private readonly scrub = element("input", { type: "range", id: "scrub", min: "0", step: "any", "aria-label": "Machining time" });
  private readonly pace = element("select", { id: "pace", "aria-label": "Speed of playback", title: "Speed of playback (+ and −)" });
  private readonly time = element("output", { class: "time" });
  private readonly strip = element("canvas", { class: "strip", "aria-hidden": "true" });

  constructor(
    private readonly program: Program,
    private readonly timeline: Timeline,
    private theme: Theme,
  ) {
    const press = (label: string, path: string, key: string, act: () => void): HTMLButtonElement =>
      button({ label, icon: icon(path), key, press: act });
    this.playButton = press("Play", ICONS.play, "Space", () => timeline.toggle());
    this.playButton.id = "play";
    this.playButton.classList.add("primary");
    const total = program.totalS;
    this.scrub.max = String(total > 0 ? total : 1);
    for (const value of PACES) this.pace.append(element("option", { value: String(value) }, `${value}×`));
    this.root.append(
      element(
        "div",
        { class: "buttons", role: "group", "aria-label": "Steps" },
        press("First point", ICONS.start, "Home", () => timeline.seek(0)),
        press("Previous block", ICONS.previous, "←", () => timeline.stepBlock(-1)),
        this.playButton,
        press("Next block", ICONS.next, "→", () => timeline.stepBlock(1)),
        press("Last point", ICONS.end, "End", () => timeline.seek(program.count - 1)),
      ),
      this.pace,
      element("div", { class: "scrubber" }, this.strip, this.scrub),
      this.time,
    );
    this.scrub.addEventListener("input", () => {
      // Pausing puts the slider back to where the program is: the wanted time is read first.
      const wantedS = Number(this.scrub.value);
      timeline.pause();
      timeline.seekTime(wantedS);
    });
    this.pace.addEventListener("change", () => timeline.setPace(Number(this.pace.value)));
    timeline.onChange(() => this.update());
    new ResizeObserver(() => this.drawStrip()).observe(this.strip);
    if (program.hasUnknownTimes) this.time.title = "Rapids of axes without a configured speed are played at 10 m/min and 3600 °/min, and not counted";
    this.update();
  }

  restyle(theme: Theme): void {
    this.theme = theme;
    this.drawStrip();
  }

  private update(): void {
    const { timeline, program } = this;
    const now = timeline.timeS;
    this.scrub.value = String(now);
    const { counted, total } = { counted: program.countedS[timeline.point], total: program.countedS[program.count - 1] };
    this.time.textContent = `${formatTime(counted)} / ${formatTime(total)}`;
    this.scrub.setAttribute("aria-valuetext", `${formatTime(counted)} of ${formatTime(total)}, line ${program.line[timeline.point]}`);
    this.pace.value = String(timeline.pace);
    const label = timeline.playing ? "Pause" : "Play";
    if (this.playButton.getAttribute("aria-label") !== label) {
      this.playButton.setAttribute("aria-label", label);
      this.playButton.title = `${label} (Space)`;
      this.playButton.replaceChildren(icon(timeline.playing ? ICONS.pause : ICONS.play));
    }
  }

  private drawStrip(): void {
    const { clientWidth: width, clientHeight: height } = this.strip;
    if (width === 0) return;
    const ratio = devicePixelRatio;
    this.strip.width = width * ratio;
    this.strip.height = height * ratio;
    const context = this.strip.getContext("2d");
    if (!context) return;
    context.scale(ratio, ratio);
    const { program } = this;
    const x = (point: number): number => (program.timeS[Math.min(Math.max(point, 0), program.count - 1)] / (program.totalS || 1)) * width;
    program.head.operations.forEach((operation, i) => {
      if (operation.points === 0) return;
      const from = x(operation.first_point - 1);
      const to = x(operation.first_point + operation.points - 1);
      context.fillStyle = cssColour(categoryColour(i, this.theme));
      context.fillRect(from, height - 4, Math.max(to - from - 1, 1), 4);
    });
    for (const kind of ["pole", "retract", "rewind"] as const) {
      context.fillStyle = styleColour(MARKS[kind].colour);
      for (const point of markedPoints(program, kind)) context.fillRect(x(point) - 1, 2, 2, height - 7);
    }
    context.fillStyle = styleColour(MARKS.finding.colour);
    for (const finding of program.head.findings) {
      for (const { first, last } of program.findingStretches(finding)) {
        const from = x(first - 1);
        const wide = Math.max(x(last) - from, 3);
        context.fillRect(Math.min(from, width - wide), 0, wide, height - 5);
      }
    }
  }
}
