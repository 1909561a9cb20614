import assert from "node:assert/strict";
import { test } from "node:test";
import { inMachineCoordinates } from "../src/data/undrawn.ts";

test("motions in machine coordinates are known by their words, comments and other words apart", () => {
  const is = (line: string, control: string): void => assert.equal(inMachineCoordinates(line, control), true, line);
  const not = (line: string, control: string): void => assert.equal(inMachineCoordinates(line, control), false, line);
  is("N10 G53 G0 Z0.", "fanuc");
  is("G91 G28 Z0.", "haas");
  is("G30 P2", "linuxcnc");
  not("G53.1", "fanuc");
  not("G0 Z0. (AFTER G53)", "fanuc");
  not("G54 G0 X28.", "haas");
  not("G280", "fanuc");
  is("N10 SUPA G0 Z0 D0", "siemens");
  is("G153 Z=0", "siemens");
  not("G500", "siemens");
  not("G0 Z0 ; SUPA Z0", "siemens");
  is("12 L Z-1 R0 FMAX M91", "heidenhain");
  is("12 L Z-1 R0 FMAX M92", "heidenhain");
  not("12 L Z-1 R0 FMAX M9", "heidenhain");
});
