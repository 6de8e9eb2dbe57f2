// SPDX-License-Identifier: Apache-2.0
import { Box3, Group, Mesh, Sphere, Vector3 } from "three";
import { place } from "../poses";
import type { Pose, Scene, Shape } from "../protocol";
import { shapeGeometry } from "./shape_mesh";

/** How large a scene is, which sizes what is drawn over it. */
export interface SceneExtent {
  /** The world's up axis. */
  up: Vector3;
  /** Greatest distance of a tool's point from its centre of mass, m. */
  toolRadius: number;
  /** Of all bounded bodies. */
  bounds: Sphere;
  /** Height along the up axis at which the grid lies, m: a plane of the scene, else 0 where bodies reach so low. */
  ground: number;
  /** Distance (m) up to which planes without end are drawn. */
  horizon: number;
}

function boxOf(shapes: Shape[], pose: Pose): Box3 {
  const body = new Group();
  place(body, pose);
  for (const shape of shapes) {
    if (shape.kind === "plane") continue;
    const mesh = new Mesh(shapeGeometry(shape, 0));
    place(mesh, shape.pose);
    body.add(mesh);
  }
  const box = new Box3().setFromObject(body, true);
  for (const mesh of body.children) (mesh as Mesh).geometry.dispose();
  return box;
}

function toolRadius(scene: Scene): number {
  const box = boxOf(scene.tool.shapes, [0, 0, 0, 1, 0, 0, 0]);
  if (box.isEmpty()) return 0.1;
  const centre = new Vector3(...scene.tool.centre_of_mass);
  const far = new Vector3().copy(box.max).sub(centre).max(centre.clone().sub(box.min));
  return Math.max(far.length(), 1e-4);
}

/** Height of the highest plane that faces up, or null. */
function groundPlane(scene: Scene, up: Vector3): number | null {
  let height: number | null = null;
  for (const body of scene.bodies) {
    for (const shape of body.shapes) {
      if (shape.kind !== "plane") continue;
      const bodyPart = new Group(), part = new Group();
      place(bodyPart, body.pose);
      place(part, shape.pose);
      bodyPart.add(part);
      bodyPart.updateMatrixWorld(true);
      const normal = new Vector3(0, 0, 1).transformDirection(part.matrixWorld);
      const here = new Vector3().setFromMatrixPosition(part.matrixWorld).dot(up);
      if (normal.dot(up) > 0.999 && (height === null || here > height)) height = here;
    }
  }
  return height;
}

export function extentOf(scene: Scene): SceneExtent {
  const up = new Vector3(...scene.z_up).normalize();
  const all = new Box3();
  for (const body of scene.bodies) all.union(boxOf(body.shapes, body.pose));
  const radius = toolRadius(scene);
  if (all.isEmpty()) all.set(new Vector3().setScalar(-4 * radius), new Vector3().setScalar(4 * radius));
  const plane = groundPlane(scene, up);
  const bounds = all.getBoundingSphere(new Sphere());
  const lowest = Math.min(all.min.dot(up), all.max.dot(up));
  const horizon = 40 * Math.max(bounds.radius, 4 * radius);
  return { up, toolRadius: radius, bounds, ground: plane ?? Math.max(lowest, 0), horizon };
}
