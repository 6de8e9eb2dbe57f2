// SPDX-License-Identifier: Apache-2.0
import { Vector3, type Camera } from "three";

/** Directions that hands and keys mean, as unit vectors of the world. */
export interface ViewAxes {
  right: Vector3;
  /** The world's up. */
  up: Vector3;
  /** Away from the viewer, level. */
  away: Vector3;
}

export function viewAxes(camera: Camera): ViewAxes {
  const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
  const up = camera.up.clone();
  right.addScaledVector(up, -right.dot(up)).normalize();
  return { right, up, away: up.clone().cross(right) };
}
