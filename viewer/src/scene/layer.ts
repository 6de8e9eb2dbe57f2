// SPDX-License-Identifier: Apache-2.0
import type { Object3D } from "three";
import type { Scene, State } from "../protocol";
import type { SceneExtent } from "./scene_extent";

/** One kind of thing in the 3-D view, which can be hidden. */
export interface Layer {
  /** Stable name, of its switch too. */
  readonly name: string;
  /** What the legend calls it. */
  readonly label: string;
  /** Of its swatch in the legend: a background of CSS. */
  readonly colour: string;
  readonly object: Object3D;
  /** Draws another scene; what was drawn of the last one is given back. */
  begin(scene: Scene, extent: SceneExtent): void;
  /** Draws a state of that scene. */
  show(state: State): void;
}
