/** Marks on the path: rewinds, stretches near the pole, retracts, inserted points, findings; and tool axis ticks. */

import { BufferAttribute, BufferGeometry, Color, GLSL3, LineBasicMaterial, LineSegments, Points, ShaderMaterial } from "three";
import type { MarkKind, Program } from "../data/program.ts";
import { styleColour } from "../theme.ts";

/** All kinds of marks: name on the page, colour in the style sheet, shape on the path. */
export const MARKS: Record<MarkKind | "finding", { label: string; colour: string; shape: number; sizePx: number }> = {
  finding: { label: "finding", colour: "--mark-finding", shape: 0, sizePx: 15 },
  rewind: { label: "rewind", colour: "--mark-rewind", shape: 1, sizePx: 12 },
  pole: { label: "near the pole", colour: "--mark-pole", shape: 2, sizePx: 9 },
  retract: { label: "retract", colour: "--mark-retract", shape: 3, sizePx: 11 },
  inserted: { label: "inserted point", colour: "--mark-inserted", shape: 4, sizePx: 4 },
};

export const MARK_KINDS = Object.keys(MARKS) as (MarkKind | "finding")[];

/** Largest number of marks of one kind on the path; of more, every second, third ... is drawn. */
const MOST = 4000;

/** Largest number of tool axis ticks. */
const MOST_TICKS = 3000;

const VERTEX = /* glsl */ `
  uniform float size;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_Position.z -= 0.0005;
    gl_PointSize = size;
  }
`;

const FRAGMENT = /* glsl */ `
  uniform vec3 colour;
  uniform vec3 edge;
  uniform int shape;
  out vec4 fragment;
  // Distance from the outline, in halves of the point's size; negative inside.
  float outline(vec2 p) {
    if (shape == 0) return max(abs(p.x) * 0.87 + p.y * 0.5, -p.y) - 0.45;
    if (shape == 1) return abs(p.x) + abs(p.y) - 0.9;
    if (shape == 2) return max(abs(p.x), abs(p.y)) - 0.75;
    if (shape == 3) return max(abs(p.x) * 0.87 - p.y * 0.5, p.y) - 0.45;
    return length(p) - 0.85;
  }
  void main() {
    vec2 p = vec2(gl_PointCoord.x * 2.0 - 1.0, 1.0 - gl_PointCoord.y * 2.0);
    float d = outline(p);
    if (d > 0.0) discard;
    fragment = linearToOutputTexel(vec4(shape != 4 && d > -0.17 ? edge : colour, 1.0));
  }
`;

/** Points of the program that have a mark of a kind. */
export function markedPoints(program: Program, kind: MarkKind | "finding"): number[] {
  if (kind === "finding") {
    return program.head.findings.flatMap((finding) => (finding.point === null ? [] : [finding.point]));
  }
  const points: number[] = [];
  for (const stretch of program.stretches) {
    if (stretch.kind !== kind) continue;
    if (kind === "inserted") for (let i = stretch.first; i <= stretch.last; i += 1) points.push(i);
    else points.push(stretch.first, ...(stretch.last > stretch.first ? [stretch.last] : []));
  }
  return points;
}

/** The marks of one kind as one object; `null` where the program has none. */
export class PathMarks {
  readonly object: Points<BufferGeometry, ShaderMaterial>;
  private readonly points: number[];

  static of(program: Program, kind: MarkKind | "finding", pixelRatio: number): PathMarks | null {
    const points = markedPoints(program, kind);
    return points.length === 0 ? null : new PathMarks(program, kind, points, pixelRatio);
  }

  private constructor(
    program: Program,
    readonly kind: MarkKind | "finding",
    points: number[],
    pixelRatio: number,
  ) {
    const step = Math.ceil(points.length / MOST);
    this.points = points.filter((_, i) => i % step === 0);
    const positions = new Float32Array(this.points.flatMap((point) => program.tipAt(point)));
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    const { shape, sizePx } = MARKS[kind];
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        colour: { value: new Color() },
        edge: { value: new Color() },
        shape: { value: shape },
        size: { value: sizePx * pixelRatio },
      },
    });
    this.object = new Points(geometry, material);
    this.object.name = `marks ${kind}`;
    this.object.frustumCulled = false;
    this.object.renderOrder = kind === "finding" ? 3 : 2;
  }

  /** Shows the marks of the points `first` to `last` only. */
  show(first: number, last: number): void {
    const from = this.points.findIndex((point) => point >= first);
    const inRange = this.points.filter((point) => point >= first && point <= last).length;
    this.object.geometry.setDrawRange(from < 0 ? 0 : from, inRange);
  }

  restyle(): void {
    (this.object.material.uniforms.colour.value as Color).set(styleColour(MARKS[this.kind].colour));
    (this.object.material.uniforms.edge.value as Color).set(styleColour("--viewport"));
  }
}

/** Lines along the tool axis from the tip, at points spread evenly over the legs. */
export class AxisTicks {
  readonly object: LineSegments<BufferGeometry, LineBasicMaterial>;
  /** A tick is drawn at every point that this number divides. */
  readonly every: number;
  private readonly points: number[] = [];

  constructor(program: Program, lengthMm: number) {
    this.every = Math.max(1, Math.ceil(program.count / MOST_TICKS));
    const positions: number[] = [];
    for (let i = 0; i < program.count; i += this.every) {
      const tip = program.tipAt(i);
      if (program.isRapid(i) || program.isStart(i) || !Number.isFinite(tip[0])) continue;
      this.points.push(i);
      positions.push(...tip, ...tip.map((value, axis) => value + lengthMm * program.toolAxis[axis][i]));
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(positions), 3));
    this.object = new LineSegments(geometry, new LineBasicMaterial({ transparent: true, opacity: 0.55 }));
    this.object.name = "tool axis ticks";
    this.object.frustumCulled = false;
  }

  show(first: number, last: number): void {
    const from = this.points.findIndex((point) => point >= first);
    const inRange = this.points.filter((point) => point >= first && point <= last).length;
    this.object.geometry.setDrawRange(from < 0 ? 0 : 2 * from, 2 * inRange);
  }

  restyle(): void {
    this.object.material.color.set(styleColour("--tick"));
  }
}
