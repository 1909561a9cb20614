/**
 * The data of a page as the postprocessor writes it: the JSON of the element `program-head`.
 *
 * Lengths in mm, angles in degrees, times in seconds. The columns of numbers are described in `decode.ts`.
 */

/** Three numbers: a point in mm or a direction. */
export type Triple = [number, number, number];

/** One axis of the chain. The tip on the workpiece is the product of all joints, applied to the origin. */
export interface Joint {
  letter: string;
  rotary: boolean;
  held: boolean;
  /** Unit vector, machine frame, all axes at zero. */
  direction: Triple;
  /** A point of the centre line, workpiece frame of the zero position, first set-up and tool. */
  point: Triple;
  /** -1 where the word counts in the opposite direction. */
  sign: 1 | -1;
  /** Limits in mm or degrees; of a linear axis in machine coordinates. */
  min: number | null;
  max: number | null;
  /** Largest speed, mm/min or degrees/min. */
  speed: number | null;
}

export interface Machine {
  name: string;
  /** From the workpiece to the tool. */
  joints: Joint[];
  /** From the tip to the spindle, in the frame of the last joint. */
  tool_axis: Triple;
  /** Number of joints on the workpiece side of the machine frame (bed). */
  frame_after: number;
}

/** Points of the joints for one set-up and one tool. */
export interface Placement {
  set_up: number;
  /** Number of the tool; 0 with none in the spindle. */
  tool: number;
  points: Triple[];
  /** Machine coordinate of each axis less its axis value; `null` where the machine zero is not configured. */
  zero?: (number | null)[];
}

export interface Tool {
  number: number;
  name: string;
  kind: string;
  diameter: number | null;
  corner_radius: number | null;
  length: number | null;
  flute_length: number | null;
  /** `null` where it is unknown: the chain then has gauge length 0. */
  gauge_length: number | null;
  /** Height above the tip and radius, from the tip up; `null` where the shape is unknown. */
  profile: [number, number][] | null;
  first_point: number;
  points: number;
  seconds: number;
}

export interface Operation {
  /** Number in the CL data. */
  number: number;
  name: string;
  /** Number of the tool. */
  tool: number;
  set_up: number;
  mode: string;
  first_point: number;
  points: number;
  seconds: number;
}

export interface SetUp {
  name: string;
  work_offset: string;
  part_origin: Triple;
  first_point: number;
}

/** A finding of the check. */
export interface Finding {
  line: number;
  last_line: number;
  cl_line: number;
  text: string;
  help: string | null;
  point: number | null;
}

export type ColumnType = "f32" | "u16" | "u8" | "q32";

export interface Column {
  name: string;
  type: ColumnType;
  /** Of `q32`: value of one unit. */
  scale?: number;
}

/** Motions that are not as they are drawn. */
export interface Path {
  /** In some rapids each axis moves on its own, so that their path is not the line drawn. */
  rapids_apart: boolean;
  /** Lines with a motion to a machine position that is not drawn, because the machine zero is unknown. */
  undrawn: number[];
}

export interface Head {
  format: 1;
  compressed: boolean;
  program: string;
  cl: string;
  control: string;
  machine: Machine;
  tools: Tool[];
  operations: Operation[];
  set_ups: SetUp[];
  placements: Placement[];
  findings: Finding[];
  warnings: string[];
  summary: string[];
  tolerance_mm: number;
  path: Path;
  points: number;
  columns: Column[];
  /** Names of the reasons for a block, and a sentence for each. */
  reasons: string[];
  reason_texts: string[];
  kinds: string[];
  seconds: number;
}
