/** The tool: a body of revolution about its axis, from the tip to the gauge line. */

import {
  BufferAttribute,
  BufferGeometry,
  Group,
  LatheGeometry,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshLambertMaterial,
  Quaternion,
  Vector2,
  Vector3,
} from "three";
import type { Tool, Triple } from "../data/contract.ts";
import type { ToolPart } from "../data/simulation.ts";
import { styleColour } from "../theme.ts";
import { outline, type ProfilePoint } from "./profile.ts";

const SEGMENTS = 40;

/** A group whose origin is the tip; its z axis is the tool axis. */
export class ToolBody {
  readonly object = new Group();
  private readonly cutting = new MeshLambertMaterial({ flatShading: false, transparent: true, opacity: 0.92 });
  private readonly shank = new MeshLambertMaterial({ transparent: true, opacity: 0.92 });
  private readonly holder = new MeshLambertMaterial({ transparent: true, opacity: 0.92 });
  private readonly line = new LineBasicMaterial();

  constructor(toolAxis: Triple) {
    this.object.name = "tool";
    this.object.quaternion.copy(
      new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(...toolAxis).normalize()),
    );
  }

  /** Shows a tool. `parts`: what is known of it besides its diameter. */
  show(tool: Tool, parts: ToolPart[] | null): void {
    this.object.traverse((child) => {
      if (child instanceof Mesh || child instanceof Line) child.geometry.dispose();
    });
    this.object.clear();
    const { cutting, shank, unknown } = outline(tool);
    if (parts && parts.length > 0) {
      const materials = { cutter: this.cutting, shank: this.shank, holder: this.holder };
      for (const { part, outlines } of parts) {
        for (const each of outlines) this.add(each.map(([radius, height]) => [height, radius]), materials[part]);
      }
    } else {
      this.add(cutting, this.cutting);
      this.add(shank, this.shank);
    }
    const from = unknown ? unknown[0] : 0;
    const to = unknown ? unknown[1] : (tool.gauge_length ?? tool.length ?? 0);
    const axis = new BufferGeometry();
    axis.setAttribute("position", new BufferAttribute(new Float32Array([0, 0, from, 0, 0, to]), 3));
    this.object.add(new Line(axis, this.line));
  }

  restyle(): void {
    this.cutting.color.set(styleColour("--tool-cutting"));
    this.shank.color.set(styleColour("--tool-shank"));
    this.holder.color.set(styleColour("--tool-holder"));
    this.line.color.set(styleColour("--tool-line"));
  }

  private add(profile: ProfilePoint[], material: MeshLambertMaterial): void {
    if (profile.length < 2) return;
    const lathe = new LatheGeometry(
      profile.map(([height, radius]) => new Vector2(Math.max(radius, 0), height)),
      SEGMENTS,
    );
    // The lathe turns about y: bring y to z.
    lathe.rotateX(Math.PI / 2);
    this.object.add(new Mesh(lathe, material));
  }
}
