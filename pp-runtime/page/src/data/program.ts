/**
 * The executed program: one point for the end of each leg (a block, or a chord of it), and what follows from the
 * points.
 *
 * A *point* is an index in all columns. A *block* is a run of points with the same line. A *position* is a fractional
 * point: 12.25 is a quarter of the leg from point 12 to point 13.
 */

import type { Finding, Head, Placement, SetUp, Tool, Triple } from "./contract.ts";
import { poleMeasure } from "../kinematics/chain.ts";

/** Sine of the angle from the pole below which a rotating leg counts as near the pole: 1°. */
const NEAR_POLE = Math.sin(Math.PI / 180);

/** Reason of a point whose reason is not known. */
const NO_REASON = 255;

/** Speeds at which a rapid is played whose time is unknown: mm/s and degrees/s. */
const ASSUMED_MM_PER_S = 10_000 / 60;
const ASSUMED_DEGREES_PER_S = 3600 / 60;

const NO_TOOL: Tool = {
  number: 0,
  name: "",
  kind: "unknown",
  diameter: null,
  corner_radius: null,
  length: null,
  flute_length: null,
  gauge_length: null,
  profile: null,
  first_point: 0,
  points: 0,
  seconds: 0,
};

/** Why a stretch of the path is marked. */
export type MarkKind = "rewind" | "pole" | "retract" | "inserted";

/** A stretch of points, first and last included. */
export interface Stretch {
  kind: MarkKind;
  first: number;
  last: number;
}

const MARK_OF_REASON: Record<string, MarkKind> = {
  rewind: "rewind",
  course: "pole",
  "lead-out": "retract",
  tolerance: "inserted",
  corner: "inserted",
};

export class Program {
  readonly count: number;
  /** Axis values in chain order, mm or degrees. */
  readonly axes: Float64Array[];
  readonly tip: [Float64Array, Float64Array, Float64Array];
  readonly toolAxis: [Float64Array, Float64Array, Float64Array];
  readonly line: Float64Array;
  readonly clLine: Float64Array;
  readonly kind: Float64Array;
  readonly reason: Float64Array;
  readonly operation: Float64Array;
  readonly placement: Float64Array;
  /** mm/min, 0 at rapid. */
  readonly feed: Float64Array;
  readonly legSeconds: Float64Array;
  /** Deviation of the tip from the CL path in µm; NaN where unknown. */
  readonly errorUm: Float64Array;
  /**
   * Time at the end of each leg as it is played, s: the machining time and rapids of unknown time at an assumed speed.
   */
  readonly timeS: Float64Array;
  /** Machining time at the end of each leg, s; rapids of unknown time are not in it. */
  readonly countedS: Float64Array;
  /** Whether the program has rapids of unknown time. */
  readonly hasUnknownTimes: boolean;
  /** Block of each point, counted from 0. */
  readonly block: Uint32Array;
  /** First point of each block, and the number of points at the end. */
  readonly blockFirst: Uint32Array;
  /** Block with the share of it that is done: the x axis of plots over blocks. */
  readonly blockShare: Float64Array;
  /** Axis speeds of each leg, mm/min or degrees/min; NaN where a leg takes no time or is not drawn. */
  readonly speeds: Float64Array[];
  readonly stretches: Stretch[];

  private readonly findingRuns = new Map<Finding, { first: number; last: number }[]>();
  private readonly startKind: number;
  private readonly rapidKind: number;

  constructor(
    readonly head: Head,
    columns: Map<string, Float64Array>,
  ) {
    const column = (name: string): Float64Array => {
      const values = columns.get(name);
      if (!values) throw new Error(`the page has no column \`${name}\``);
      return values;
    };
    this.count = head.points;
    this.axes = head.machine.joints.map((joint) => column(`axis.${joint.letter}`));
    this.tip = [column("tip.x"), column("tip.y"), column("tip.z")];
    this.toolAxis = [column("tool.i"), column("tool.j"), column("tool.k")];
    this.line = column("line");
    this.clLine = column("cl_line");
    this.kind = column("kind");
    this.reason = column("reason");
    this.operation = column("operation");
    this.placement = column("placement");
    this.feed = column("feed");
    this.legSeconds = column("seconds");
    this.errorUm = column("error");
    this.startKind = head.kinds.indexOf("start");
    this.rapidKind = head.kinds.indexOf("rapid");

    [this.timeS, this.countedS] = this.accumulateTime();
    this.hasUnknownTimes = this.legSeconds.some((seconds, i) => Number.isNaN(seconds) && !this.isStart(i));
    [this.block, this.blockFirst] = this.divideIntoBlocks();
    this.blockShare = this.shareOfBlocks();
    this.speeds = this.axes.map((values) => this.speedOf(values));
    this.stretches = this.findStretches();
  }

  /** Whether nothing is known of the motion to this point. */
  isStart(point: number): boolean {
    return point === 0 || this.kind[point] === this.startKind;
  }

  isRapid(point: number): boolean {
    return this.kind[point] === this.rapidKind;
  }

  get blocks(): number {
    return this.blockFirst.length - 1;
  }

  get totalS(): number {
    return this.count === 0 ? 0 : this.timeS[this.count - 1];
  }

  tipAt(point: number): Triple {
    return [this.tip[0][point], this.tip[1][point], this.tip[2][point]];
  }

  axesAt(point: number): number[] {
    return this.axes.map((values) => values[point]);
  }

  /** Axis values at a position: linear between two points, held where the motion between them is not known. */
  axesBetween(position: number): number[] {
    const before = Math.floor(position);
    const after = Math.min(before + 1, this.count - 1);
    const share = position - before;
    if (share === 0 || after === before || this.isStart(after)) return this.axesAt(before);
    return this.axes.map((values) => values[before] + share * (values[after] - values[before]));
  }

  /** Time at a position, s. */
  timeAt(position: number): number {
    const before = Math.floor(position);
    const after = Math.min(before + 1, this.count - 1);
    return this.timeS[before] + (position - before) * (this.timeS[after] - this.timeS[before]);
  }

  /** Position at a time, s. */
  positionAt(seconds: number): number {
    const after = lowerBound(this.timeS, seconds);
    if (after <= 0) return 0;
    if (after >= this.count) return this.count - 1;
    const from = this.timeS[after - 1];
    const span = this.timeS[after] - from;
    return span > 0 ? after - 1 + (seconds - from) / span : after;
  }

  /** Point whose leg is under way, or has just ended, at a position. */
  static pointAt(position: number): number {
    return Math.ceil(position);
  }

  /** Last point of a block. */
  blockLast(block: number): number {
    return this.blockFirst[block + 1] - 1;
  }

  /** Last point of the first block on a line of the program, or of the nearest line after it; `null` past the end. */
  pointOfLine(line: number): number | null {
    let best = -1;
    for (let block = 0; block < this.blocks; block += 1) {
      const candidate = this.line[this.blockFirst[block]];
      if (candidate === line) return this.blockLast(block);
      if (candidate > line && (best < 0 || candidate < this.line[this.blockFirst[best]])) best = block;
    }
    return best < 0 ? null : this.blockLast(best);
  }

  /** Last point of the nearest line that is not after a line of the program; 0 before the first. */
  pointBefore(line: number): number {
    let best = -1;
    for (let block = 0; block < this.blocks; block += 1) {
      const candidate = this.line[this.blockFirst[block]];
      if (candidate <= line && (best < 0 || candidate > this.line[this.blockFirst[best]])) best = block;
    }
    return best < 0 ? 0 : this.blockLast(best);
  }

  /** Runs of points on the lines of a finding; without any an empty run after the last point before them. */
  findingStretches(finding: Finding): { first: number; last: number }[] {
    const known = this.findingRuns.get(finding);
    if (known) return known;
    const runs: { first: number; last: number }[] = [];
    for (let block = 0; block < this.blocks; block += 1) {
      const line = this.line[this.blockFirst[block]];
      if (line < finding.line || line > finding.last_line) continue;
      const open = runs.at(-1);
      if (open && open.last === this.blockFirst[block] - 1) open.last = this.blockLast(block);
      else runs.push({ first: this.blockFirst[block], last: this.blockLast(block) });
    }
    if (runs.length === 0) {
      const point = this.pointBefore(finding.line);
      runs.push({ first: point + 1, last: point });
    }
    this.findingRuns.set(finding, runs);
    return runs;
  }

  placementAt(point: number): Placement {
    return this.head.placements[this.placement[point]];
  }

  toolAt(point: number): Tool {
    return this.toolOfNumber(this.placementAt(point).tool);
  }

  /** A tool by its number; without one in the table a tool without shape and length. */
  toolOfNumber(number: number): Tool {
    return this.head.tools.find((tool) => tool.number === number) ?? { ...NO_TOOL, number };
  }

  setUpAt(point: number): SetUp {
    return this.head.set_ups[this.placementAt(point).set_up];
  }

  /**
   * Limits of an axis as axis values with the set-up and tool of a placement; `null` where there is none, or none is
   * known.
   */
  limits(axis: number, placement: number): [number | null, number | null] {
    const { rotary, min, max } = this.head.machine.joints[axis];
    const zero = rotary ? 0 : (this.head.placements[placement].zero?.[axis] ?? null);
    const shifted = (limit: number | null): number | null => (limit === null || zero === null ? null : limit - zero);
    return [shifted(min), shifted(max)];
  }

  /** Runs of points with the same placement: first and last point. */
  placementRuns(): { placement: number; first: number; last: number }[] {
    const runs: { placement: number; first: number; last: number }[] = [];
    for (let i = 0; i < this.count; i += 1) {
      const open = runs.at(-1);
      if (open && open.placement === this.placement[i]) open.last = i;
      else runs.push({ placement: this.placement[i], first: i, last: i });
    }
    return runs;
  }

  /** First point and end (not included) of a set-up. */
  setUpRange(setUp: number): [number, number] {
    const starts = this.head.set_ups.map((each) => each.first_point);
    return [starts[setUp] ?? 0, starts[setUp + 1] ?? this.count];
  }

  reasonText(point: number): string | null {
    const index = this.reason[point];
    if (index === NO_REASON) return null;
    return this.head.reason_texts[index] ?? this.head.reasons[index] ?? null;
  }

  kindText(point: number): string {
    return this.head.kinds[this.kind[point]] ?? "motion";
  }

  /** Whether the path of the leg to a point is one that the CL data programs, and was not compared with it. */
  isNotCompared(point: number): boolean {
    return this.kindText(point) === "feed" && !this.isStart(point) && Number.isNaN(this.errorUm[point]);
  }

  private accumulateTime(): [Float64Array, Float64Array] {
    const played = new Float64Array(this.count);
    const counted = new Float64Array(this.count);
    for (let i = 0; i < this.count; i += 1) {
      const seconds = this.legSeconds[i];
      const known = seconds > 0 ? seconds : 0;
      const assumed = Number.isNaN(seconds) && !this.isStart(i) ? this.assumedSeconds(i) : known;
      played[i] = (i > 0 ? played[i - 1] : 0) + assumed;
      counted[i] = (i > 0 ? counted[i - 1] : 0) + known;
    }
    return [played, counted];
  }

  /** Time of the axis that takes longest at the assumed speeds. */
  private assumedSeconds(point: number): number {
    return this.head.machine.joints.reduce((longest, joint, i) => {
      const distance = Math.abs(this.axes[i][point] - this.axes[i][point - 1]);
      return Math.max(longest, distance / (joint.rotary ? ASSUMED_DEGREES_PER_S : ASSUMED_MM_PER_S));
    }, 0);
  }

  private divideIntoBlocks(): [Uint32Array, Uint32Array] {
    const block = new Uint32Array(this.count);
    const first: number[] = [];
    for (let i = 0; i < this.count; i += 1) {
      if (i === 0 || this.line[i] !== this.line[i - 1]) first.push(i);
      block[i] = first.length - 1;
    }
    first.push(this.count);
    return [block, Uint32Array.from(first)];
  }

  private shareOfBlocks(): Float64Array {
    const share = new Float64Array(this.count);
    for (let i = 0; i < this.count; i += 1) {
      const first = this.blockFirst[this.block[i]];
      share[i] = this.block[i] + (i - first + 1) / (this.blockFirst[this.block[i] + 1] - first);
    }
    return share;
  }

  private speedOf(values: Float64Array): Float64Array {
    const speeds = new Float64Array(this.count);
    for (let i = 0; i < this.count; i += 1) {
      const seconds = this.legSeconds[i];
      speeds[i] =
        this.isStart(i) || !(seconds > 0) ? Number.NaN : (Math.abs(values[i] - values[i - 1]) / seconds) * 60;
    }
    return speeds;
  }

  private findStretches(): Stretch[] {
    const { machine, reasons } = this.head;
    const kinds = reasons.map((name) => MARK_OF_REASON[name] ?? null);
    const rotary = machine.joints.flatMap((joint, i) => (joint.rotary && !joint.held ? [i] : []));
    const stretches: Stretch[] = [];
    const axes = new Float64Array(machine.joints.length);
    for (let i = 0; i < this.count; i += 1) {
      let kind = kinds[this.reason[i]] ?? null;
      const rotates = rotary.some((joint) => Math.abs(this.axes[joint][i] - this.axes[joint][i - 1]) > 1e-6);
      if ((kind === null || kind === "inserted") && rotary.length === 2 && rotates && !this.isStart(i)) {
        for (let joint = 0; joint < axes.length; joint += 1) axes[joint] = this.axes[joint][i];
        if ((poleMeasure(machine, axes) ?? 1) < NEAR_POLE) kind = "pole";
      }
      if (kind === null) continue;
      const open = stretches.at(-1);
      if (open && open.kind === kind && open.last === i - 1) open.last = i;
      else stretches.push({ kind, first: i, last: i });
    }
    return stretches;
  }
}

/** First index whose value is not less than `wanted`, in values that do not fall; the length if there is none. */
export function lowerBound(values: ArrayLike<number>, wanted: number): number {
  let low = 0;
  let high = values.length;
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (values[middle] < wanted) low = middle + 1;
    else high = middle;
  }
  return low;
}
