/** The tool path: one line of 1 px for each leg, coloured from a table. */

import {
  Box3,
  BufferAttribute,
  BufferGeometry,
  Color,
  GLSL3,
  LineSegments,
  ShaderMaterial,
  Vector3,
} from "three";
import { TABLE_SIZE, type Colouring } from "../colour/colouring.ts";
import type { Theme } from "../colour/scale.ts";
import type { Program } from "../data/program.ts";
import { styleColour } from "../theme.ts";

/** How much of the path is drawn. */
export type PathExtent = "whole" | "done" | "operation";

// Colours are those of the screen as they are: nothing is lit. A leg that is not shown is moved out of sight.
const VERTEX = /* glsl */ `
  in vec4 colour;
  in float leg;
  in float travelled;
  uniform vec2 range;
  uniform float dash;
  out vec3 shade;
  out float along;
  void main() {
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    if (leg < range.x || leg > range.y) gl_Position = vec4(0.0, 0.0, 2.0, 1.0);
    shade = colour.rgb;
    along = travelled / dash;
  }
`;

const FRAGMENT = /* glsl */ `
  in vec3 shade;
  in float along;
  out vec4 fragment;
  void main() {
    if (fract(along) > 0.55) discard;
    fragment = vec4(shade, 1.0);
  }
`;

export class Path {
  readonly object: LineSegments<BufferGeometry, ShaderMaterial>;
  /** Point of each drawn leg, in order. */
  private readonly legs: Uint32Array;
  private colouring: Colouring;
  private shares = new Float32Array(0);

  constructor(
    private readonly program: Program,
    colouring: Colouring,
    theme: Theme,
  ) {
    const drawn: number[] = [];
    for (let i = 0; i < program.count; i += 1) if (!program.isStart(i)) drawn.push(i);
    this.legs = Uint32Array.from(drawn);
    this.colouring = colouring;
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      vertexShader: VERTEX,
      fragmentShader: FRAGMENT,
      uniforms: {
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
    this.shares = colouring.shares();
    this.restyle(theme);
  }

  restyle(theme: Theme): void {
    const table = this.colouring.table(theme).map((colour) => colour.map((value) => Math.round(value * 255)));
    const unknown = new Color(styleColour("--path-unknown")).convertLinearToSRGB().toArray().map((value) => Math.round(value * 255));
    const attribute = this.object.geometry.getAttribute("colour") as BufferAttribute;
    const bytes = attribute.array;
    this.legs.forEach((point, leg) => {
      const share = this.shares[point];
      const shade = share < 0 ? unknown : table[Math.min(Math.floor(share * TABLE_SIZE), TABLE_SIZE - 1)];
      for (let at = 8 * leg; at < 8 * leg + 8; at += 4) {
        bytes[at] = shade[0];
        bytes[at + 1] = shade[1];
        bytes[at + 2] = shade[2];
      }
    });
    attribute.needsUpdate = true;
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
    // Distance travelled in rapid motion, where the line is dashed; 0 elsewhere.
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
        travelled[2 * i] = sum;
        sum += Math.sqrt(square);
        travelled[2 * i + 1] = sum;
      } else {
        sum = 0;
      }
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(positions, 3));
    geometry.setAttribute("colour", new BufferAttribute(new Uint8Array(8 * legs.length), 4, true));
    geometry.setAttribute("leg", new BufferAttribute(leg, 1));
    geometry.setAttribute("travelled", new BufferAttribute(travelled, 1));
    return geometry;
  }
}
