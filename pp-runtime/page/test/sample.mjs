// Writes a sample page as the postprocessor would, to look at and to measure the page without it.
//
//     npm run build && node test/sample.mjs [table|head|inclined] [POINTS] OUT.html
//
// A spiral on a dome, with a retract, a rewind, inserted points, a stretch near the pole, feed points not compared, two tools, two operations and two
// findings. The rotary angles follow the normal of the dome; the linear axes are solved for from the chain.

import { createHash } from "node:crypto";
import { readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import path from "node:path";
import { deflateRawSync } from "node:zlib";

const [machineName = "table", pointsText = "2000", out = "sample.html"] = process.argv.slice(2);
const wanted = Number(pointsText);
const dist = path.join(path.dirname(fileURLToPath(import.meta.url)), "..", "dist");

const RAD = Math.PI / 180;
const linear = (letter, direction, min, max) => ({ letter, rotary: false, held: false, direction, point: [0, 0, 0], sign: 1, min, max, speed: 24000 });
const rotary = (letter, direction, point, min, max) => ({ letter, rotary: true, held: false, direction, point, sign: 1, min, max, speed: 9000 });
const xyz = [linear("X", [1, 0, 0], -300, 300), linear("Y", [0, 1, 0], -250, 250), linear("Z", [0, 0, 1], -480, 0)];
const h = Math.SQRT1_2;
const MACHINES = {
  table: { name: "Table C on B", joints: [rotary("C", [0, 0, 1], [0, 0, -60], null, null), rotary("B", [0, 1, 0], [0, 0, -60], -30, 110), ...xyz], frame_after: 2 },
  inclined: { name: "Inclined table", joints: [rotary("C", [0, 0, 1], [0, 0, -60], null, null), rotary("B", [0, h, -h], [0, 0, -60], 0, 180), ...xyz], frame_after: 2 },
  head: { name: "Head B A", joints: [xyz[0], xyz[1], xyz[2], rotary("B", [0, 1, 0], [0, 0, 120], -95, 95), rotary("A", [1, 0, 0], [0, 0, 120], -95, 95)], frame_after: 1 },
};
const machine = { ...MACHINES[machineName], tool_axis: [0, 0, 1] };

/** Point (w = 1) or direction (w = 0) through the joints at axis values. */
function through(axes, p, w) {
  return machine.joints.reduceRight((v, joint, i) => {
    const q = joint.sign * axes[i];
    if (!joint.rotary) return v.map((x, k) => x + w * q * joint.direction[k]);
    const [c, s, a] = [Math.cos(q * RAD), Math.sin(q * RAD), joint.direction];
    const u = v.map((x, k) => x - w * joint.point[k]);
    const d = a[0] * u[0] + a[1] * u[1] + a[2] * u[2];
    const x = [a[1] * u[2] - a[2] * u[1], a[2] * u[0] - a[0] * u[2], a[0] * u[1] - a[1] * u[0]];
    return u.map((value, k) => value * c + x[k] * s + a[k] * d * (1 - c) + w * joint.point[k]);
  }, p);
}

/** Axis values with given rotary angles whose tip is at a point: the tip is affine in the linear axes. */
function solve(rotaries, tip) {
  let next = 0;
  const axes = machine.joints.map((joint) => (joint.rotary ? rotaries[next++] : 0));
  const free = machine.joints.flatMap((joint, i) => (joint.rotary ? [] : [i]));
  const origin = through(axes, [0, 0, 0], 1);
  const columns = free.map((i) => through(axes.with(i, 1), [0, 0, 0], 1).map((x, k) => x - origin[k]));
  // The columns are orthonormal: their transpose solves for them.
  free.forEach((i, c) => {
    axes[i] = columns[c].reduce((sum, x, k) => sum + x * (tip[k] - origin[k]), 0);
  });
  return axes;
}

/** Rotary angles for a tool axis. */
function angles([i, j, k], turns) {
  if (machineName === "head") return [Math.atan2(i, k) / RAD, Math.asin(-j) / RAD];
  if (machineName === "table") return [Math.atan2(j, i) / RAD + 360 * turns, Math.atan2(Math.hypot(i, j), k) / RAD];
  const b = Math.acos(Math.max(-1, Math.min(1, 2 * k - 1)));
  const at0 = [Math.sin(b) * h, -(1 - Math.cos(b)) / 2];
  return [(Math.atan2(j, i) - Math.atan2(at0[1], at0[0])) / RAD + 360 * turns, b / RAD];
}

const reasons = ["head", "record", "tolerance", "course", "rewind", "curve", "chord", "split-arc", "hole", "corner", "lead-out", "start", "approach", "end"];
const kinds = ["start", "rapid", "feed", "dwell"];
const points = [];
const text = ["%", "O1000 (SPIRAL ON A DOME)", "N10 G90 G54", "N20 T1 M6"];
const cl = ["TOOL PATH/SPIRAL,TOOL,T1"];
const format = (x) => (Math.round(x * 1000) / 1000).toString();

function go(tip, axis, { kind = 2, reason = 1, operation = 0, placement = 0, turns = 0, feed = 1500, share = true }) {
  const axes = solve(angles(axis, turns), tip);
  const before = points.at(-1);
  const distance = before ? Math.hypot(...tip.map((x, k) => x - before.tip[k])) : 0;
  const rotation = before ? Math.max(...machine.joints.map((joint, k) => (joint.rotary ? Math.abs(axes[k] - before.axes[k]) : 0))) : 0;
  const seconds = !before || kind === 0 ? 0 : Math.max(kind === 1 ? distance / 400 : (distance / feed) * 60, rotation / 150, 1e-4);
  if (share) cl.push(`GOTO/${[...tip, ...axis].map((x) => x.toFixed(4)).join(",")}`);
  text.push(`N${(text.length + 1) * 10} ${kind === 1 ? "G0" : "G1"} ${machine.joints.map((joint, k) => joint.letter + format(axes[k])).join(" ")}${kind === 1 ? "" : ` F${feed}`}`);
  points.push({ axes, tip, axis, line: text.length, cl: cl.length, kind, reason, operation, placement, feed: kind === 1 ? 0 : feed, seconds, error: kind === 1 || (operation === 1 && points.length % 300 < 80) ? Number.NaN : 6 * Math.abs(Math.sin(points.length / 37)) });
}

const RADIUS = 60;
const dome = (t, revolutions, reach) => {
  const tilt = (1 - t) * reach;
  const turn = 2 * Math.PI * revolutions * t;
  const n = [Math.sin(tilt) * Math.cos(turn), Math.sin(tilt) * Math.sin(turn), Math.cos(tilt)];
  return [n.map((x) => x * RADIUS).map((x, k) => (k === 2 ? x - 20 : x)), n];
};

const spiral = (count, operation, placement, revolutions, reach, feed) => {
  const [first, normal] = dome(0, revolutions, reach);
  const above = first.map((x, k) => x + 40 * normal[k]);
  go(above, normal, { kind: 0, reason: 11, operation, placement });
  go(first.map((x, k) => x + 5 * normal[k]), normal, { kind: 1, reason: 12, operation, placement });
  for (let i = 0; i < count; i += 1) {
    const t = i / (count - 1);
    const [tip, axis] = dome(t, revolutions, reach);
    const tableTurns = machineName === "head" ? 0 : Math.round((revolutions * t) - Math.atan2(axis[1], axis[0]) / (2 * Math.PI) - 0);
    go(tip, axis, { reason: i % 5 === 0 ? 1 : 2, operation, placement, feed, turns: tableTurns, share: i % 5 === 0 });
  }
  const [last, top] = dome(1, revolutions, reach);
  go(last.map((x, k) => x + 60 * top[k]), top, { kind: 1, reason: 10, operation, placement });
  go(last.map((x, k) => x + 60 * top[k]), top.map((x, k) => (k === 0 ? 0.3 : k === 2 ? Math.sqrt(1 - 0.09) : 0)), { kind: 1, reason: 4, operation, placement });
};

const split = Math.max(8, Math.round(wanted * 0.6));
const revolutions = Math.max(4, Math.min(40, wanted / 150));
spiral(split, 0, 0, revolutions, 1.1, 1500);
text.push("(<script>alert(1)</script> CHANGE TO BALL 8)", "N5 T2 M6");
cl.push("TOOL PATH/FINISH,TOOL,T2");
const second = points.length;
spiral(Math.max(wanted - split - 8, 8), 1, 1, revolutions, 0.8, 3000);
text.push("M30", "%");

const ball = (radius, length) => [
  ...Array.from({ length: 13 }, (_, i) => [radius * (1 - Math.cos((i / 12) * (Math.PI / 2))), radius * Math.sin((i / 12) * (Math.PI / 2))]),
  [length * 0.5, radius],
  [length * 0.52, radius * 1.6],
  [length, radius * 1.6],
];
const tool = (number, name, diameter, gauge, profile, first, count) => ({
  number, name, kind: "ball", diameter, corner_radius: diameter / 2, length: gauge, flute_length: gauge * 0.3, gauge_length: gauge, profile,
  first_point: first, points: count, seconds: points.slice(first, first + count).reduce((sum, p) => sum + p.seconds, 0),
});
const operation = (number, name, toolNumber, first, count) => ({
  number, name, tool: toolNumber, set_up: 0, mode: "axes", first_point: first, points: count, seconds: points.slice(first, first + count).reduce((sum, p) => sum + p.seconds, 0),
});
const jointPoints = machine.joints.map((joint) => joint.point);
const zero = machine.joints.map((joint) => (joint.letter === "Z" ? -320 : 0));

const columns = [];
const bytes = [];
function column(name, type, values, scale) {
  columns.push(scale === undefined ? { name, type } : { name, type, scale });
  const size = { f32: 4, q32: 4, u16: 2, u8: 1 }[type];
  const buffer = Buffer.alloc(size * values.length);
  let before = 0;
  values.forEach((value, i) => {
    if (type === "q32") {
      const now = Math.round(value / scale);
      buffer.writeInt32LE(now - before, 4 * i);
      before = now;
    } else if (type === "f32") buffer.writeFloatLE(value, 4 * i);
    else if (type === "u16") buffer.writeUInt16LE(value, 2 * i);
    else buffer.writeUInt8(value, i);
  });
  for (let place = 0; place < size; place += 1) bytes.push(buffer.filter((_, i) => i % size === place));
}
machine.joints.forEach((joint, i) => column(`axis.${joint.letter}`, "q32", points.map((p) => p.axes[i]), 1e-5));
["x", "y", "z"].forEach((letter, i) => column(`tip.${letter}`, "q32", points.map((p) => p.tip[i]), 1e-5));
["i", "j", "k"].forEach((letter, i) => column(`tool.${letter}`, "q32", points.map((p) => p.axis[i]), 1e-6));
column("line", "q32", points.map((p) => p.line), 1);
column("cl_line", "q32", points.map((p) => p.cl), 1);
column("kind", "u8", points.map((p) => p.kind));
column("reason", "u8", points.map((p) => p.reason));
column("operation", "u16", points.map((p) => p.operation));
column("placement", "u16", points.map((p) => p.placement));
column("feed", "f32", points.map((p) => p.feed));
column("seconds", "f32", points.map((p) => p.seconds));
column("error", "f32", points.map((p) => p.error));

const finding = (point, words, help) => ({ line: points[point].line, last_line: points[point].line, cl_line: points[point].cl, text: words, help, point });
const head = {
  format: 1, compressed: true, program: "dome.nc", cl: "dome.cls", control: "fanuc", machine,
  tools: [tool(1, "ball 12 <b>bold</b>", 12, 120, ball(6, 95), 0, second), tool(2, "ball 8", 8, 95, ball(4, 95), second, points.length - second)],
  operations: [operation(1, "SPIRAL ROUGH", 1, 0, second), operation(2, "SPIRAL FINISH <img src=x onerror=alert(1)>", 2, second, points.length - second)],
  set_ups: [{ name: "set-up 1", work_offset: "G54", part_origin: [0, 0, 60], first_point: 0 }],
  placements: [{ set_up: 0, tool: 1, points: jointPoints, zero }, { set_up: 0, tool: 2, points: jointPoints, zero: zero.map((z) => (z ? z - 25 : 0)) }],
  findings: [
    finding(Math.floor(points.length * 0.2), "the tip is 0.412 mm from the path of CL line 231, allowed are 0.010", "compare X and Y of this block with the CL point"),
    finding(Math.floor(points.length * 0.72), "F 3000 is programmed, the CL data asks for 2400", null),
  ],
  warnings: ["rapids are not linearised"],
  summary: [`${points.length} points`], tolerance_mm: 0.01, path: { rapids_apart: false, undrawn: [] }, points: points.length, columns,
  reasons, reason_texts: reasons.map((name) => `because of ${name}`), kinds, seconds: points.reduce((sum, p) => sum + p.seconds, 0),
};

const script = await readFile(path.join(dist, "page.js"), "utf8");
const style = await readFile(path.join(dist, "page.css"), "utf8");
const packed = (data) => deflateRawSync(data).toString("base64");
const digest = createHash("sha256").update(script).digest("base64");
const page = `<!doctype html><html lang="en"><head><meta charset="utf-8"><meta name="viewport" content="width=device-width, initial-scale=1">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; script-src 'sha256-${digest}'; style-src 'unsafe-inline'; img-src data:">
<title>dome.nc</title><style>${style}</style></head>
<body><main id="summary"><h1>dome.nc</h1><p>${points.length} points</p></main><div id="app"></div>
<script type="application/json" id="program-head">${JSON.stringify(head).replaceAll("<", "\\u003c")}</script>
<script type="text/plain" id="program-columns">${packed(Buffer.concat(bytes))}</script>
<script type="text/plain" id="program-text">${packed(Buffer.from(text.join("\n") + "\n"))}</script>
<script type="text/plain" id="cl-text">${packed(Buffer.from(cl.join("\n") + "\n"))}</script>
<script>${script}</script></body></html>
`;
await writeFile(out, page);
console.log(`${out}: ${points.length} points, ${(page.length / 1e6).toFixed(2)} MB`);
