/**
 * The machine as it is drawn. The scene graph is the chain: link 0 (workpiece) contains link 1 (what the first joint
 * carries), and so on to the tool; the matrix of each is the matrix of its joint. What is drawn is therefore the
 * product of the joints, and nothing else moves a body.
 */

import {
  Box3,
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  ConeGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Group,
  Line,
  LineBasicMaterial,
  LineDashedMaterial,
  LineSegments,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  Quaternion,
  Vector3,
  type Object3D,
} from "three";
import type { Machine, Tool, Triple } from "../data/contract.ts";
import type { ToolPart } from "../data/simulation.ts";
import { jointMatrix, jointValue, type Matrix } from "../kinematics/chain.ts";
import { add, cross, scale, subtract, unit } from "../kinematics/vector.ts";
import { styleColour } from "../theme.ts";
import { layOut, type Arrow, type Body, type LayoutInput, type Side } from "./layout.ts";
import { ToolBody } from "./tool.ts";

/** How the bodies of the machine are drawn. */
export type MachineStyle = "solid" | "ghost" | "off";

/** What the reader holds on to: the workpiece, or the bed. */
export type Fixed = "part" | "machine";

const SIDES: Side[] = ["table", "head", "bed"];

/** A label at a place of the scene. */
export interface LabelAnchor {
  object: Object3D;
  text: string;
  /** Class of the label. */
  kind: string;
  title: string;
}

export class MachineScene {
  /** Link 0: contains everything. Its matrix is the position of the workpiece in the world. */
  readonly workpiece = new Group();
  readonly tool: ToolBody;
  labels: LabelAnchor[] = [];
  unitMm = 1;
  private readonly links: Group[] = [];
  /** What others have added to links. */
  private readonly attached: Group[] = [];
  /** Bodies of each link, so that they can be replaced without touching the chain. */
  private readonly bodies: Record<Side, Group[]> = { table: [], head: [], bed: [] };
  /** Slides of each link, on both sides: shown while the bed is at rest. */
  private readonly slides: Group[] = [];
  private readonly centreLines: Group[] = [];
  private readonly arrows: Group[] = [];
  private readonly slideArrows: Group[] = [];
  private readonly solid: Record<Side, MeshLambertMaterial>;
  private readonly edge: Record<Side, LineBasicMaterial>;
  private readonly arrowLine: Record<Side, LineBasicMaterial>;
  private readonly arrowHead: Record<Side, MeshBasicMaterial>;
  private readonly centre = new LineDashedMaterial({ dashSize: 1, gapSize: 1 });
  private points: Triple[] = [];
  private axes: number[];
  private fixed: Fixed = "machine";

  constructor(readonly machine: Machine) {
    const bySide = <T>(make: () => T): Record<Side, T> => ({ table: make(), head: make(), bed: make() });
    this.solid = bySide(() => new MeshLambertMaterial({ flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
    this.edge = bySide(() => new LineBasicMaterial({ transparent: true }));
    this.arrowLine = bySide(() => new LineBasicMaterial());
    this.arrowHead = bySide(() => new MeshBasicMaterial());
    this.axes = machine.joints.map(() => 0);
    this.workpiece.name = "workpiece";
    this.links.push(this.workpiece);
    for (const joint of machine.joints) {
      const link = new Group();
      link.name = `joint ${joint.letter}`;
      this.links.at(-1)?.add(link);
      this.links.push(link);
    }
    for (const link of this.links) {
      link.matrixAutoUpdate = false;
      for (const side of SIDES) this.bodies[side].push(this.child(link));
      this.slides.push(this.child(link));
      this.centreLines.push(this.child(link));
      this.arrows.push(this.child(link));
      this.slideArrows.push(this.child(link));
    }
    this.tool = new ToolBody(machine.tool_axis);
    this.links.at(-1)?.add(this.tool.object);
  }

  /** Builds the bodies for one set-up and one tool. */
  build(input: Omit<LayoutInput, "machine">, tool: Tool, parts: ToolPart[] | null): void {
    this.points = input.points;
    for (const group of [...SIDES.flatMap((side) => this.bodies[side]), ...this.slides, ...this.centreLines, ...this.arrows, ...this.slideArrows]) {
      empty(group);
    }
    this.labels = [];
    const layout = layOut({ machine: this.machine, ...input });
    this.unitMm = layout.unitMm;
    this.centre.dashSize = 0.3 * layout.unitMm;
    this.centre.gapSize = 0.08 * layout.unitMm;
    for (const body of layout.bodies) this.addBody(body);
    for (const arrow of layout.arrows) this.addArrow(arrow);
    this.tool.show(tool, parts);
    this.move(this.axes);
  }

  /** Adds a group to a link: it moves with it. */
  attach(object: Group, link: number): void {
    this.links[link].add(object);
    this.attached.push(object);
  }

  /** Material of the bodies of a side, and that of their edges. */
  material(side: Side): MeshLambertMaterial {
    return this.solid[side];
  }

  edgeMaterial(side: Side): LineBasicMaterial {
    return this.edge[side];
  }

  /** Moves the machine to axis values in mm and degrees. */
  move(axes: number[]): void {
    this.axes = axes;
    this.machine.joints.forEach((joint, i) => {
      this.links[i + 1].matrix.fromArray(jointMatrix(joint, this.points[i], axes[i]));
    });
    this.workpiece.matrix.identity();
    if (this.fixed === "machine") {
      // The bed is at rest: the workpiece is where its own joints carry it.
      const bedFromWorkpiece = new Matrix4();
      for (let i = 1; i <= this.machine.frame_after; i += 1) bedFromWorkpiece.multiply(this.links[i].matrix);
      this.workpiece.matrix.copy(bedFromWorkpiece.invert());
    }
    this.workpiece.updateMatrixWorld(true);
  }

  hold(fixed: Fixed): void {
    this.fixed = fixed;
    this.move(this.axes);
  }

  /** Axis values of the machine as it is drawn, mm and degrees. */
  drawnJoints(): number[] {
    return this.machine.joints.map((joint, i) => jointValue(joint, this.links[i + 1].matrix.elements as Matrix, this.axes[i]));
  }

  /** Tip of the tool as it is drawn, workpiece coordinates in mm. */
  drawnTip(): Triple {
    const workpieceFromWorld = this.workpiece.matrixWorld.clone().invert();
    const tip = new Vector3().setFromMatrixPosition(workpieceFromWorld.multiply(this.tool.object.matrixWorld));
    return [tip.x, tip.y, tip.z];
  }

  /** Tool axis as it is drawn, workpiece frame. */
  drawnToolAxis(): Triple {
    const workpieceFromWorld = this.workpiece.matrixWorld.clone().invert();
    const axis = new Vector3().setFromMatrixColumn(workpieceFromWorld.multiply(this.tool.object.matrixWorld), 2);
    return [axis.x, axis.y, axis.z];
  }

  setStyle(style: MachineStyle): void {
    for (const side of SIDES) {
      const material = this.solid[side];
      material.visible = style !== "off";
      material.transparent = style === "ghost";
      material.opacity = style === "ghost" ? 0.16 : 1;
      material.depthWrite = style === "solid";
      material.needsUpdate = true;
      this.edge[side].visible = style !== "off";
      this.edge[side].opacity = style === "ghost" ? 0.55 : 0.8;
    }
  }

  showSide(side: Side, visible: boolean): void {
    for (const group of this.bodies[side]) group.visible = visible;
  }

  showSlides(visible: boolean): void {
    for (const group of this.slides) group.visible = visible;
  }

  /** Box around workpiece side, tool side and tool, without slides and machine frame, in the world as it is now. */
  coreBox(): Box3 {
    const box = new Box3();
    for (const group of [...this.bodies.table, ...this.bodies.head, this.tool.object]) box.expandByObject(group, true);
    return box;
  }

  /**
   * Places around what is shown: corners of each body, and labels. Without `slides` only what the workpiece and the
   * tool are on.
   */
  places(slides: boolean): Vector3[] {
    const groups = [...this.bodies.table, ...this.bodies.head, this.tool.object];
    if (slides) groups.push(...this.bodies.bed, ...this.slides, ...this.centreLines, ...this.arrows, ...this.slideArrows, ...this.attached);
    const places: Vector3[] = [];
    const box = new Box3();
    for (const group of groups) {
      group.traverseVisible((child) => {
        if (!(child instanceof Mesh || child instanceof Line)) {
          if (this.labels.some((label) => label.object === child)) places.push(new Vector3().setFromMatrixPosition(child.matrixWorld));
          return;
        }
        const geometry = child.geometry as BufferGeometry;
        if (!geometry.boundingBox) geometry.computeBoundingBox();
        box.copy(geometry.boundingBox ?? box.makeEmpty());
        for (const x of [box.min.x, box.max.x]) {
          for (const y of [box.min.y, box.max.y]) {
            for (const z of [box.min.z, box.max.z]) places.push(new Vector3(x, y, z).applyMatrix4(child.matrixWorld));
          }
        }
      });
    }
    return places;
  }

  showCentreLines(visible: boolean): void {
    for (const group of this.centreLines) group.visible = visible;
  }

  /** Arrows of rotary axes, and of slides. */
  showArrows(rotary: boolean, slides: boolean): void {
    for (const group of this.arrows) group.visible = rotary;
    for (const group of this.slideArrows) group.visible = slides;
  }

  restyle(): void {
    for (const side of SIDES) {
      this.solid[side].color.set(styleColour(`--${side}-body`));
      this.edge[side].color.set(styleColour(`--${side}-edge`));
      this.arrowLine[side].color.set(styleColour(`--${side}-arrow`));
      this.arrowHead[side].color.set(styleColour(`--${side}-arrow`));
    }
    this.centre.color.set(styleColour("--centre-line"));
    this.tool.restyle();
  }

  private child(parent: Group): Group {
    const group = new Group();
    parent.add(group);
    return group;
  }

  private addBody(body: Body): void {
    const { shape, side, link } = body;
    if (shape.shape === "line") {
      const centreLine = body.role === "centre-line";
      const material = centreLine ? this.centre : body.role === "rail" ? this.edge[side] : this.arrowLine[side];
      const line = new Line(lineGeometry([shape.from, shape.to]), material);
      if (centreLine) line.computeLineDistances();
      (centreLine ? this.centreLines : body.role === "rail" ? this.slides : this.bodies[side])[link].add(line);
      return;
    }
    const mesh = new Mesh(
      shape.shape === "cylinder"
        ? new CylinderGeometry(shape.radius, shape.radius, shape.height, 48)
        : new BoxGeometry(...shape.size),
      this.solid[side],
    );
    if (shape.shape === "cylinder") {
      mesh.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...shape.axis));
    } else {
      const third = cross(shape.along, shape.across);
      mesh.quaternion.setFromRotationMatrix(
        new Matrix4().makeBasis(new Vector3(...shape.along), new Vector3(...shape.across), new Vector3(...third)),
      );
    }
    mesh.position.set(...shape.centre);
    mesh.add(new LineSegments(new EdgesGeometry(mesh.geometry, 25), this.edge[side]));
    const slide = body.role === "carriage" || body.role === "rail" || body.role === "stop";
    (slide ? this.slides : this.bodies[side])[link].add(mesh);
  }

  private addArrow(arrow: Arrow): void {
    const joint = this.machine.joints[arrow.joint];
    const group = (joint.rotary ? this.arrows : this.slideArrows)[arrow.link];
    const { path, side } = arrow;
    const places = path.kind === "straight" ? straight(path) : arc(path);
    const end = places[places.length - 1];
    const before = places[places.length - 2];
    if (!arrow.held) {
      const cone = new Mesh(new ConeGeometry(0.045 * this.unitMm, 0.15 * this.unitMm, 16), this.arrowHead[side]);
      cone.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), new Vector3(...unit(subtract(end, before)))));
      cone.position.set(...end);
      group.add(new Line(lineGeometry(places), this.arrowLine[side]), cone);
    }
    const label = new Group();
    // Past the head of the arrow, so that it does not cover it.
    const past = 0.14 * this.unitMm;
    const heading = unit(subtract(end, before));
    label.position.set(...(arrow.held ? places[0] : add(end, scale(heading, past))));
    group.add(label);
    const part = side === "table" ? "workpiece side" : "tool side";
    this.labels.push({
      object: label,
      text: arrow.held ? `${joint.letter} held` : `${joint.letter}+`,
      kind: side,
      title: arrow.held
        ? `${joint.letter} is held`
        : `${joint.letter}: the body moves along the arrow while the value grows (${part})`,
    });
  }
}

const straight = (path: Extract<Arrow["path"], { kind: "straight" }>): Triple[] => [
  path.from,
  add(path.from, scale(path.direction, path.length)),
];

function arc(path: Extract<Arrow["path"], { kind: "arc" }>): Triple[] {
  const side = cross(path.axis, path.from);
  return Array.from({ length: 25 }, (_, i) => {
    const angle = (i / 24) * path.sweepRad;
    const offset = add(scale(path.from, Math.cos(angle)), scale(side, Math.sin(angle)));
    return add(path.centre, scale(offset, path.radius));
  });
}

function lineGeometry(places: Triple[]): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(new Float32Array(places.flat()), 3));
  return geometry;
}

function empty(group: Group): void {
  group.traverse((child) => {
    if (child instanceof Mesh || child instanceof Line) child.geometry.dispose();
  });
  group.clear();
}
