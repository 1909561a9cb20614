/** Reads the elements of the page that hold its data. */

import type { Head } from "./contract.ts";
import { decodeColumns, textOfBytes, unpack } from "./decode.ts";
import { Lines } from "./lines.ts";
import { Program } from "./program.ts";
import { readSimulation, type Simulation } from "./simulation.ts";

export interface PageData {
  program: Program;
  programText: Lines;
  /** The CL file, where the page has it. */
  clText: Lines | null;
  simulation: Simulation | null;
}

/** Text of an element; `null` if there is none. The element is emptied: its text is not needed twice. */
function take(id: string): string | null {
  const element = document.getElementById(id);
  if (!element) return null;
  const text = element.textContent ?? "";
  element.textContent = "";
  return text;
}

export async function readPage(): Promise<PageData> {
  const headText = take("program-head");
  const columnsText = take("program-columns");
  const programText = take("program-text");
  if (headText === null || columnsText === null || programText === null) {
    throw new Error("this page has no program: its data elements are missing");
  }
  const head = JSON.parse(headText) as Head;
  if (head.format !== 1) throw new Error(`this page reads format 1, and its data has format ${String(head.format)}`);
  const columns = decodeColumns(head, await unpack(columnsText, head.compressed));
  const clText = take("cl-text");
  const simulation = take("simulation");
  return {
    program: new Program(head, columns),
    programText: new Lines(textOfBytes(await unpack(programText, head.compressed))),
    clText: clText === null ? null : new Lines(textOfBytes(await unpack(clText, head.compressed))),
    simulation: simulation === null ? null : await readSimulation(simulation),
  };
}
