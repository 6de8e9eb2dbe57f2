// SPDX-License-Identifier: Apache-2.0

const window_ms = 1000;

/** How many frames were drawn within the last second. */
export class FrameRate {
  private readonly times: number[] = [];

  count(now: number): void {
    this.times.push(now);
    this.forget(now);
  }

  perSecond(now: number): number {
    this.forget(now);
    return this.times.length;
  }

  private forget(now: number): void {
    while (this.times.length > 0 && this.times[0]! < now - window_ms) this.times.shift();
  }
}
