/**
 * The bodies of a simulation: machined stock, stock as it is cut, design, solids of the machine, and a place to look
 * at.
 */

import { BufferAttribute, BufferGeometry, Color, DoubleSide, EdgesGeometry, Group, LineSegments, Matrix4, Mesh, MeshLambertMaterial, type LineBasicMaterial } from "three";
import { deviationColours, limitsOf, plainColour, type DeviationLimits } from "../colour/deviation.ts";
import type { Rgb, Theme } from "../colour/scale.ts";
import type { Triple } from "../data/contract.ts";
import type { Program } from "../data/program.ts";
import type { Simulation, SolidBody, Stage } from "../data/simulation.ts";
import { StockLines } from "../stock/lines.ts";
import { surfaceOf } from "../stock/nets.ts";
import { styleColour } from "../theme.ts";
import { Ring } from "./highlight.ts";
import type { Side } from "./layout.ts";
import type { MachineScene } from "./machine.ts";

/** Which stock is shown: the result, as it is at the position of the program, or none. */
export type StockShown = "result" | "cut" | "off";

/** Edges of solids from this angle on are drawn, degrees. */
const EDGE_DEGREES = 25;

export class SimulatedScene {
  stock: StockShown = "result";
  readonly limits: DeviationLimits | null;
  private readonly machined: Mesh<BufferGeometry, MeshLambertMaterial> | null = null;
  private readonly cut: Mesh<BufferGeometry, MeshLambertMaterial>;
  private readonly part = new Group();
  private readonly design = new Group();
  private readonly designMaterial = new MeshLambertMaterial({ transparent: true, opacity: 0.45, depthWrite: false, side: DoubleSide });
  private readonly fixtureMaterial = new MeshLambertMaterial({ flatShading: true, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 });
  private readonly links: Group[] = [];
  private readonly solids: { body: SolidBody; mesh: Mesh }[] = [];
  private readonly ring: Ring;
  private readonly stages = new Map<Stage, StockLines>();
  private setUp = -1;
  private position = 0;
  private cutIsOld = true;
  private shownLines: StockLines | null = null;
  private solidsVisible = true;
  private placeSetUp: number | null = null;

  constructor(
    readonly simulation: Simulation,
    private readonly program: Program,
    private readonly machine: MachineScene,
    pixelRatio: number,
    private theme: Theme,
  ) {
    const { design } = simulation.figures;
    this.limits = design ? limitsOf(design) : null;
    this.part.matrixAutoUpdate = false;
    this.cut = new Mesh(new BufferGeometry(), new MeshLambertMaterial({ flatShading: true }));
    this.cut.name = "stock as it is cut";
    this.ring = new Ring("--mark-finding", 22, pixelRatio);
    this.ring.object.visible = false;
    machine.workpiece.add(this.part, this.cut, this.ring.object);
    for (let link = 0; link <= program.head.machine.joints.length; link += 1) {
      const group = new Group();
      this.links.push(group);
      machine.attach(group, link);
    }
    for (const body of simulation.bodies) {
      if (body.role === "machined") {
        this.machined = new Mesh(geometryOf(body), new MeshLambertMaterial({ flatShading: true, vertexColors: true, side: DoubleSide }));
        this.machined.name = body.name;
        this.part.add(this.machined);
      } else if (body.role === "design") {
        const geometry = geometryOf(body);
        geometry.computeVertexNormals();
        this.design.add(new Mesh(geometry, this.designMaterial));
        this.part.add(this.design);
      } else {
        this.addSolid(body);
      }
    }
  }

  get hasSolids(): boolean {
    return this.solids.length > 0;
  }

  get hasDesign(): boolean {
    return this.design.children.length > 0;
  }

  get hasStages(): boolean {
    return this.simulation.stages !== null;
  }

  showStock(stock: StockShown): void {
    this.stock = stock;
    this.showParts();
  }

  showDesign(on: boolean): void {
    this.design.visible = on;
  }

  showSolids(on: boolean): void {
    this.solidsVisible = on;
    this.showParts();
  }

  /** Marks a place of a set-up, or none. Places of the machined stock have no set-up. */
  mark(place: Triple | null, setUp: number | null): void {
    const parent = setUp === null ? this.part : this.machine.workpiece;
    if (this.ring.object.parent !== parent) parent.add(this.ring.object);
    this.placeSetUp = setUp;
    this.ring.show(place);
    if (setUp !== null && setUp !== this.setUp) this.ring.object.visible = false;
  }

  /** Puts the bodies where they are with a placement. */
  place(placement: number): void {
    const setUp = this.program.head.placements[placement].set_up;
    this.setUp = setUp;
    this.links.forEach((group, link) => {
      const place = this.simulation.linkPlaces[placement]?.[link];
      if (place) group.position.set(...place);
    });
    const matrix = this.simulation.partPlaces[setUp];
    if (matrix) this.part.matrix.fromArray(matrix);
    this.part.matrixWorldNeedsUpdate = true;
    if (this.placeSetUp !== null && this.placeSetUp !== setUp) this.ring.object.visible = false;
    this.cutIsOld = true;
    this.showParts();
  }

  seek(position: number): void {
    this.position = position;
    this.cutIsOld = true;
  }

  /** Before a frame: the stock as it is cut, if it is shown. */
  prepare(): void {
    if (this.stock !== "cut" || !this.cutIsOld) return;
    this.cutIsOld = false;
    const stage = this.stage();
    const before = this.shownLines;
    this.shownLines = stage ? this.linesOf(stage) : null;
    this.cut.visible = this.shownLines !== null;
    if (!this.shownLines) return;
    const changed = this.shownLines.seek(this.doneLine());
    if (!changed && before === this.shownLines) return;
    const { positions, faces } = surfaceOf(this.shownLines);
    this.cut.geometry.dispose();
    this.cut.geometry = new BufferGeometry();
    this.cut.geometry.setAttribute("position", new BufferAttribute(positions, 3));
    this.cut.geometry.setIndex(new BufferAttribute(faces, 1));
  }

  /** Volume of the stock at the position, mm³; `null` where it is not known. */
  volume(): number | null {
    const stage = this.stage();
    if (!stage) return null;
    const lines = this.linesOf(stage);
    lines.seek(this.doneLine());
    this.cutIsOld = true;
    this.shownLines = null;
    return lines.volume();
  }

  /** Origins of the solids' coordinates as they are drawn, workpiece coordinates. */
  origins(): Record<string, Triple> {
    const fromWorld = this.machine.workpiece.matrixWorld.clone().invert();
    return Object.fromEntries(
      this.solids.map(({ body, mesh }) => {
        const { elements } = new Matrix4().multiplyMatrices(fromWorld, mesh.matrixWorld);
        return [body.name, [elements[12], elements[13], elements[14]] as Triple];
      }),
    );
  }

  restyle(theme: Theme): void {
    this.theme = theme;
    if (this.machined) {
      const body = this.simulation.bodies.find((each) => each.role === "machined");
      const count = this.machined.geometry.getAttribute("position").count;
      const colours = deviationColours(body?.deviations ?? null, count, this.limits, theme, linear);
      this.machined.geometry.setAttribute("color", new BufferAttribute(colours, 3));
    }
    this.cut.material.color.setRGB(...linear(plainColour(this.theme)));
    this.designMaterial.color.set(styleColour("--design-body"));
    this.fixtureMaterial.color.set(styleColour("--fixture-body"));
    this.ring.restyle();
  }

  private addSolid(body: SolidBody): void {
    const { frame_after } = this.program.head.machine;
    const side: Side = body.link === frame_after ? "bed" : body.link < frame_after ? "table" : "head";
    const fixture = body.role === "fixture";
    const geometry = geometryOf(body);
    const mesh = new Mesh(geometry, fixture ? this.fixtureMaterial : this.machine.material(side));
    mesh.name = body.name;
    const edge: LineBasicMaterial = this.machine.edgeMaterial(fixture ? "bed" : side);
    mesh.add(new LineSegments(new EdgesGeometry(geometry, EDGE_DEGREES), edge));
    this.links[body.link].add(mesh);
    this.solids.push({ body, mesh });
  }

  private showParts(): void {
    const known = this.simulation.partPlaces[this.setUp] !== null;
    if (this.machined) this.machined.visible = this.stock === "result" && known;
    this.part.visible = known;
    this.cut.visible = this.stock === "cut";
    for (const { body, mesh } of this.solids) {
      mesh.visible = this.solidsVisible && (body.setUps.length === 0 || body.setUps.includes(this.setUp));
    }
  }

  private stage(): Stage | null {
    return this.simulation.stages?.find((stage) => stage.setUp === this.setUp) ?? null;
  }

  private linesOf(stage: Stage): StockLines {
    const lines = this.stages.get(stage) ?? new StockLines(stage);
    this.stages.set(stage, lines);
    return lines;
  }

  /** Last line of the program whose motion is done at the position. */
  private doneLine(): number {
    const { program } = this;
    const point = Math.floor(this.position);
    const line = program.line[point];
    return point === program.blockLast(program.block[point]) ? line : line - 1;
  }
}

const linear = (colour: Rgb): Rgb => {
  const { r, g, b } = new Color().setRGB(...colour, "srgb");
  return [r, g, b];
};

function geometryOf(body: SolidBody): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(body.positions, 3));
  geometry.setIndex(new BufferAttribute(body.faces, 1));
  return geometry;
}
