// SPDX-License-Identifier: Apache-2.0
import { GridHelper, Group, Vector3 } from "three";
import { roundDown, roundWithUnit } from "../quantities";
import type { Scene } from "../protocol";
import { colours } from "./colours";
import { empty } from "./disposal";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";

const cells = 40;

/** A grid on the ground. */
export class GroundLayer implements Layer {
  readonly name = "grid";
  readonly colour = colours.grid;
  readonly object = new Group();
  label = "Grid";

  begin(_scene: Scene, extent: SceneExtent): void {
    empty(this.object);
    const cell = roundDown(Math.max(extent.bounds.radius, 4 * extent.toolRadius) / 4);
    this.label = `Grid, ${roundWithUnit(cell, "m")}`;
    const grid = new GridHelper(cells * cell, cells, colours.grid, colours.grid);
    grid.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), extent.up);
    // Under bodies that stand on no plane, so that it does not cut their lower side.
    const below = extent.hasGroundPlane ? 0 : 1e-3 * extent.bounds.radius;
    grid.position.copy(extent.up).multiplyScalar(extent.ground - below);
    this.object.add(grid);
  }

  show(): void {}
}
