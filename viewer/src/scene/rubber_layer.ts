// SPDX-License-Identifier: Apache-2.0
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Line, LineBasicMaterial } from "three";
import { pointOn } from "../poses";
import type { Scene, State, Vector } from "../protocol";
import { colours } from "./colours";
import type { Layer } from "./layer";

/** A line from the tool, where the world allows it, over where it is held to where the hand means it to be. */
export class RubberLayer implements Layer {
  readonly name = "rubber";
  readonly label = "Pull of the hand";
  readonly colour = colours.rubber;
  readonly object: Line;
  private readonly ends = new BufferAttribute(new Float32Array(9), 3).setUsage(DynamicDrawUsage);
  private centre: Vector = [0, 0, 0];

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.ends);
    const look = new LineBasicMaterial({ color: colours.rubber, depthTest: false, transparent: true, fog: false });
    this.object = new Line(geometry, look);
    this.object.frustumCulled = false;
    this.object.renderOrder = 7;
  }

  begin(scene: Scene): void {
    this.centre = scene.tool.centre_of_mass;
    this.object.geometry.setDrawRange(0, 0);
  }

  show(state: State): void {
    [state.proxy, state.tool, state.target ?? state.tool].forEach((pose, i) => {
      const p = pointOn(pose, this.centre);
      this.ends.setXYZ(i, p.x, p.y, p.z);
    });
    this.ends.needsUpdate = true;
    this.object.geometry.setDrawRange(0, 3);
  }
}
