/** Starts the page: reads its data, builds it, and gives tests something to hold on to. */

import { App } from "./app.ts";
import type { Head, Triple } from "./data/contract.ts";
import { readPage } from "./data/document.ts";
import { element } from "./dom.ts";

/** What the page is doing, for tests. */
export interface PageState {
  /** Axis values at the position, mm or degrees. */
  axes: number[];
  /** Tip of the point, as it is in the data. */
  tip: Triple;
  /** Tip of the tool as it is drawn, workpiece coordinates. */
  toolTip: Triple;
  /** Axis values of the machine as it is drawn. */
  joints: number[];
  line: number;
  point: number;
  position: number;
  setUp: number;
  colouring: string;
  playing: boolean;
  /** Of a simulation; `null` without one. */
  simulation: SimulationState | null;
}

/** What the page shows of a simulation, for tests. */
export interface SimulationState {
  stock: string;
  /** Volume of the stock at the position, mm³. */
  volume: number | null;
  /** Origins of the solids' coordinates as they are drawn, workpiece coordinates. */
  origins: Record<string, Triple>;
}

export interface PageHandle {
  readonly head: Head;
  readonly ready: boolean;
  readonly point: number;
  readonly colourings: string[];
  /** From the start of the script until everything was built. */
  readonly loadMilliseconds: number;
  state(): PageState;
  seek(point: number): void;
  select(line: number): void;
  play(): void;
  pause(): void;
  setColouring(name: string): void;
  setMode(mode: "part" | "machine"): void;
  setStock(stock: "result" | "cut" | "off"): void;
  frameMilliseconds(): number;
  /** Leg of the path under a place of the view, px from its top left corner. */
  pick(x: number, y: number): number | null;
}

declare global {
  interface Window {
    ppView?: PageHandle;
  }
}

async function start(): Promise<void> {
  const began = performance.now();
  const root = document.getElementById("app");
  if (!root) return;
  const data = await readPage();
  const { program } = data;
  if (program.count === 0) {
    root.append(element("p", { class: "failure" }, "The program has no motion to show; the summary is below."));
    return;
  }
  const app = new App(data, root);
  const loadMilliseconds = performance.now() - began;
  window.ppView = {
    head: program.head,
    ready: true,
    get point() {
      return app.timeline.point;
    },
    colourings: app.colourings.map((colouring) => colouring.name),
    loadMilliseconds,
    state: () => ({
      axes: program.axesBetween(app.timeline.position),
      tip: program.tipAt(app.timeline.point),
      toolTip: app.stage.machine.drawnTip(),
      joints: app.stage.machine.drawnJoints(),
      line: program.line[app.timeline.point],
      point: app.timeline.point,
      position: app.timeline.position,
      setUp: program.placementAt(app.timeline.point).set_up,
      colouring: app.colouring.name,
      playing: app.timeline.playing,
      simulation: app.stage.simulated && {
        stock: app.stage.simulated.stock,
        volume: app.stage.simulated.volume(),
        origins: app.stage.simulated.origins(),
      },
    }),
    seek: (point) => app.timeline.seek(point),
    select: (line) => app.select(line),
    play: () => app.timeline.play(),
    pause: () => app.timeline.pause(),
    setColouring: (name) => app.setColouring(name),
    setMode: (mode) => app.setFixed(mode),
    setStock: (stock) => app.setStock(stock),
    frameMilliseconds: () => app.stage.view.frameMilliseconds(),
    pick: (x, y) => app.stage.pickAt(x, y),
  };
}

start().catch((error: unknown) => {
  // Without WebGL or with damaged data the summary is still there; the page states why there is no more.
  document.body.classList.remove("app");
  const text = error instanceof Error ? error.message : String(error);
  const notice = element("p", { class: "failure", role: "alert" }, `The interactive page could not start: ${text}. The summary is below.`);
  document.getElementById("app")?.replaceChildren();
  document.body.prepend(notice);
  console.error(error);
});
