// SPDX-License-Identifier: Apache-2.0
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

/** The folder of the project's scenes. */
export const scenes = join(dirname(fileURLToPath(import.meta.url)), "../../scenes");

export function lengthOf(vector) {
  return Math.hypot(...vector);
}

/** Size of the force of a sample (time, then the wrench), N. */
export function forceOf(sample) {
  return lengthOf(sample.slice(1, 4));
}
