// SPDX-License-Identifier: Apache-2.0
import type { Program } from "../program";
import type { Pose } from "../protocol";

const sendEvery = 1000 / 60; // ms between messages while the hand moves
const keepAlive = 250; // ms between messages while it holds still

/** Where the hand of this page means the tool to be, told to the program while anything here holds the tool. */
export class Hand {
  private readonly holders = new Set<string>();
  private target: Pose | null = null;
  private isNews = false;
  private lastSent = -Infinity;

  constructor(private readonly program: Program) {
    program.connectionStates.listen(() => this.forget());
    program.scenes.listen(() => this.forget());
    program.states.listen((state) => {
      if (this.isHolding && state.hand !== null && state.hand !== program.viewer) this.forget();
    });
  }

  get isHolding(): boolean {
    return this.holders.size > 0;
  }

  /** `holder` takes the tool; false, with a notice, where something or somebody else moves it. */
  take(holder: string): boolean {
    if (this.holders.has(holder)) return true;
    if (!this.isHolding) {
      const { state, viewer } = this.program;
      if (state === null || !this.program.pageIsHand) return false;
      if (state.target === null) {
        const what = state.motion !== null ? `“${state.motion}”` : "A motion";
        this.program.notice("info", `${what} moves the tool now; stop it to take the tool yourself.`);
        return false;
      }
      if (state.hand !== null && state.hand !== viewer) {
        this.program.notice("info", `Viewer ${state.hand} moves the tool; wait until it lets go.`);
        return false;
      }
      this.target = state.target;
    }
    this.holders.add(holder);
    return true;
  }

  /** Changes what the hand means; only while it holds the tool. */
  move(change: (target: Pose) => Pose): void {
    if (this.target === null || !this.isHolding) return;
    this.target = change(this.target);
    this.isNews = true;
    this.sendDue(performance.now());
  }

  release(holder: string): void {
    if (!this.holders.delete(holder) || this.isHolding) return;
    if (this.isNews) this.sendTarget(performance.now());
    this.program.send({ type: "release" });
    this.target = null;
  }

  /** Called with every frame of the page. */
  sendDue(now: number): void {
    if (!this.isHolding) return;
    const pause = now - this.lastSent;
    if (pause >= (this.isNews ? sendEvery - 1 : keepAlive)) this.sendTarget(now);
  }

  private sendTarget(now: number): void {
    if (this.target === null) return;
    this.program.send({ type: "hand", pose: this.target });
    this.lastSent = now;
    this.isNews = false;
  }

  private forget(): void {
    this.holders.clear();
    this.target = null;
    this.isNews = false;
  }
}
