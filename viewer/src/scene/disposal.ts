// SPDX-License-Identifier: Apache-2.0
import { Line, Mesh, type Object3D } from "three";

/** Takes all children off and gives back the memory of their geometries. */
export function empty(object: Object3D): void {
  object.traverse((part) => {
    if (part !== object && (part instanceof Mesh || part instanceof Line)) part.geometry.dispose();
  });
  object.clear();
}
