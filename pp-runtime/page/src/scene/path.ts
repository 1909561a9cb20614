/** The tool path: one line of 1 px for each leg, coloured from a table. */

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  DataTexture,
  GLSL3,
  LineSegments,
  NearestFilter,
  RGBAFormat,
  ShaderMaterial,
  SRGBColorSpace,
  Vector3,
} from "three";
import { TABLE_SIZE, type Colouring } from "../colour/colouring.ts";
import type { Theme } from "../colour/scale.ts";
import type { Program } from "../data/program.ts";
import { styleColour } from "../theme.ts";

/** How much of the path is drawn. */
export type PathExtent = "whole" | "done" | "operation";

const VERTEX = /* glsl */ `
  in float share;
  in float leg;
  in float travelled;
  uniform sampler2D table;
  uniform vec3 unknown;
  uniform vec2 range;
  uniform float dash;
  out vec3 colour;
  out float along;
  out float shown;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    float size = float(${TABLE_SIZE});
    colour = share < 0.0 ? unknown : texture(table, vec2((share * (size - 1.0) + 0.5) / size, 0.5)).rgb;
    along = abs(travelled) / dash * (travelled < 0.0 ? 1.0 : 0.0);
    shown = leg >= range.x && leg <= range.y ? 1.0 : 0.0;
  }
`;

const FRAGMENT = /* glsl */ `
  in vec3 colour;
  in float along;
  in float shown;
  out vec4 fragment;
  void main() {
    if (shown < 0.5 || fract(along) > 0.55) discard;
    fragment = linearToOutputTexel(vec4(colour, 1.0));
  }
`;

export class Path {
  readonly object: LineSegments<BufferGeometry, ShaderMaterial>;
  /** Point of each drawn leg, in order. */
  private readonly legs: Uint32Array;
  private readonly table: DataTexture;
  private colouring: Colouring;

  constructor(
    private readonly program: Program,
    colouring: Colouring,
    theme: Theme,
  ) {
    const drawn: number[] = [];
    for (let i = 0; i < program.count; i += 1) if (!program.isStart(i)) drawn.push(i);
    this.legs = Uint32Array.from(drawn);
    this.colouring = colouring;
    this.table = new DataTexture(new Uint8Array(4 * TABLE_SIZE), TABLE_SIZE, 1, RGBAFormat);
    this.table.colorSpace = SRGBColorSpace;
    this.table.magFilter = NearestFilter;
    this.table.minFilter = NearestFilter;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
        table: { value: this.table },
        unknown: { value: new Color() },
        range: { value: [0, program.count] },
        dash: { value: this.dashMm() },
      },
    });
    this.object = new LineSegments(this.geometry(), material);
    this.object.name = "path";
    this.object.frustumCulled = false;
    this.colour(colouring, theme);
  }

  colour(colouring: Colouring, theme: Theme): void {
    this.colouring = colouring;
    const shares = colouring.shares();
    const attribute = this.object.geometry.getAttribute("share") as BufferAttribute;
    this.legs.forEach((point, leg) => {
      attribute.array[2 * leg] = shares[point];
      attribute.array[2 * leg + 1] = shares[point];
    });
    attribute.needsUpdate = true;
    this.restyle(theme);
  }

  restyle(theme: Theme): void {
    const bytes = this.table.image.data as Uint8Array;
    this.colouring.table(theme).forEach((colour, i) => {
      for (let channel = 0; channel < 3; channel += 1) bytes[4 * i + channel] = Math.round(colour[channel] * 255);
      bytes[4 * i + 3] = 255;
    });
    this.table.needsUpdate = true;
    (this.object.material.uniforms.unknown.value as Color).set(styleColour("--path-unknown"));
  }

  /** Shows the legs to the points `first` to `last` only. */
  show(first: number, last: number): void {
    this.object.material.uniforms.range.value = [first, last];
  }

  /** Box around the tips of some points; with `cutting`, around those of feed motions alone where there are any. */
  box(first: number, end: number, cutting: boolean): Box3 {
    const { tip } = this.program;
    const around = (use: (point: number) => boolean): Box3 => {
      const box = new Box3();
      const place = new Vector3();
      for (let i = first; i < end; i += 1) {
        if (use(i) && Number.isFinite(tip[0][i])) box.expandByPoint(place.set(tip[0][i], tip[1][i], tip[2][i]));
      }
      return box;
    };
    const feed = cutting ? around((i) => !this.program.isRapid(i) && !this.program.isStart(i)) : new Box3();
    return feed.isEmpty() ? around(() => true) : feed;
  }

  private dashMm(): number {
    const size = this.box(0, this.program.count, false).getSize(new Vector3()).length();
    return Math.max(size / 90, 1e-3);
  }

  private geometry(): BufferGeometry {
    const { program, legs } = this;
    const positions = new Float32Array(6 * legs.length);
    const leg = new Float32Array(2 * legs.length);
    // Distance travelled, negative in rapid motion, where the line is dashed.
    const travelled = new Float32Array(2 * legs.length);
    let sum = 0;
    for (let i = 0; i < legs.length; i += 1) {
      const point = legs[i];
      let square = 0;
      for (let axis = 0; axis < 3; axis += 1) {
        const from = program.tip[axis][point - 1];
        const to = program.tip[axis][point];
        positions[6 * i + axis] = from;
        positions[6 * i + 3 + axis] = to;
        square += (to - from) ** 2;
      }
      leg[2 * i] = leg[2 * i + 1] = point;
      if (program.isRapid(point)) {
        travelled[2 * i] = -sum - 1e-6;
        sum += Math.sqrt(square);
        travelled[2 * i + 1] = -sum - 1e-6;
      } else {
        sum = 0;
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("share", new BufferAttribute(new Float32Array(2 * legs.length), 1));
    geometry.setAttribute("leg", new BufferAttribute(leg, 1));
    geometry.setAttribute("travelled", new BufferAttribute(travelled, 1));
    return geometry;
  }
}
