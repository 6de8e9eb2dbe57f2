// SPDX-License-Identifier: Apache-2.0
import { roundDown } from "../quantities";

const span = 3; // s; a peak holds the scale for one to two of them
const lowestPart = 0.12; // of the range; peaks below it bring the scale back

/**
 * How long an arrow is drawn for its value: `full` metres for `range`, a round number, which grows as soon as a value
 * exceeds it and shrinks when all of the last seconds stayed far below.
 */
export class AdaptiveScale {
  private range: number;
  private began = 0; // the present span, s
  private peak = 0; // of the present span
  private lastPeak = 0; // of the one before

  constructor(private full: number, private readonly least: number) {
    this.range = least;
  }

  /** Starts anew, for arrows of `full` metres. */
  begin(full: number): void {
    this.full = full;
    this.range = this.least;
    this.began = this.peak = this.lastPeak = 0;
  }

  /** Takes a value of the time `t` (s) into account. */
  observe(value: number, t: number): void {
    if (t < this.began || t - this.began > span) this.endSpan(t);
    this.peak = Math.max(this.peak, value);
    this.growFor(value);
  }

  /** Metres that are drawn for one unit. */
  get metresPerUnit(): number {
    return this.full / this.range;
  }

  private endSpan(t: number): void {
    const peak = Math.max(this.peak, this.lastPeak);
    if (peak < lowestPart * this.range) {
      this.range = this.least;
      this.growFor(2 * peak);
    }
    this.lastPeak = this.peak;
    this.peak = 0;
    this.began = t;
  }

  private growFor(value: number): void {
    while (value > this.range) this.range = roundDown(2.5 * this.range);
  }
}
