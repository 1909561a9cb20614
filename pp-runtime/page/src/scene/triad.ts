/** Directions of the workpiece axes: at the workpiece origin, and in the corner of the view. */

import { BufferAttribute, BufferGeometry, Group, LineBasicMaterial, LineSegments, Vector3 } from "three";
import { element } from "../dom.ts";
import { styleColour } from "../theme.ts";
import type { Fixed, LabelAnchor } from "./machine.ts";
import type { View } from "./view.ts";

const AXES = ["X", "Y", "Z"] as const;

/** The workpiece origin with its axes. */
export class OriginTriad {
  readonly object = new Group();
  readonly labels: LabelAnchor[] = [];
  private readonly material = new LineBasicMaterial();

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(new Float32Array([0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 1]), 3));
    this.object.add(new LineSegments(geometry, this.material));
    AXES.forEach((letter, i) => {
      const end = new Group();
      end.position.setComponent(i, 1.12);
      this.object.add(end);
      this.labels.push({ object: end, text: letter, kind: "origin", title: `workpiece ${letter}` });
    });
  }

  size(lengthMm: number): void {
    this.object.scale.setScalar(lengthMm);
    this.object.updateMatrixWorld(true);
  }

  restyle(): void {
    this.material.color.set(styleColour("--origin"));
  }
}

/** The axes of what is at rest, the machine or the part, as the reader sees them now: in the corner of the view. */
export class CornerTriad {
  private readonly lines: SVGLineElement[] = [];
  private readonly texts: SVGTextElement[] = [];

  private readonly caption = element("span");

  constructor(private readonly view: View) {
    const namespace = "http://www.w3.org/2000/svg";
    const svg = document.createElementNS(namespace, "svg");
    svg.setAttribute("viewBox", "-36 -36 72 72");
    svg.setAttribute("aria-hidden", "true");
    AXES.forEach((letter, i) => {
      const line = document.createElementNS(namespace, "line");
      line.setAttribute("class", `axis-${letter.toLowerCase()}`);
      const text = document.createElementNS(namespace, "text");
      text.textContent = letter;
      svg.append(line, text);
      this.lines[i] = line;
      this.texts[i] = text;
    });
    view.container.append(element("div", { class: "corner" }, svg, this.caption));
    view.onFrame(() => this.turn());
  }

  name(fixed: Fixed): void {
    this.caption.textContent = fixed;
  }

  private turn(): void {
    const right = new Vector3().setFromMatrixColumn(this.view.camera.matrixWorld, 0);
    const up = new Vector3().setFromMatrixColumn(this.view.camera.matrixWorld, 1);
    AXES.forEach((_, i) => {
      // What is at rest is the world.
      const axis = new Vector3().setComponent(i, 1);
      const x = axis.dot(right);
      const y = -axis.dot(up);
      this.lines[i].setAttribute("x2", (22 * x).toFixed(2));
      this.lines[i].setAttribute("y2", (22 * y).toFixed(2));
      this.texts[i].setAttribute("x", (30 * x).toFixed(2));
      this.texts[i].setAttribute("y", (30 * y).toFixed(2));
    });
  }
}
