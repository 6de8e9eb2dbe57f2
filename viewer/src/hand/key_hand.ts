// SPDX-License-Identifier: Apache-2.0
import { takesKeys } from "../dom";
import type { Program } from "../program";
import type { Vector } from "../protocol";
import type { HandVelocity, VelocitySource } from "./velocity_source";

/** Axis (right, up, away) and sense of each key. */
const meanings: Record<string, [0 | 1 | 2, 1 | -1]> = {
  KeyD: [0, 1],
  ArrowRight: [0, 1],
  KeyA: [0, -1],
  ArrowLeft: [0, -1],
  KeyE: [1, 1],
  PageUp: [1, 1],
  KeyQ: [1, -1],
  PageDown: [1, -1],
  KeyW: [2, 1],
  ArrowUp: [2, 1],
  KeyS: [2, -1],
  ArrowDown: [2, -1],
};

/** Which axis a key turns about, and which way: right and left turn about up, away and towards about right. */
const turns: readonly [0 | 1 | 2, 1 | -1][] = [
  [1, 1],
  [2, -1],
  [0, -1],
];

/** The tool moved with keys, turned with Shift or Alt. */
export class KeyHand implements VelocitySource {
  readonly name = "keys";
  private readonly pressed = new Set<string>();
  private turning = false;

  constructor(private readonly program: Program) {
    window.addEventListener("keydown", (event) => this.press(event));
    window.addEventListener("keyup", (event) => {
      this.pressed.delete(event.code);
      this.turning = event.shiftKey || event.altKey;
    });
    window.addEventListener("blur", () => this.pressed.clear());
  }

  read(): HandVelocity | null {
    if (this.pressed.size === 0) return null;
    const linear: Vector = [0, 0, 0], angular: Vector = [0, 0, 0];
    for (const code of this.pressed) {
      const [axis, sense] = meanings[code] ?? [0, 1];
      if (this.turning) {
        const [about, way] = turns[axis] ?? [0, 1];
        angular[about] += way * sense;
      } else {
        linear[axis] += sense;
      }
    }
    return { linear, angular };
  }

  private press(event: KeyboardEvent): void {
    this.turning = event.shiftKey || event.altKey;
    if (event.ctrlKey || event.metaKey || !(event.code in meanings)) return;
    if (!this.program.pageIsHand || takesKeys(event.target) || document.querySelector("dialog[open]")) return;
    event.preventDefault();
    this.pressed.add(event.code);
  }
}
