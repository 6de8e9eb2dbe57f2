// SPDX-License-Identifier: Apache-2.0
import { roundDown } from "../quantities";

const memory = 5; // s for which a peak holds the scale
const lowestPart = 0.12; // of the range; peaks below it bring the scale back

/**
 * How long an arrow is drawn for its value: `full` metres for `range`, a round number, which grows as soon as a value
 * exceeds it and shrinks when all of the last seconds stayed far below.
 */
export class AdaptiveScale {
  private range: number;
  private peak = 0;
  private peakTime = 0;

  constructor(private full: number, private readonly least: number) {
    this.range = least;
  }

  /** Starts anew, for arrows of `full` metres. */
  begin(full: number): void {
    this.full = full;
    this.range = this.least;
    this.peak = this.peakTime = 0;
  }

  /** Takes a value of the time `t` (s) into account. */
  observe(value: number, t: number): void {
    if (value >= this.peak || t - this.peakTime > memory || t < this.peakTime) {
      this.peak = value;
      this.peakTime = t;
    }
    while (value > this.range) this.range = next(this.range);
    if (this.peak < lowestPart * this.range && t - this.peakTime > 0.9 * memory) {
      this.range = Math.max(this.least, previous(this.range));
    }
  }

  /** Metres that are drawn for one unit. */
  get metresPerUnit(): number {
    return this.full / this.range;
  }
}

function next(range: number): number {
  return roundDown(range * 2.5);
}

function previous(range: number): number {
  return roundDown(range / 1.9);
}
