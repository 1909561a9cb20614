/** The scene as a whole: path, machine, marks and what the reader does with them. */

import { Box3, Matrix4, Vector3 } from "three";
import type { Colouring } from "../colour/colouring.ts";
import type { Theme } from "../colour/scale.ts";
import type { Triple } from "../data/contract.ts";
import { Program, type MarkKind } from "../data/program.ts";
import type { Simulation } from "../data/simulation.ts";
import { BlockLine, Ring } from "./highlight.ts";
import { Labels } from "./labels.ts";
import { Layers } from "./layers.ts";
import { MachineScene, type Fixed, type MachineStyle } from "./machine.ts";
import { AxisTicks, MARKS, MARK_KINDS, PathMarks } from "./marks.ts";
import { Path, type PathExtent } from "./path.ts";
import { pick } from "./pick.ts";
import { SimulatedScene, type StockShown } from "./simulated.ts";
import { CornerTriad, OriginTriad } from "./triad.ts";
import { View, type StandardView } from "./view.ts";

/** Largest movement of a press that still is a click, px. */
const CLICK_PX = 5;

export interface StageEvents {
  /** The leg under the pointer, with the place of the pointer in the view. */
  hover: (point: number | null, x: number, y: number) => void;
  click: (point: number) => void;
}

export class Stage {
  readonly view: View;
  readonly layers = new Layers();
  readonly machine: MachineScene;
  /** Bodies of the simulation, where the page has one. */
  readonly simulated: SimulatedScene | null;
  fixed: Fixed = "machine";
  machineStyle: MachineStyle = "solid";
  extent: PathExtent = "whole";
  private readonly path: Path;
  private readonly marks: PathMarks[] = [];
  private readonly origin = new OriginTriad();
  private readonly labels: Labels;
  private readonly corner: CornerTriad;
  private readonly currentBlock: BlockLine;
  private readonly hoverBlock: BlockLine;
  private readonly currentRing: Ring;
  private readonly hoverRing: Ring;
  private ticks: AxisTicks | null = null;
  private placement = -1;
  private setUp = -1;
  private position = 0;
  private cuttingBox = new Box3();

  constructor(
    private readonly program: Program,
    container: HTMLElement,
    private readonly events: StageEvents,
    colouring: Colouring,
    private theme: Theme,
    simulation: Simulation | null,
  ) {
    const ratio = Math.min(devicePixelRatio, 2);
    this.view = new View(container, program.count);
    this.machine = new MachineScene(program.head.machine);
    this.view.scene.add(this.machine.workpiece);
    this.simulated = simulation && new SimulatedScene(simulation, program, this.machine, ratio, theme);
    this.view.onFrame(() => this.simulated?.prepare());
    this.path = new Path(program, colouring, theme);
    this.currentBlock = new BlockLine(program, "--accent", 4);
    this.hoverBlock = new BlockLine(program, "--hover", 3);
    this.currentRing = new Ring("--accent", 17, ratio);
    this.hoverRing = new Ring("--hover", 15, ratio);
    this.hoverRing.object.visible = false;
    this.machine.workpiece.add(
      this.path.object,
      this.currentBlock.object,
      this.hoverBlock.object,
      this.currentRing.object,
      this.hoverRing.object,
      this.origin.object,
    );
    for (const kind of MARK_KINDS) {
      const marks = PathMarks.of(program, kind, ratio);
      if (!marks) continue;
      this.marks.push(marks);
      this.machine.workpiece.add(marks.object);
    }
    this.labels = new Labels(this.view);
    this.corner = new CornerTriad(this.view);
    this.corner.name(this.fixed);
    this.makeLayers();
    // Solids of a real machine would hide the part.
    if (this.simulated?.hasSolids) this.machineStyle = "ghost";
    this.machine.setStyle(this.machineStyle);
    this.restyle(theme);
    this.seek(0);
    // What is looked at first is the part.
    if (this.simulated) this.setFixed("part");
    this.listen();
  }

  /** Moves the machine to a position of the program. */
  seek(position: number): void {
    this.position = position;
    const point = Program.pointAt(position);
    this.place(this.program.placement[Math.floor(position)]);
    this.machine.move(this.program.axesBetween(position));
    this.simulated?.seek(position);
    this.currentBlock.show(this.program.block[point]);
    this.currentRing.show(this.machine.drawnTip());
    this.showRange();
    this.view.request();
  }

  /** Marks a point of the path as the one that the reader looks at. */
  hover(point: number | null): void {
    this.hoverBlock.show(point === null ? null : this.program.block[point]);
    this.hoverRing.show(point === null ? null : this.program.tipAt(point));
    this.view.request();
  }

  colour(colouring: Colouring): void {
    this.path.colour(colouring, this.theme);
    this.view.request();
  }

  restyle(theme: Theme): void {
    this.theme = theme;
    this.path.restyle(theme);
    this.machine.restyle();
    this.simulated?.restyle(theme);
    this.origin.restyle();
    this.ticks?.restyle();
    for (const marks of this.marks) marks.restyle();
    for (const part of [this.currentBlock, this.hoverBlock, this.currentRing, this.hoverRing]) part.restyle();
    this.view.restyle();
  }

  setFixed(fixed: Fixed): void {
    this.fixed = fixed;
    this.machine.hold(fixed);
    this.corner.name(fixed);
    for (const name of ["bed", "slides", "arrows"]) {
      const layer = this.layers.get(name);
      if (layer) layer.apply(layer.visible);
    }
    this.view.request();
  }

  setMachineStyle(style: MachineStyle): void {
    this.machineStyle = style;
    this.machine.setStyle(style);
    const arrows = this.layers.get("arrows");
    arrows?.apply(arrows.visible);
    this.view.request();
  }

  setStock(stock: StockShown): void {
    this.simulated?.showStock(stock);
    this.view.request();
  }

  /** Marks a place of a set-up; with none, a place of the machined stock. */
  markPlace(place: Triple, setUp: number | null): void {
    this.simulated?.mark(place, setUp);
    this.view.request();
  }

  setExtent(extent: PathExtent): void {
    this.extent = extent;
    this.showRange();
    this.view.request();
  }

  /** The box around the path of this set-up, in the world as it is now. */
  pathBox(): Box3 {
    return this.cuttingBox.clone().applyMatrix4(this.machine.workpiece.matrixWorld);
  }

  fit(everything: boolean): void {
    this.view.fit(everything ? this.machinePlaces() : corners(this.pathBox()));
  }

  /** A standard view: of the machine where the bed is at rest, of the path where the part is. */
  look(view: StandardView): void {
    this.view.look(view, this.fixed === "machine" && this.machineStyle !== "off" ? this.machinePlaces() : corners(this.pathBox()));
  }

  /** Table, head, tool and path are what a reader wants to see first; the path must not become a dot in them. */
  lookFirst(): void {
    this.look("iso");
    const core = this.machine.coreBox().union(this.pathBox());
    const path = this.pathBox();
    const ratio = core.max.distanceTo(core.min) / Math.max(path.max.distanceTo(path.min), 1e-6);
    this.view.fit(ratio < 12 && !this.simulated ? [...this.machine.places(false), ...corners(path)] : corners(path));
  }

  private machinePlaces(): Vector3[] {
    return [...this.machine.places(true), ...corners(this.pathBox())];
  }

  /** Looks along the tool axis, from the spindle to the tip. */
  lookAlongTool(): void {
    const axis = new Vector3().setFromMatrixColumn(this.machine.tool.object.matrixWorld, 2);
    // Exactly vertical has no direction on the screen: a hair beside it.
    if (Math.hypot(axis.x, axis.y) < 1e-4) axis.y -= 1e-4;
    this.view.lookFrom(axis);
    this.centreOnTool();
  }

  centreOnTool(): void {
    this.view.centreOn(new Vector3().setFromMatrixPosition(this.machine.tool.object.matrixWorld));
  }

  /** Leg under a place in the view, px. */
  pickAt(x: number, y: number): number | null {
    const { camera, size } = this.view;
    camera.updateMatrixWorld();
    const clip = new Matrix4()
      .multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse)
      .multiply(this.machine.workpiece.matrixWorld);
    const [first, last] = this.range();
    return pick({
      tip: this.program.tip,
      first,
      last,
      drawn: (point) => !this.program.isStart(point),
      clipFromWorkpiece: clip.elements,
      width: size.width,
      height: size.height,
      x,
      y,
    });
  }

  /** The bodies of the machine for a set-up and a tool, built when they change. */
  private place(index: number): void {
    if (index === this.placement) return;
    this.placement = index;
    const { program } = this;
    const placement = program.head.placements[index];
    const [first, end] = program.setUpRange(placement.set_up);
    if (this.setUp !== placement.set_up) {
      this.setUp = placement.set_up;
      this.cuttingBox = this.path.box(first, end, true);
      this.cuttingBox.expandByScalar(1);
    }
    const { min, max } = this.cuttingBox;
    const tool = program.toolOfNumber(placement.tool);
    this.machine.build(
      {
        points: placement.points,
        gaugeMm: tool.gauge_length ?? tool.length ?? 0,
        box: { min: [min.x, min.y, min.z], max: [max.x, max.y, max.z] },
        travel: program.axes.map((values, axis) => {
          const [low, high] = extremes(values, first, end);
          const [min, max] = program.limits(axis, index);
          return { min, max, low, high };
        }),
      },
      tool,
      this.simulated?.simulation.tools.get(placement.tool) ?? null,
    );
    this.simulated?.place(index);
    this.origin.size(0.35 * this.machine.unitMm);
    this.labels.set([...this.machine.labels, ...this.origin.labels]);
  }

  /** First and last point that is drawn. */
  private range(): [number, number] {
    const [first, end] = this.program.setUpRange(Math.max(this.setUp, 0));
    if (this.extent === "done") return [first, Math.floor(this.position)];
    if (this.extent === "operation") {
      const operation = this.program.head.operations[this.program.operation[Program.pointAt(this.position)]];
      if (operation) return [operation.first_point, operation.first_point + operation.points - 1];
    }
    return [first, end - 1];
  }

  private showRange(): void {
    const [first, last] = this.range();
    this.path.show(first, last);
    for (const marks of this.marks) marks.show(first, last);
    this.ticks?.show(first, last);
  }

  private makeLayers(): void {
    const layer = (name: string, label: string, sample: string | null, visible: boolean, key: string | null, apply: (on: boolean) => void): void =>
      this.layers.add({
        name,
        label,
        sample,
        visible,
        key,
        apply: (on) => {
          apply(on);
          this.view.request();
        },
      });
    const joints = this.program.head.machine.joints.length;
    const { frame_after } = this.program.head.machine;
    // Without solids the schematic machine serves.
    const schematic = !(this.simulated?.hasSolids ?? false);
    layer("path", "Tool path", null, true, null, (on) => {
      this.path.object.visible = on;
    });
    layer("ticks", "Tool axis ticks", "sample-tick", false, "A", (on) => this.showTicks(on));
    layer("tool", "Tool", "sample-tool", true, null, (on) => {
      this.machine.tool.object.visible = on;
    });
    if (frame_after > 0) layer("table", "Table side", "sample-table", schematic, null, (on) => this.machine.showSide("table", on));
    if (frame_after < joints) layer("head", "Head side", "sample-head", schematic, null, (on) => this.machine.showSide("head", on));
    // With the part at rest frame and slides would swing about it: they are shown with the bed at rest.
    layer("slides", "Slides (bed at rest)", null, schematic, null, (on) => {
      this.machine.showSlides(on && this.fixed === "machine");
      const arrows = this.layers.get("arrows");
      arrows?.apply(arrows.visible);
    });
    layer("bed", "Frame (bed at rest)", "sample-bed", schematic, null, (on) => this.machine.showSide("bed", on && this.fixed === "machine"));
    layer("centre-lines", "Centre lines", "sample-centre", true, null, (on) => this.machine.showCentreLines(on));
    layer("arrows", "Axis arrows", null, true, "L", (on) => {
      const shown = on && this.machineStyle !== "off";
      this.machine.showArrows(shown, shown && this.fixed === "machine" && (this.layers.get("slides")?.visible ?? true));
    });
    const { simulated } = this;
    if (simulated?.hasSolids) layer("solids", "Machine solids", "sample-bed", true, null, (on) => simulated.showSolids(on));
    if (simulated?.hasDesign) layer("design", "Design", "sample-design", false, "E", (on) => simulated.showDesign(on));
    layer("origin", "Workpiece origin", null, true, null, (on) => {
      this.origin.object.visible = on;
    });
    for (const marks of this.marks) {
      const { label } = MARKS[marks.kind as MarkKind | "finding"];
      const many = `${label.charAt(0).toUpperCase()}${label.slice(1)}${label.startsWith("near") ? "" : "s"}`;
      layer(`mark-${marks.kind}`, many, `mark mark-${marks.kind}`, marks.kind !== "inserted", null, (on) => {
        marks.object.visible = on;
      });
    }
  }

  private showTicks(on: boolean): void {
    if (on && !this.ticks) {
      this.ticks = new AxisTicks(this.program, 0.22 * this.machine.unitMm);
      this.ticks.restyle();
      this.machine.workpiece.add(this.ticks.object);
      this.showRange();
    }
    if (this.ticks) this.ticks.object.visible = on;
  }

  private listen(): void {
    const { canvas } = this.view;
    let pressed: { x: number; y: number } | null = null;
    let waiting = false;
    canvas.addEventListener("pointerdown", (event) => {
      pressed = { x: event.clientX, y: event.clientY };
      this.events.hover(null, 0, 0);
    });
    canvas.addEventListener("pointerup", (event) => {
      const click = pressed && Math.hypot(event.clientX - pressed.x, event.clientY - pressed.y) <= CLICK_PX;
      pressed = null;
      if (!click || event.button !== 0) return;
      const point = this.pickAt(event.offsetX, event.offsetY);
      if (point !== null) this.events.click(point);
    });
    canvas.addEventListener("pointercancel", () => {
      pressed = null;
    });
    canvas.addEventListener("pointermove", (event) => {
      if (pressed || waiting || event.pointerType === "touch") return;
      waiting = true;
      const { offsetX, offsetY } = event;
      requestAnimationFrame(() => {
        waiting = false;
        if (!pressed) this.events.hover(this.pickAt(offsetX, offsetY), offsetX, offsetY);
      });
    });
    canvas.addEventListener("pointerleave", () => this.events.hover(null, 0, 0));
  }
}

function corners(box: Box3): Vector3[] {
  const { min, max } = box;
  return [min.x, max.x].flatMap((x) => [min.y, max.y].flatMap((y) => [min.z, max.z].map((z) => new Vector3(x, y, z))));
}

function extremes(values: Float64Array, first: number, end: number): [number, number] {
  let low = Number.POSITIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (let i = first; i < end; i += 1) {
    if (values[i] < low) low = values[i];
    if (values[i] > high) high = values[i];
  }
  return low <= high ? [low, high] : [0, 0];
}

