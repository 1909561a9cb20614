import assert from "node:assert/strict";
import { test } from "node:test";
import type { Head } from "../src/data/contract.ts";
import { Program, lowerBound } from "../src/data/program.ts";
import { colourings } from "../src/colour/colouring.ts";

/** A machine with C and X; columns as given, all others 0. */
function program(given: Record<string, number[]>, change: Partial<Head> = {}): Program {
  const count = Object.values(given)[0].length;
  const joint = { held: false, point: [0, 0, 0] as [number, number, number], sign: 1 as const };
  const head: Head = {
    format: 1,
    compressed: false,
    program: "test.nc",
    cl: "test.cls",
    control: "fanuc",
    machine: {
      name: "test",
      joints: [
        { ...joint, letter: "C", rotary: true, direction: [0, 0, 1], min: -180, max: 180, speed: 3600 },
        { ...joint, letter: "X", rotary: false, direction: [1, 0, 0], min: -500, max: 0, speed: 20000 },
      ],
      tool_axis: [0, 0, 1],
      frame_after: 1,
    },
    tools: [],
    operations: [
      { number: 1, name: "A", tool: 1, set_up: 0, mode: "axes", first_point: 0, points: 3, seconds: 1 },
      { number: 2, name: "B", tool: 1, set_up: 0, mode: "axes", first_point: 3, points: count - 3, seconds: 1 },
    ],
    set_ups: [{ name: "set-up 1", work_offset: "G54", part_origin: [0, 0, 0], first_point: 0 }],
    placements: [
      { set_up: 0, tool: 1, points: [[0, 0, 0], [0, 0, 0]], zero: [0, -300] },
      { set_up: 0, tool: 2, points: [[0, 0, 0], [0, 0, 0]], zero: [0, null] },
    ],
    findings: [],
    warnings: [],
    summary: [],
    tolerance_mm: 0.01, path: { rapids_apart: false, undrawn: [] },
    points: count,
    columns: [],
    reasons: ["record", "tolerance", "rewind", "lead-out"],
    reason_texts: ["programmed by this record", "inserted", "rewound", "retract"],
    kinds: ["start", "rapid", "feed", "dwell"],
    seconds: 0,
    ...change,
  };
  const names = ["axis.C", "axis.X", "tip.x", "tip.y", "tip.z", "tool.i", "tool.j", "tool.k", "line", "cl_line", "kind", "reason", "operation", "placement", "feed", "seconds", "error"];
  const columns = new Map(names.map((name) => [name, Float64Array.from(given[name] ?? new Array<number>(count).fill(0))]));
  return new Program(head, columns);
}

const six = {
  "axis.C": [0, 10, 20, 200, 210, 220],
  "axis.X": [0, 1, 2, 3, 4, 5],
  line: [4, 5, 5, 9, 10, 11],
  kind: [0, 2, 2, 0, 1, 2],
  seconds: [0, 1, 2, 0, 4, 1],
};

test("points with the same line are one block", () => {
  const p = program(six);
  assert.equal(p.blocks, 5);
  assert.deepEqual([...p.block], [0, 1, 1, 2, 3, 4]);
  assert.equal(p.blockLast(1), 2);
  assert.deepEqual([...p.blockShare], [1, 1.5, 2, 3, 4, 5]);
});

test("a line without a block leads to the next block, a line past the end to none", () => {
  const p = program(six);
  assert.deepEqual([1, 5, 6, 11, 12].map((line) => p.pointOfLine(line)), [0, 2, 3, 5, null]);
});

test("the point before a line is that of the nearest line at or before it", () => {
  const p = program(six);
  assert.deepEqual([1, 4, 5, 8, 11, 99].map((line) => p.pointBefore(line)), [0, 0, 2, 2, 5, 5]);
});

test("a finding is marked over all its lines, one without a point where the program is before it", () => {
  const p = program({ ...six, line: [4, 5, 5, 9, 5, 11] });
  const finding = (line: number, last_line: number): { first: number; last: number }[] =>
    p.findingStretches({ line, last_line, cl_line: 1, text: "", help: null, point: null });
  assert.deepEqual(finding(4, 5), [{ first: 0, last: 2 }, { first: 4, last: 4 }]);
  assert.deepEqual(finding(9, 9), [{ first: 3, last: 3 }]);
  assert.deepEqual(finding(6, 8), [{ first: 3, last: 2 }]);
});

test("a feed leg without a path error is not compared; a rapid and a start have none", () => {
  const p = program({ ...six, kind: [0, 2, 2, 0, 1, 2], error: [Number.NaN, Number.NaN, 0, Number.NaN, Number.NaN, 3] });
  assert.deepEqual([0, 1, 2, 3, 4, 5].map((point) => p.isNotCompared(point)), [false, true, false, false, false, false]);
});

test("axis values are linear between points, and held where the motion is not known", () => {
  const p = program(six);
  assert.deepEqual(p.axesBetween(1.25), [12.5, 1.25]);
  assert.deepEqual(p.axesBetween(2.75), [20, 2]);
  assert.deepEqual(p.axesBetween(3), [200, 3]);
});

test("time and position are inverse to each other", () => {
  const p = program(six);
  assert.equal(p.totalS, 8);
  for (const time of [0.25, 1, 2.5, 4, 6.5, 8]) assert.ok(Math.abs(p.timeAt(p.positionAt(time)) - time) < 1e-12);
  assert.equal(p.positionAt(2), 1.5);
});

test("a rapid of unknown time is played at an assumed speed, and not counted", () => {
  const p = program({ ...six, "axis.X": [0, 1, 2, 3, 503, 504], seconds: [0, 1, 2, 0, Number.NaN, 1] });
  assert.equal(p.hasUnknownTimes, true);
  assert.equal(p.countedS[5], 4);
  assert.ok(Math.abs(p.totalS - 7) < 1e-12, "500 mm at 10 m/min take 3 s");
  assert.ok(Number.isNaN(p.speeds[1][4]));
});

test("axis speeds are per minute, and unknown at a start", () => {
  const p = program(six);
  assert.deepEqual([...p.speeds[0]], [Number.NaN, 600, 300, Number.NaN, 150, 600]);
});

test("limits of a linear axis are shifted by its machine zero, and unknown without one", () => {
  const p = program(six);
  assert.deepEqual(p.limits(0, 0), [-180, 180]);
  assert.deepEqual(p.limits(1, 0), [-200, 300]);
  assert.deepEqual(p.limits(1, 1), [null, null]);
});

test("neighbouring points with one reason are one stretch", () => {
  const p = program({ ...six, reason: [0, 1, 1, 0, 3, 2] });
  assert.deepEqual(p.stretches, [
    { kind: "inserted", first: 1, last: 2 },
    { kind: "retract", first: 4, last: 4 },
    { kind: "rewind", first: 5, last: 5 },
  ]);
});

test("an unknown reason has no text", () => {
  const p = program({ ...six, reason: [0, 255, 2, 0, 0, 0] });
  assert.equal(p.reasonText(1), null);
  assert.equal(p.reasonText(2), "rewound");
});

test("a set-up ends where the next begins", () => {
  const p = program(six, {
    set_ups: [
      { name: "1", work_offset: "G54", part_origin: [0, 0, 0], first_point: 0 },
      { name: "2", work_offset: "G55", part_origin: [0, 0, 0], first_point: 3 },
    ],
  });
  assert.deepEqual([p.setUpRange(0), p.setUpRange(1)], [[0, 3], [3, 6]]);
});

test("a missing column is an error that names it", () => {
  const p = program(six);
  assert.throws(() => new Program(p.head, new Map()), /no column `axis.C`/);
});

test("values are coloured from the smallest to the largest, and unknown ones apart", () => {
  const list = colourings(program({ ...six, feed: [0, 100, 300, 0, 0, 200] }));
  assert.deepEqual(list.map((each) => each.name), ["motion", "operation", "axis.C", "axis.X", "rotary-speed", "feed", "error"]);
  const feed = list.find((each) => each.name === "feed");
  assert.deepEqual([...(feed?.shares() ?? [])], [-1, 0, 1, -1, -1, 0.5]);
});

test("the scale of the path error goes to the tolerance at least", () => {
  const list = colourings(program({ ...six, error: [0, 1, 2, 0, Number.NaN, 1] }));
  const legend = list.find((each) => each.name === "error")?.legend("light");
  assert.ok(legend && "scale" in legend);
  assert.deepEqual([legend.scale.min, legend.scale.max, legend.scale.mark?.value], [0, 10, 10]);
});

test("the lower bound is the first value that is not less", () => {
  assert.deepEqual([0, 1, 2, 5, 6].map((wanted) => lowerBound([1, 2, 2, 5], wanted)), [0, 0, 1, 3, 4]);
});
