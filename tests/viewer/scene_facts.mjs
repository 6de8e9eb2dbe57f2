// SPDX-License-Identifier: Apache-2.0
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const scenes = join(dirname(fileURLToPath(import.meta.url)), "../../scenes");

/** A scene with a cube over a floor, whose top is the plane z = 0; lengths in m. */
export const floor = { file: join(scenes, "cube-on-floor.xml"), halfEdge: 0.02 };

export function lengthOf(vector) {
  return Math.hypot(...vector);
}

/** Size of the force of a sample (time, then the wrench), N. */
export function forceOf(sample) {
  return lengthOf(sample.slice(1, 4));
}
