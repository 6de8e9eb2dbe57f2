// SPDX-License-Identifier: Apache-2.0
import { Color, Group, Vector3 } from "three";
import { pointOn } from "../poses";
import type { Scene, State, Vector } from "../protocol";
import { AdaptiveScale } from "./adaptive_scale";
import { Arrow } from "./arrow";
import { colours } from "./colours";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";

const fullLength = 2.2; // of the longest arrow, in radii of the tool
const shaft = 0.045; // radius, in radii of the tool

/** Half of the displayed wrench as an arrow at the centre of mass of the tool. */
class VectorLayer implements Layer {
  readonly object = new Group();
  readonly scale: AdaptiveScale;
  private arrow: Arrow | null = null;
  private centre: Vector = [0, 0, 0];

  /** `first` of the three components in a wrench; `leastRange` is what the longest arrow stands for at least. */
  constructor(
    readonly name: string,
    readonly label: string,
    readonly colour: string,
    private readonly first: 0 | 3,
    leastRange: number,
  ) {
    this.scale = new AdaptiveScale(1, leastRange);
  }

  begin(scene: Scene, extent: SceneExtent): void {
    this.object.clear();
    this.arrow = new Arrow(new Color(this.colour), shaft * extent.toolRadius, this.first === 0 ? 1 : 2, true);
    this.object.add(this.arrow.object);
    this.arrow.object.visible = false;
    this.scale.begin(fullLength * extent.toolRadius);
    this.centre = scene.tool.centre_of_mass;
  }

  show(state: State): void {
    const [x, y, z] = state.wrench.slice(this.first, this.first + 3) as Vector;
    const vector = new Vector3(x, y, z);
    const size = vector.length();
    this.scale.observe(size, state.t);
    if (size > 0) vector.divideScalar(size);
    this.arrow?.point(pointOn(state.proxy, this.centre), vector, size * this.scale.metresPerUnit);
  }
}

/** The force that the hand feels. */
export class ForceLayer extends VectorLayer {
  constructor() {
    super("force", "Force", colours.force, 0, 2);
  }
}

/** The torque about the centre of mass that the hand feels; two heads, along its axis. */
export class TorqueLayer extends VectorLayer {
  constructor() {
    super("torque", "Torque", colours.torque, 3, 0.05);
  }
}
