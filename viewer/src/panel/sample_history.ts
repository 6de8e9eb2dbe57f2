// SPDX-License-Identifier: Apache-2.0
import type { Sample } from "../protocol";

const capacity = 1 << 16; // samples: 6 s at 10 kHz, twice over

/** The last seconds of the displayed wrench: columns time, fx, fy, fz, tx, ty, tz, |force|, |torque|. */
export class SampleHistory {
  private readonly columns = Array.from({ length: 9 }, () => new Float64Array(capacity));
  private length = 0;

  /** Time of the newest sample, s. */
  get newest(): number {
    return this.length === 0 ? -Infinity : (this.columns[0]?.[this.length - 1] ?? -Infinity);
  }

  clear(): void {
    this.length = 0;
  }

  /** Takes those samples that are newer than what it has; a state's time before its newest clears it first. */
  add(samples: readonly Sample[], t: number): void {
    if (t < this.newest - 0.2) this.clear();
    for (const sample of samples) {
      if (!(sample[0] > this.newest)) continue;
      if (this.length === capacity) this.dropOldHalf();
      const force = Math.hypot(sample[1], sample[2], sample[3]);
      const torque = Math.hypot(sample[4], sample[5], sample[6]);
      [...sample, force, torque].forEach((value, i) => (this.columns[i]![this.length] = value));
      ++this.length;
    }
  }

  /** Views of the named columns over the last `seconds`. */
  last(seconds: number, ...wanted: number[]): Float64Array[] {
    const first = this.firstAfter(this.newest - seconds);
    return wanted.map((i) => this.columns[i]!.subarray(first, this.length));
  }

  private firstAfter(time: number): number {
    let low = 0, high = this.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.columns[0]![middle]! < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  private dropOldHalf(): void {
    const kept = this.length - capacity / 2;
    for (const column of this.columns) column.copyWithin(0, kept, this.length);
    this.length -= kept;
  }
}
