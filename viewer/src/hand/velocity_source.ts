// SPDX-License-Identifier: Apache-2.0
import type { Vector } from "../protocol";

/** How a device moves the tool: right, up and away, and turns about these axes; each from -1 to 1. */
export interface HandVelocity {
  linear: Vector;
  angular: Vector;
}

export interface VelocitySource {
  readonly name: string;
  /** What it asks for now; null where it rests. */
  read(): HandVelocity | null;
}
