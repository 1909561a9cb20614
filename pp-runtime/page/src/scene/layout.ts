/**
 * Where the bodies of the schematic machine are, from the chain alone.
 *
 * Everything is in the workpiece frame with all axes at zero: there all bodies share one frame, so a body that belongs
 * to link `k` has these coordinates in the frame of link `k`, whatever its axes do later. Link 0 is the workpiece, link
 * `k + 1` is what joint `k` carries on the side of the tool, link `frame_after` is the machine frame (bed).
 *
 * True: directions, centre lines of rotary axes, travel of slides, gauge length, tool. Schematic: how far a disc is
 * along its own centre line, the offset of slides, sizes of bodies.
 */

import type { Machine, Triple } from "../data/contract.ts";
import { add, dot, length, perpendicular, perpendicularUnit, scale, subtract, unit, cross } from "../kinematics/vector.ts";

export type Side = "table" | "head" | "bed";

export type Shape =
  | { shape: "cylinder"; centre: Triple; axis: Triple; radius: number; height: number }
  /** Size along `along`, along `across`, and perpendicular to both. */
  | { shape: "box"; centre: Triple; along: Triple; across: Triple; size: Triple }
  | { shape: "line"; from: Triple; to: Triple };

/** `carriage`, `rail` and `stop` are of a slide, `mark` is a line on a disc. */
export type Role = "body" | "carriage" | "rail" | "stop" | "mark" | "centre-line";

export interface Body {
  link: number;
  side: Side;
  role: Role;
  shape: Shape;
}

/** Arrow in which the body of an axis moves while its value grows. */
export interface Arrow {
  joint: number;
  link: number;
  side: Side;
  held: boolean;
  path:
    | { kind: "straight"; from: Triple; direction: Triple; length: number }
    /** From `centre + radius·from`, right-handed about `axis`. */
    | { kind: "arc"; centre: Triple; axis: Triple; from: Triple; radius: number; sweepRad: number };
}

export interface Layout {
  bodies: Body[];
  arrows: Arrow[];
  /** Characteristic length, mm. */
  unitMm: number;
}

export interface LayoutInput {
  machine: Machine;
  /** A point of each joint's centre line. */
  points: Triple[];
  gaugeMm: number;
  /** Corners of the box around the cutting path. */
  box: { min: Triple; max: Triple };
  /** Of each axis: limits as axis values, where they are known, and smallest and largest value in the program. */
  travel: { min: number | null; max: number | null; low: number; high: number }[];
}

/** Direction in which the body of a joint moves on the machine while its value grows: +1 along its direction. */
export function visibleSense(machine: Machine, joint: number): 1 | -1 {
  // A joint on the workpiece side carries the workpiece: seen from the bed it moves opposite to the tool on the
  // workpiece.
  const sign = machine.joints[joint].sign;
  return joint < machine.frame_after ? (sign === 1 ? -1 : 1) : sign;
}

/**
 * Direction in which the body of a linear joint moves, or right-handed axis about which that of a rotary one turns,
 * while its value grows.
 */
export function bodyMotion(machine: Machine, joint: number): Triple {
  return scale(machine.joints[joint].direction, visibleSense(machine, joint));
}

/** The state of a stack of bodies that grows from the workpiece or from the tool towards the bed. */
interface Stack {
  side: Side;
  /** Where the next body is fastened. */
  anchor: Triple;
  /** Centre and radius of the space that the bodies so far need. */
  centre: Triple;
  reachMm: number;
  /** From workpiece or tool towards the bed. */
  outward: Triple;
}

export function layOut(input: LayoutInput): Layout {
  return new Builder(input).build();
}

class Builder {
  private readonly bodies: Body[] = [];
  private readonly arrows: Arrow[] = [];
  private readonly up: Triple;
  /** Away from the usual point of view: there discs, columns and rails hide nothing. */
  private readonly back: Triple;
  /** The same, and to the left where an axis has no end at the back. */
  private readonly far: Triple;
  private readonly unitMm: number;
  private readonly partCentre: Triple;
  private readonly partRadius: number;

  constructor(private readonly input: LayoutInput) {
    const { machine, box, gaugeMm } = input;
    this.up = unit(machine.tool_axis);
    this.back = perpendicularUnit(this.up, [0, 1, 0]);
    this.far = perpendicularUnit(this.up, [-0.3, 1, 0]);
    const diagonal = subtract(box.max, box.min);
    this.partCentre = scale(add(box.min, box.max), 0.5);
    this.partRadius = Math.max(length(diagonal) / 2, 1);
    this.unitMm = Math.max(20, 0.55 * length(diagonal), 0.45 * gaugeMm);
  }

  build(): Layout {
    const { machine } = this.input;
    const low = Math.min(...this.corners().map((corner) => dot(corner, this.up)));
    const below = dot(this.partCentre, this.up) - low + 0.1 * this.unitMm;
    const table: Stack = {
      side: "table",
      anchor: subtract(this.partCentre, scale(this.up, below)),
      centre: this.partCentre,
      reachMm: this.partRadius,
      outward: scale(this.up, -1),
    };
    for (let joint = 0; joint < machine.frame_after; joint += 1) this.stack(table, joint, joint, joint + 1);

    const head = this.spindle();
    for (let joint = machine.joints.length - 1; joint >= machine.frame_after; joint -= 1) {
      this.stack(head, joint, joint + 1, joint);
    }
    this.bed(table, head);
    return { bodies: this.bodies, arrows: this.arrows, unitMm: this.unitMm };
  }

  private corners(): Triple[] {
    const { min, max } = this.input.box;
    const corners: Triple[] = [];
    for (const x of [min[0], max[0]]) for (const y of [min[1], max[1]]) for (const z of [min[2], max[2]]) corners.push([x, y, z]);
    return corners;
  }

  /** Spindle nose, above the gauge line. */
  private spindle(): Stack {
    const { machine, gaugeMm } = this.input;
    const u = this.unitMm;
    const link = machine.joints.length;
    const gauge = scale(this.up, gaugeMm);
    const side: Side = machine.frame_after === link ? "bed" : "head";
    this.body(link, side, "body", this.cylinder(add(gauge, scale(this.up, 0.06 * u)), this.up, 0.2 * u, 0.12 * u));
    this.body(link, side, "body", this.cylinder(add(gauge, scale(this.up, 0.42 * u)), this.up, 0.26 * u, 0.6 * u));
    const anchor = add(gauge, scale(this.up, 0.42 * u));
    return { side: "head", anchor, centre: anchor, reachMm: 0.36 * u, outward: this.up };
  }

  private stack(stack: Stack, joint: number, moving: number, fixed: number): void {
    if (this.input.machine.joints[joint].rotary) this.rotary(stack, joint, moving, fixed);
    else this.slide(stack, joint, moving, fixed);
  }

  /** A disc on its centre line, its base, and the arm that joins it to what it carries. */
  private rotary(stack: Stack, index: number, moving: number, fixed: number): void {
    const joint = this.input.machine.joints[index];
    const u = this.unitMm;
    const axis = joint.direction;
    const point = this.input.points[index];
    const onLine = (place: Triple): Triple => add(point, scale(axis, dot(subtract(place, point), axis)));
    const upright = Math.abs(dot(axis, stack.outward)) > 0.9;
    const wanted = upright ? stack.outward : add(this.far, scale(stack.outward, 0.6));
    const out = dot(axis, wanted) >= 0 ? axis : scale(axis, -1);

    let radius = 0.42 * u;
    let face: Triple;
    if (upright && stack.side === "table") {
      const corners = this.corners().map((corner) => length(perpendicular(subtract(corner, point), axis)));
      radius = Math.min(Math.max(0.6 * u, Math.max(...corners) * 1.12), 2.5 * u);
      face = onLine(stack.anchor);
    } else if (upright) {
      face = onLine(add(stack.centre, scale(out, stack.reachMm)));
    } else {
      face = add(onLine(stack.centre), scale(out, stack.reachMm + 0.08 * u));
    }
    const thick = 0.12 * u;
    const disc = add(face, scale(out, thick / 2));
    const base = add(face, scale(out, thick + 0.09 * u));
    const side = stack.side;
    this.body(moving, side, "body", this.cylinder(disc, axis, radius, thick));
    this.body(fixed, this.sideOf(fixed, side), "body", this.cylinder(base, axis, radius * 0.82, 0.18 * u));
    if (length(subtract(disc, stack.anchor)) > radius || !upright) this.elbow(moving, side, stack.anchor, disc, out);

    // Zero: a mark on the disc and one on the base; between them is the angle.
    const start = perpendicularUnit(axis, subtract(scale(this.up, upright ? 0 : 0.8), this.back));
    const rim = (share: number, shift: number): Triple =>
      add(add(disc, scale(start, radius * share)), scale(out, shift));
    this.body(moving, side, "mark", { shape: "line", from: rim(0.35, -0.51 * thick), to: rim(1, -0.51 * thick) });
    this.body(fixed, this.sideOf(fixed, side), "mark", { shape: "line", from: rim(1.02, 0), to: rim(1.22, 0) });

    const half = Math.max(stack.reachMm + 0.5 * u, radius * 1.2);
    const middle = onLine(stack.centre);
    this.body(fixed, this.sideOf(fixed, side), "centre-line", {
      shape: "line",
      from: subtract(middle, scale(axis, half)),
      to: add(add(base, scale(out, 0.35 * u)), scale(axis, 0)),
    });

    this.arrows.push({
      joint: index,
      link: fixed,
      side,
      held: joint.held,
      path: {
        kind: "arc",
        centre: disc,
        axis: bodyMotion(this.input.machine, index),
        from: start,
        radius: radius * 1.14,
        sweepRad: 0.9,
      },
    });

    const end = add(base, scale(out, 0.09 * u));
    stack.reachMm = upright
      ? Math.max(stack.reachMm * 0.6, 0.3 * u)
      : Math.max(0.5 * u, Math.min(length(subtract(stack.centre, end)), stack.reachMm + 0.4 * u));
    stack.centre = upright ? end : stack.centre;
    stack.anchor = end;
  }

  /** A carriage on two rails; the rails are as long as the travel. */
  private slide(stack: Stack, index: number, moving: number, fixed: number): void {
    const joint = this.input.machine.joints[index];
    const u = this.unitMm;
    const along = joint.direction;
    const vertical = Math.abs(dot(along, stack.outward)) > 0.7;
    const out = perpendicularUnit(along, vertical ? this.back : stack.outward);
    const across = cross(out, along);
    const sense = visibleSense(this.input.machine, index);
    const skip = vertical ? (stack.side === "head" ? 0.26 * u : 0.1 * u) : stack.side === "head" && stack.reachMm > 0.35 * u ? 0.3 * u : 0;
    const carriage = add(stack.anchor, scale(out, skip + 0.09 * u));
    const side = stack.side;
    this.body(moving, side, "carriage", this.box(carriage, along, across, [0.7 * u, 0.62 * u, 0.18 * u]));
    if (skip > 0.12 * u) this.strut(moving, side, stack.anchor, carriage, 0.2 * u, "carriage");

    const { min, max, low, high } = this.input.travel[index];
    const [from, to] = [min ?? low, max ?? high];
    const middle = (sense * (from + to)) / 2;
    const travel = Math.max(to - from, 0) + 0.7 * u;
    const depth = skip + 0.18 * u;
    for (const offset of [-0.22 * u, 0.22 * u]) {
      const centre = add(add(stack.anchor, scale(out, depth)), add(scale(across, offset), scale(along, middle)));
      const half = scale(along, travel / 2);
      this.body(fixed, this.sideOf(fixed, side), "rail", { shape: "line", from: subtract(centre, half), to: add(centre, half) });
      for (const [limit, end] of [[min, from], [max, to]] as [number | null, number][]) {
        if (limit === null) continue;
        const outside = end === to ? 0.38 * u : -0.38 * u;
        const stop = add(centre, scale(along, sense * (end + outside) - middle));
        this.body(fixed, this.sideOf(fixed, side), "stop", this.box(stop, along, across, [0.04 * u, 0.1 * u, 0.12 * u]));
      }
    }
    this.arrows.push({
      joint: index,
      link: moving,
      side,
      held: joint.held,
      path: {
        kind: "straight",
        from: add(carriage, scale(bodyMotion(this.input.machine, index), 0.38 * u)),
        direction: bodyMotion(this.input.machine, index),
        length: 0.5 * u,
      },
    });
    // What carries an upright slide of the head is behind it: the spindle goes past it.
    const clear = vertical && stack.side === "head" ? 0.42 * u : 0.04 * u;
    stack.anchor = add(stack.anchor, scale(out, depth + clear));
    stack.centre = stack.anchor;
    stack.reachMm = 0.35 * u;
  }

  /** The machine frame: from the end of the table's stack along the back to the end of the head's. */
  private bed(table: Stack, head: Stack): void {
    const { machine } = this.input;
    const u = this.unitMm;
    const link = machine.frame_after;
    const base = table.anchor;
    this.body(link, "bed", "body", this.box(
      subtract(base, scale(this.up, 0.06 * u)),
      this.back,
      cross(this.up, this.back),
      [0.9 * u, 0.9 * u, 0.12 * u],
    ));
    const depth = Math.max(dot(base, this.back), dot(head.anchor, this.back)) + 0.9 * u;
    const foot = add(base, scale(this.back, depth - dot(base, this.back)));
    const top = add(head.anchor, scale(this.back, depth - dot(head.anchor, this.back)));
    // The foot keeps the position of the base across, the top that of the head: a beam joins them at the height of the
    // head.
    const knee = add(foot, scale(this.up, dot(subtract(top, foot), this.up)));
    this.strut(link, "bed", subtract(base, scale(this.up, 0.06 * u)), subtract(foot, scale(this.up, 0.06 * u)), 0.12 * u);
    this.strut(link, "bed", foot, knee, 0.12 * u);
    this.strut(link, "bed", knee, top, 0.12 * u);
    this.strut(link, "bed", top, head.anchor, 0.12 * u);
  }

  /** Two struts: parallel to `out` from `from`, then perpendicular to it. */
  private elbow(link: number, side: Side, from: Triple, to: Triple, out: Triple): void {
    const corner = add(from, scale(out, dot(subtract(to, from), out)));
    this.strut(link, side, from, corner, 0.11 * this.unitMm);
    this.strut(link, side, corner, to, 0.11 * this.unitMm);
  }

  private strut(link: number, side: Side, from: Triple, to: Triple, thick: number, role: Role = "body"): void {
    const span = subtract(to, from);
    const distance = length(span);
    if (distance < 0.2 * thick) return;
    const along = scale(span, 1 / distance);
    const across = perpendicularUnit(along, this.up);
    this.body(link, side, role, this.box(scale(add(from, to), 0.5), along, across, [distance + thick, thick, thick]));
  }

  private body(link: number, side: Side, role: Role, shape: Shape): void {
    this.bodies.push({ link, side, role, shape });
  }

  /** A body on the bed has the colour of the bed, whichever stack it belongs to. */
  private sideOf(link: number, side: Side): Side {
    return link === this.input.machine.frame_after ? "bed" : side;
  }

  private cylinder(centre: Triple, axis: Triple, radius: number, height: number): Shape {
    return { shape: "cylinder", centre, axis, radius, height };
  }

  private box(centre: Triple, along: Triple, across: Triple, size: Triple): Shape {
    return { shape: "box", centre, along, across, size };
  }
}
