// SPDX-License-Identifier: Apache-2.0
import type { HandVelocity, VelocitySource } from "./velocity_source";

const deadZone = 0.14; // of a stick's way

/** What a stick asks for: nothing in its middle, then from 0 on, finer near the middle. */
export function stick(value: number): number {
  const beyond = Math.max(0, Math.abs(value) - deadZone) / (1 - deadZone);
  return Math.sign(value) * beyond * beyond;
}

/**
 * A gamepad in the standard mapping. Left stick: right and away; triggers: up (right) and down (left). Right stick:
 * turns about up and about right; shoulder buttons roll.
 */
export function gamepadVelocity(axes: readonly number[], buttons: readonly { value: number }[]): HandVelocity | null {
  const axis = (i: number) => stick(axes[i] ?? 0);
  const button = (i: number) => buttons[i]?.value ?? 0;
  const velocity: HandVelocity = {
    linear: [axis(0), button(7) - button(6), -axis(1)],
    angular: [axis(3), axis(2), button(5) - button(4)],
  };
  const rests = [...velocity.linear, ...velocity.angular].every((value) => value === 0);
  return rests ? null : velocity;
}

export class GamepadHand implements VelocitySource {
  readonly name = "gamepad";

  read(): HandVelocity | null {
    for (const pad of navigator.getGamepads()) {
      const velocity = pad?.connected && pad.mapping === "standard" ? gamepadVelocity(pad.axes, pad.buttons) : null;
      if (velocity) return velocity;
    }
    return null;
  }
}
