// SPDX-License-Identifier: Apache-2.0
import { Object3D, Quaternion, Vector3 } from "three";
import type { Pose, Vector } from "./protocol";

export function positionOf(pose: Pose): Vector3 {
  return new Vector3(pose[0], pose[1], pose[2]);
}

export function rotationOf(pose: Pose): Quaternion {
  return new Quaternion(pose[4], pose[5], pose[6], pose[3]);
}

export function poseOf(p: Vector3, q: Quaternion): Pose {
  return [p.x, p.y, p.z, q.w, q.x, q.y, q.z];
}

export function place(object: Object3D, pose: Pose): void {
  object.position.set(pose[0], pose[1], pose[2]);
  object.quaternion.set(pose[4], pose[5], pose[6], pose[3]);
}

/** Where a point of the body, in its frame, is in the world. */
export function pointOn(pose: Pose, point: Vector): Vector3 {
  return new Vector3(...point).applyQuaternion(rotationOf(pose)).add(positionOf(pose));
}

export function translated(pose: Pose, step: Vector3): Pose {
  return poseOf(positionOf(pose).add(step), rotationOf(pose));
}

/** The pose turned by `turn` (world axes) about `centre`, a point of the body in its frame, which stays where it is. */
export function turned(pose: Pose, turn: Quaternion, centre: Vector): Pose {
  const fixed = pointOn(pose, centre);
  const q = turn.clone().multiply(rotationOf(pose)).normalize();
  const p = fixed.sub(new Vector3(...centre).applyQuaternion(q));
  return poseOf(p, q);
}

/** The turn by the angles of `vector` (rad) about the axis along it. */
export function turnBy(vector: Vector3): Quaternion {
  const angle = vector.length();
  if (angle === 0) return new Quaternion();
  return new Quaternion().setFromAxisAngle(vector.clone().divideScalar(angle), angle);
}
