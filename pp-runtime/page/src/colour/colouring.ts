/** What the path can be coloured by: a value or a category of each leg, with its legend. */

import type { Program } from "../data/program.ts";
import { axisUnit, formatValue } from "../format.ts";
import { categoryColour, cssColour, scaleColour, type Rgb, type Theme } from "./scale.ts";

/** Number of entries in the table of colours. */
export const TABLE_SIZE = 256;

export interface LegendEntry {
  label: string;
  colour: string;
  dashed: boolean;
}

export interface ScaleLegend {
  unit: string;
  min: number;
  max: number;
  /** Whether values outside exist; they have the colour of the end. */
  beyond: boolean;
  /** A value to mark, with its name. */
  mark: { value: number; label: string } | null;
}

/** One way to colour the path. */
export interface Colouring {
  name: string;
  label: string;
  /** For each point its place in the table of colours, 0 to 1; negative where there is no value. */
  shares(): Float32Array<ArrayBuffer>;
  /** `TABLE_SIZE` colours. */
  table(theme: Theme): Rgb[];
  legend(theme: Theme): { entries: LegendEntry[] } | { scale: ScaleLegend };
}

export function colourings(program: Program): Colouring[] {
  const { machine, tolerance_mm } = program.head;
  const list: Colouring[] = [byMotion(program), byOperation(program)];
  machine.joints.forEach((joint, i) => {
    if (joint.held) return;
    list.push(byValue(`axis.${joint.letter}`, `${joint.letter} value`, axisUnit(joint), program.axes[i], program, {}));
  });
  if (machine.joints.some((joint) => joint.rotary && !joint.held)) {
    list.push(byValue("rotary-speed", "rotary speed", "°/min", rotarySpeed(program), program, { fromZero: true }));
  }
  list.push(
    byValue("feed", "programmed feed", "mm/min", program.feed.map((feed) => (feed > 0 ? feed : Number.NaN)), program, {}),
    byValue("error", "path error", "µm", program.errorUm, program, {
      fromZero: true,
      mark: { value: tolerance_mm * 1000, label: "tolerance" },
    }),
  );
  return list;
}

/** Largest speed of the rotary axes in each leg, degrees/min. */
function rotarySpeed(program: Program): Float64Array {
  const fastest = new Float64Array(program.count).fill(Number.NaN);
  program.head.machine.joints.forEach((joint, axis) => {
    if (!joint.rotary || joint.held) return;
    program.speeds[axis].forEach((speed, i) => {
      if (!(fastest[i] >= speed)) fastest[i] = speed;
    });
  });
  return fastest;
}

function byMotion(program: Program): Colouring {
  const { kinds } = program.head;
  const shown = kinds.filter((kind) => kind !== "start" && kind !== "dwell");
  // Feed first and rapid second, whatever the order of the kinds: their colours are always the same.
  const order = [...shown].sort((a, b) => rank(a) - rank(b));
  return byCategory("motion", "feed / rapid", order, (i) => order.indexOf(kinds[program.kind[i]]), program.count);
}

const rank = (kind: string): number => (kind === "feed" ? 0 : kind === "rapid" ? 1 : 2);

function byOperation(program: Program): Colouring {
  const names = program.head.operations.map((operation) => `${operation.number}. ${operation.name}`);
  return byCategory("operation", "operation", names, (i) => program.operation[i], program.count);
}

function byCategory(
  name: string,
  label: string,
  names: string[],
  categoryOf: (point: number) => number,
  count: number,
): Colouring {
  const shares = (): Float32Array<ArrayBuffer> => {
    const values = new Float32Array(count);
    for (let i = 0; i < count; i += 1) {
      const category = categoryOf(i);
      values[i] = category >= 0 && category < names.length ? ((category % TABLE_SIZE) + 0.5) / TABLE_SIZE : -1;
    }
    return values;
  };
  return {
    name,
    label,
    shares,
    table: (theme) => Array.from({ length: TABLE_SIZE }, (_, i) => categoryColour(i, theme)),
    legend: (theme) => ({
      entries: names.map((each, i) => ({
        label: each,
        colour: cssColour(categoryColour(i % TABLE_SIZE, theme)),
        dashed: each === "rapid",
      })),
    }),
  };
}

interface ValueOptions {
  fromZero?: boolean;
  mark?: { value: number; label: string };
}

function byValue(
  name: string,
  label: string,
  unit: string,
  values: Float64Array,
  program: Program,
  options: ValueOptions,
): Colouring {
  const range = rangeOf(values, program, options);
  return {
    name,
    label,
    shares: () => {
      const span = range.max - range.min;
      return Float32Array.from(values, (value) => {
        if (Number.isNaN(value)) return -1;
        return span > 0 ? Math.min(Math.max((value - range.min) / span, 0), 1) : 0.5;
      });
    },
    table: (theme) => Array.from({ length: TABLE_SIZE }, (_, i) => scaleColour(i / (TABLE_SIZE - 1), theme)),
    legend: () => ({ scale: { unit, mark: options.mark ?? null, ...range } }),
  };
}

/** Range of the scale: the values of the drawn legs; where a few are far above the others, up to 99.5 % of them. */
function rangeOf(
  values: Float64Array,
  program: Program,
  options: ValueOptions,
): { min: number; max: number; beyond: boolean } {
  const drawn = values.filter((value, i) => !Number.isNaN(value) && !program.isStart(i)).sort();
  if (drawn.length === 0) return { min: 0, max: 0, beyond: false };
  const largest = drawn[drawn.length - 1];
  let max = largest;
  if (options.fromZero) {
    const usual = drawn[Math.floor((drawn.length - 1) * 0.995)];
    if (usual > 0 && usual < largest / 2) max = usual;
    if (options.mark) max = Math.max(max, options.mark.value);
  }
  return { min: options.fromZero ? 0 : drawn[0], max, beyond: largest > max };
}

/** Text of a value on the scale. */
export const scaleText = (value: number, unit: string): string => `${formatValue(value)} ${unit}`;
