// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from "three";
import type { Program } from "../program";
import { translated, turnBy, turned } from "../poses";
import type { Vector } from "../protocol";
import type { SceneView } from "../scene/scene_view";
import type { Hand } from "./hand";
import type { VelocitySource } from "./velocity_source";
import { viewAxes } from "./view_axes";

const speed = 1.6; // radii of the tool a second
const turnSpeed = Math.PI / 4; // rad/s
const longestStep = 0.05; // s; after a stall the tool does not leap
const rest = 350; // ms without motion after which the tool is let go

/** Moves the tool as keys, gamepad and SpaceMouse ask, along the axes of the view. */
export class DrivenHand {
  private lastFrame = 0;
  private lastMotion = -Infinity;
  private refused = false;

  constructor(
    private readonly hand: Hand,
    private readonly view: SceneView,
    private readonly program: Program,
    private readonly sources: readonly VelocitySource[],
  ) {}

  /** Called with every frame of the page, at the time `now` (ms). */
  frame(now: number): void {
    const step = Math.min((now - this.lastFrame) / 1000, longestStep);
    this.lastFrame = now;
    const velocity = this.sources.map((source) => source.read()).find((read) => read !== null);
    if (!velocity || this.program.scene === null || !this.program.pageIsHand) {
      this.refused = false;
      if (now - this.lastMotion > rest) this.hand.release("drive");
      return;
    }
    if (this.refused) return;
    this.refused = !this.hand.take("drive");
    if (this.refused) return;
    this.lastMotion = now;
    const { linear, angular } = velocity;
    const radius = this.view.extent?.toolRadius ?? 0;
    const slide = this.alongView(linear).multiplyScalar(speed * radius * step);
    const turn = turnBy(this.alongView(angular).multiplyScalar(turnSpeed * step));
    const centre = this.program.scene.tool.centre_of_mass;
    this.hand.move((target) => turned(translated(target, slide), turn, centre));
  }

  private alongView([x, y, z]: Vector): Vector3 {
    const { right, up, away } = viewAxes(this.view.stage.camera);
    return new Vector3().addScaledVector(right, x).addScaledVector(up, y).addScaledVector(away, z);
  }
}
