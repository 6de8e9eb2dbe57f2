// SPDX-License-Identifier: Apache-2.0
import type { Setting } from "../protocol";

/** Steps of a slider. */
export const sliderSteps = 1000;

/** What people turn these settings over; their permitted ranges are far wider. */
const usual: Record<string, [number, number]> = {
  stiffness: [50, 2e4],
  damping: [0.1, 100],
  metric_length: [1e-3, 1],
  rotational_stiffness: [0.01, 100],
  rotational_damping: [1e-4, 1],
  physics_rate: [20, 2000],
  haptic_rate: [100, 5000],
  margin: [1e-4, 0.02],
  contact_margin: [1e-4, 0.01],
  friction: [0, 2],
  kinetic_friction: [0, 1],
  viscous_friction: [0.1, 100],
  transient: [0.1, 100],
};

const logarithmicFrom = 50; // ratio of ends from which a slider is logarithmic
const decadesAtMost = 6; // of a logarithmic slider for a setting that nothing is known of

/** Positions 0 to sliderSteps of a slider, and the values that they stand for. */
export class SliderScale {
  readonly least: number;
  readonly most: number;
  readonly isLogarithmic: boolean;
  private readonly zero: boolean; // its left end stands for 0

  constructor(setting: Setting) {
    const [low, high] = usual[setting.name] ?? [setting.least, setting.most];
    const value = setting.value ?? low;
    this.zero = setting.zero_too || setting.least === 0;
    this.most = Math.min(setting.most, Math.max(high, value));
    const positive = Math.max(low, setting.least, low > 0 ? 0 : this.most / 10 ** decadesAtMost);
    this.isLogarithmic = this.most / positive >= logarithmicFrom && low > 0;
    this.least = this.isLogarithmic ? (value > 0 ? Math.min(positive, value) : positive) : Math.max(low, setting.least);
  }

  valueAt(position: number): number {
    if (this.zero && position <= 0) return 0;
    const part = position / sliderSteps;
    if (!this.isLogarithmic) return rounded(this.least + part * (this.most - this.least));
    return rounded(this.least * (this.most / this.least) ** part);
  }

  positionOf(value: number): number {
    const part = this.isLogarithmic
      ? Math.log(Math.max(value, this.least) / this.least) / Math.log(this.most / this.least)
      : (value - this.least) / (this.most - this.least);
    const position = Math.round(sliderSteps * Math.max(0, Math.min(1, part)));
    return this.zero && value > 0 ? Math.max(1, position) : position;
  }
}

function rounded(value: number): number {
  return Number(value.toPrecision(3));
}
