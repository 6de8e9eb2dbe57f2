// SPDX-License-Identifier: Apache-2.0
import { BufferGeometry, Float32BufferAttribute, Group, LineBasicMaterial, LineSegments, Vector3 } from "three";
import { roundDown, roundWithUnit } from "../quantities";
import type { Scene } from "../protocol";
import { colours } from "./colours";
import { empty } from "./disposal";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";

const pieces = 12; // of each line
const cellsPerPiece = 3;

/**
 * A square lattice in the plane y = 0 about the origin. Its lines consist of pieces: some software renderers leave out
 * a line that reaches behind the camera.
 */
function lattice(cell: number): BufferGeometry {
  const cells = pieces * cellsPerPiece;
  const ends: number[] = [];
  for (let i = 0; i <= cells; ++i) {
    const across = (i - cells / 2) * cell;
    for (let k = 0; k < pieces; ++k) {
      const from = (k * cellsPerPiece - cells / 2) * cell, to = from + cellsPerPiece * cell;
      ends.push(from, 0, across, to, 0, across, across, 0, from, across, 0, to);
    }
  }
  return new BufferGeometry().setAttribute("position", new Float32BufferAttribute(ends, 3));
}

/** A grid on the ground. */
export class GroundLayer implements Layer {
  readonly name = "grid";
  readonly colour = colours.grid;
  readonly object = new Group();
  label = "Grid";
  private readonly look = new LineBasicMaterial({ color: colours.grid });

  begin(_scene: Scene, extent: SceneExtent): void {
    empty(this.object);
    const cell = roundDown(Math.max(extent.bounds.radius / 8, 1.5 * extent.toolRadius));
    this.label = `Grid, ${roundWithUnit(cell, "m")}`;
    const grid = new LineSegments(lattice(cell), this.look);
    grid.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), extent.up);
    grid.position.copy(extent.up).multiplyScalar(extent.ground);
    this.object.add(grid);
  }

  show(): void {}
}
