import assert from "node:assert/strict";
import { test } from "node:test";
import { Lines, tokens } from "../src/data/lines.ts";

test("lines are counted from 1, with either line end and with or without a last one", () => {
  for (const text of ["G0 X1\nG1 X2\nM30", "G0 X1\r\nG1 X2\r\nM30\r\n"]) {
    const lines = new Lines(text);
    assert.equal(lines.count, 3);
    assert.deepEqual([1, 2, 3].map((line) => lines.line(line)), ["G0 X1", "G1 X2", "M30"]);
    assert.equal(lines.line(0), "");
    assert.equal(lines.line(4), "");
  }
});

test("empty lines are lines", () => {
  const lines = new Lines("A\n\n\nB\n");
  assert.equal(lines.count, 4);
  assert.equal(lines.line(4), "B");
});

test("each offset is in its line", () => {
  const lines = new Lines("AB\nC\n\nDEF");
  assert.deepEqual([..."AB\nC\n\nDEF"].map((_, offset) => lines.lineOfOffset(offset)), [1, 1, 1, 2, 2, 3, 4, 4, 4]);
});

test("the search finds each line once, in either case", () => {
  const lines = new Lines("G1 X1 X1\nG0 Y2\n(turn x1)\nM30");
  assert.deepEqual(lines.search("x1"), [1, 3]);
  assert.deepEqual(lines.search("m30"), [4]);
  assert.deepEqual(lines.search("Q"), []);
  assert.deepEqual(lines.search(""), []);
});

test("the search finds lines after a letter whose lower case is longer", () => {
  assert.deepEqual(new Lines("(İ)\nX1\n").search("x1"), [2]);
});

test("the parts of a line are the line", () => {
  const controls = ["linuxcnc", "siemens", "heidenhain", "fanuc", "haas"];
  const lines = ["N10 G1 X-1.5 (WIDE M5) M8", "12 L X+5 R0 FMAX M91 ; end", "QL3 = ABS ( SIN ( Q1 ) )", "", "%", "; N5 G1", "/N5 G43.4 H1", "(open"];
  for (const control of controls) {
    for (const line of lines) assert.equal(tokens(line, control).map((token) => token.text).join(""), line);
  }
});

test("parentheses are comments where the control has them, and expressions elsewhere", () => {
  const kinds = (line: string, control: string): string[] => tokens(line, control).filter((token) => token.kind === "comment").map((token) => token.text);
  assert.deepEqual(kinds("G1 X1 (G2 Y5)", "fanuc"), ["(G2 Y5)"]);
  assert.deepEqual(kinds("QL3 = ABS ( SIN ( Q1 ) )", "heidenhain"), []);
  assert.deepEqual(kinds("R1=(R2+R3) ; sum (all)", "siemens"), ["; sum (all)"]);
});

test("codes and block numbers are found", () => {
  assert.deepEqual(tokens("N10 G43.4 H1 M8", "fanuc").filter((token) => token.kind !== "word").map((token) => [token.kind, token.text]), [
    ["number", "N10"],
    ["code", "G43.4"],
    ["code", "M8"],
  ]);
});
