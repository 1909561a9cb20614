/** The simulation of a program as the postprocessor writes it: the JSON of the element `simulation`. Lengths in mm. */

import type { Column, Triple } from "./contract.ts";
import { decodeColumns, unpack } from "./decode.ts";

/** Rows of numbers: compressed columns in base64. */
interface Table {
  rows: number;
  columns: Column[];
  data: string;
}

export type Role = "machined" | "design" | "machine" | "fixture";

interface RawBody {
  name: string;
  role: Role;
  link: number;
  set_ups: number[];
  vertices: Table;
  faces: Table;
}

interface RawStage {
  set_up: number;
  corners: [Triple, Triple];
  counts: Triple;
  material: Table;
  removed: Table;
}

/** A contact, or two bodies that are too near to each other. */
export interface SimulatedFinding {
  kind: string;
  text: string;
  line: number;
  last_line: number;
  cl_line: number;
  operation: number;
  tool: number;
  place_mm: Triple;
}

/** A place where the machined stock is not as the design. */
export interface Region {
  text: string;
  deviation_mm: number;
  place_mm: Triple;
  blank: boolean;
  line: number | null;
  cl_line: number | null;
}

export interface DesignFigures {
  gouge_tolerance_mm: number;
  rest_tolerance_mm: number;
  design_tolerance_mm: number;
  certified_mm: number;
  largest_gouge_mm: number;
  largest_rest_mm: number;
  exceeds_stock_mm: number;
  gouge_count: number;
  rest_count: number;
  gouges: Region[];
  rests: Region[];
  histogram: { from_mm: number | null; to_mm: number | null; ends: number }[];
}

export interface Clearance {
  bodies: [string, string];
  distance_mm: number;
  line: number;
  cl_line: number;
  tool: number;
  place_mm: Triple;
}

export interface Figures {
  passed: boolean;
  motions: number;
  collisions: number;
  removed_mm3: number;
  pitch_mm: Triple;
  tolerance_mm: number;
  taking_part: string[];
  assumed: string[];
  not_checked: string[];
  tool_table: string[];
  operations: { operation: number; tool: number; removed_mm3: number; cutting_min: number; largest_mm3_per_min: number | null; largest_line: number | null }[];
  engagement: { step_min: number; removed_mm3: number[] };
  findings: SimulatedFinding[];
  clearances: Clearance[];
  design: DesignFigures | null;
}

interface RawSimulation {
  format: number;
  line: string;
  figures: Figures;
  bodies: RawBody[];
  tools: [number, ToolPart[]][];
  link_places: Triple[][];
  part_places: (number[] | null)[];
  stages: RawStage[] | null;
}

/** A part of a tool: convex outlines of radii and heights above the tip. */
export interface ToolPart {
  part: "cutter" | "shank" | "holder";
  outlines: [number, number][][];
}

/** A body as triangles. */
export interface SolidBody {
  name: string;
  role: Role;
  /** 0 has the part, the last link the tool. */
  link: number;
  /** Indices of the set-ups in which it is there; empty: all. */
  setUps: number[];
  positions: Float32Array;
  faces: Uint32Array;
  /** Deviation from the design at each vertex; NaN: unknown. Only of the machined stock. */
  deviations: Float64Array | null;
  /** Line of the program that has cut each vertex; 0: the blank, -1: unknown. */
  lines: Float64Array | null;
}

/** Parts of lines of a stock. */
export interface Parts {
  /** Number of the line over all families. */
  stockLine: Float64Array;
  low: Float64Array;
  high: Float64Array;
  /** Line of the program. */
  line: Float64Array;
}

/** The stock as it is cut in one set-up. */
export interface Stage {
  setUp: number;
  corners: [Triple, Triple];
  counts: Triple;
  material: Parts;
  removed: Parts;
}

export interface Simulation {
  line: string;
  figures: Figures;
  bodies: SolidBody[];
  tools: Map<number, ToolPart[]>;
  linkPlaces: Triple[][];
  partPlaces: (number[] | null)[];
  stages: Stage[] | null;
}

type Columns = Map<string, Float64Array>;

async function columnsOf(table: Table): Promise<Columns> {
  return decodeColumns({ columns: table.columns, points: table.rows }, await unpack(table.data, true));
}

function column(columns: Columns, name: string): Float64Array {
  const found = columns.get(name);
  if (!found) throw new Error(`the simulation has no column \`${name}\``);
  return found;
}

async function body(raw: RawBody): Promise<SolidBody> {
  const vertices = await columnsOf(raw.vertices);
  const faces = await columnsOf(raw.faces);
  return {
    name: raw.name,
    role: raw.role,
    link: raw.link,
    setUps: raw.set_ups,
    positions: Float32Array.from(interleaved(["x", "y", "z"].map((name) => column(vertices, name)))),
    faces: Uint32Array.from(interleaved(["a", "b", "c"].map((name) => column(faces, name)))),
    deviations: vertices.get("value") ?? null,
    lines: vertices.get("line") ?? null,
  };
}

function interleaved(columns: Float64Array[]): Float64Array {
  const values = new Float64Array(columns.length * columns[0].length);
  columns.forEach((from, place) => {
    for (let i = 0; i < from.length; i += 1) values[i * columns.length + place] = from[i];
  });
  return values;
}

async function parts(table: Table): Promise<Parts> {
  const columns = await columnsOf(table);
  const [stockLine, low, high, line] = ["stock_line", "low", "high", "line"].map((name) => column(columns, name));
  return { stockLine, low, high, line };
}

async function stage(raw: RawStage): Promise<Stage> {
  return { setUp: raw.set_up, corners: raw.corners, counts: raw.counts, material: await parts(raw.material), removed: await parts(raw.removed) };
}

/** The simulation of a page from the text of its element. */
export async function readSimulation(text: string): Promise<Simulation> {
  const raw = JSON.parse(text) as RawSimulation;
  if (raw.format !== 1) throw new Error(`this page reads simulations of format 1, and its data has format ${String(raw.format)}`);
  return {
    line: raw.line,
    figures: raw.figures,
    bodies: await Promise.all(raw.bodies.map(body)),
    tools: new Map(raw.tools),
    linkPlaces: raw.link_places,
    partPlaces: raw.part_places,
    stages: raw.stages ? await Promise.all(raw.stages.map(stage)) : null,
  };
}
