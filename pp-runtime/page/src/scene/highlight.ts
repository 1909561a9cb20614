/** The current block as a wide line, the block under the pointer, and points on the path. */

import { BufferAttribute, BufferGeometry, Color, GLSL3, Points, ShaderMaterial } from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import type { Triple } from "../data/contract.ts";
import type { Program } from "../data/program.ts";
import { styleColour } from "../theme.ts";

/** Longest block that is drawn as a wide line, legs: wide lines take time. */
const MOST_LEGS = 4000;

/** A wide line along one block. */
export class BlockLine {
  readonly object: LineSegments2;
  private shown: number | null = null;

  constructor(
    private readonly program: Program,
    private readonly colour: string,
    widthPx: number,
  ) {
    this.object = new LineSegments2(new LineSegmentsGeometry(), new LineMaterial({ linewidth: widthPx }));
    this.object.frustumCulled = false;
    this.object.visible = false;
    this.object.renderOrder = 1;
  }

  show(block: number | null): void {
    if (block === this.shown) return;
    this.shown = block;
    const positions: number[] = [];
    if (block !== null) {
      const last = Math.min(this.program.blockLast(block), this.program.blockFirst[block] + MOST_LEGS);
      for (let i = this.program.blockFirst[block]; i <= last; i += 1) {
        if (!this.program.isStart(i)) positions.push(...this.program.tipAt(i - 1), ...this.program.tipAt(i));
      }
    }
    this.object.visible = positions.length > 0;
    if (!this.object.visible) return;
    this.object.geometry.dispose();
    this.object.geometry = new LineSegmentsGeometry().setPositions(positions);
  }

  restyle(): void {
    this.object.material.color.set(styleColour(this.colour));
  }
}

/** A ring of constant size on the screen. */
export class Ring {
  readonly object: Points<BufferGeometry, ShaderMaterial>;

  constructor(
    private readonly colour: string,
    sizePx: number,
    pixelRatio: number,
  ) {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array(3), 3));
    const material = new ShaderMaterial({
      glslVersion: GLSL3,
      depthTest: false,
      uniforms: { colour: { value: new Color() }, size: { value: sizePx * pixelRatio } },
      vertexShader: /* glsl */ `
        uniform float size;
        void main() {
          gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
          gl_PointSize = size;
        }
      `,
      fragmentShader: /* glsl */ `
        uniform vec3 colour;
        out vec4 fragment;
        void main() {
          float r = length(gl_PointCoord * 2.0 - 1.0);
          if (r > 0.95 || (r < 0.68 && r > 0.22)) discard;
          fragment = linearToOutputTexel(vec4(colour, 1.0));
        }
      `,
    });
    this.object = new Points(geometry, material);
    this.object.frustumCulled = false;
    this.object.renderOrder = 5;
  }

  show(place: Triple | null): void {
    this.object.visible = place !== null && Number.isFinite(place[0]);
    if (place) this.object.position.set(...place);
  }

  restyle(): void {
    (this.object.material.uniforms.colour.value as Color).set(styleColour(this.colour));
  }
}
