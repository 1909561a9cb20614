/** Where the program is: the position, moved by play, steps, and whoever jumps. Nothing plays by itself. */

import { Program } from "./data/program.ts";

/** Program seconds in one second. */
export const PACES = [0.1, 0.25, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000];

/** A program is at first played in about this time, s. */
const USUAL_PLAY_S = 60;

export class Timeline {
  position = 0;
  playing = false;
  pace: number;
  private lastFrameMs = 0;
  private readonly listeners: (() => void)[] = [];
  /** Whoever prefers less motion sees the end of each block, not the motion in it. */
  private readonly calm = matchMedia("(prefers-reduced-motion: reduce)");
  /** Time of the program while playing, s: ahead of the position where motion is not shown. */
  private playedS = 0;

  constructor(private readonly program: Program) {
    const wanted = program.totalS / USUAL_PLAY_S;
    this.pace = PACES.find((pace) => pace >= wanted) ?? PACES[PACES.length - 1];
    if (this.pace < 1) this.pace = 1;
  }

  /** Point whose leg is under way or has just ended. */
  get point(): number {
    return Program.pointAt(this.position);
  }

  get timeS(): number {
    return this.program.timeAt(this.position);
  }

  onChange(listener: () => void): void {
    this.listeners.push(listener);
  }

  seek(position: number): void {
    const last = Math.max(this.program.count - 1, 0);
    this.position = Math.min(Math.max(position, 0), last);
    if (!Number.isFinite(this.position)) this.position = 0;
    this.changed();
  }

  seekTime(seconds: number): void {
    this.seek(this.program.positionAt(seconds));
  }

  play(): void {
    if (this.playing || this.program.count < 2) return;
    if (this.position >= this.program.count - 1) this.position = 0;
    this.playing = true;
    this.playedS = this.timeS;
    this.lastFrameMs = performance.now();
    requestAnimationFrame((now) => this.frame(now));
    this.changed();
  }

  pause(): void {
    if (!this.playing) return;
    this.playing = false;
    this.changed();
  }

  toggle(): void {
    if (this.playing) this.pause();
    else this.play();
  }

  /** Next or previous block: the position after it. */
  stepBlock(by: 1 | -1): void {
    this.pause();
    const { program } = this;
    const block = program.block[this.point];
    const atEnd = this.position >= program.blockLast(block);
    // Within a block a step forwards ends it.
    const next = by === 1 ? (atEnd ? block + 1 : block) : block - 1;
    this.seek(program.blockLast(Math.min(Math.max(next, 0), program.blocks - 1)));
  }

  stepPoint(by: 1 | -1): void {
    this.pause();
    this.seek(by === 1 ? Math.floor(this.position) + 1 : Math.ceil(this.position) - 1);
  }

  stepOperation(by: 1 | -1): void {
    this.pause();
    const starts = this.program.head.operations.filter((operation) => operation.points > 0).map((operation) => operation.first_point);
    const next = by === 1 ? starts.find((start) => start > this.position) : starts.findLast((start) => start < this.position);
    if (next !== undefined) this.seek(next);
    else this.seek(by === 1 ? this.program.count - 1 : 0);
  }

  stepPace(by: 1 | -1): void {
    const index = PACES.indexOf(this.pace) + by;
    if (index >= 0 && index < PACES.length) this.setPace(PACES[index]);
  }

  setPace(pace: number): void {
    this.pace = pace;
    this.changed();
  }

  private frame(nowMs: number): void {
    if (!this.playing) return;
    // A tab that was in the background does not jump.
    const elapsedS = Math.min(Math.max(nowMs - this.lastFrameMs, 0), 500) / 1000;
    this.lastFrameMs = nowMs;
    const { program } = this;
    // Someone may have jumped meanwhile.
    if (Math.abs(program.timeAt(this.position) - this.playedS) > 1e-6 && !this.calm.matches) this.playedS = this.timeS;
    this.playedS += elapsedS * this.pace;
    if (this.playedS >= program.totalS) {
      this.playing = false;
      this.seek(program.count - 1);
      return;
    }
    const position = program.positionAt(this.playedS);
    if (this.calm.matches) {
      const block = program.block[Math.floor(position)];
      this.position = program.blockFirst[block] > 0 ? program.blockFirst[block] - 1 : 0;
    } else {
      this.position = position;
    }
    this.changed();
    requestAnimationFrame((now) => this.frame(now));
  }

  private changed(): void {
    for (const listener of this.listeners) listener();
  }
}
