// SPDX-License-Identifier: Apache-2.0
import {
  BoxGeometry,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  EdgesGeometry,
  Float32BufferAttribute,
  LineBasicMaterial,
  LineSegments,
  Material,
  Mesh,
  PlaneGeometry,
  SphereGeometry,
} from "three";
import { place } from "../poses";
import type { Shape } from "../protocol";

const edgeAngle = 35; // degrees between two faces from which their edge is drawn
const edgeLook = new LineBasicMaterial({ color: 0x0b0e13, transparent: true, opacity: 0.55 });

/** The hull's triangles with corners of their own, so that faces are flat under the light. */
function hullGeometry(shape: Shape): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new Float32BufferAttribute(shape.vertices ?? [], 3));
  geometry.setIndex(shape.triangles ?? []);
  const flat = geometry.toNonIndexed();
  flat.computeVertexNormals();
  geometry.dispose();
  return flat;
}

/** Geometry in the shape's frame. A plane has no end; it is drawn up to `horizon` (m) from its origin. */
export function shapeGeometry(shape: Shape, horizon: number): BufferGeometry {
  const [a, b, c] = shape.size;
  switch (shape.kind) {
    case "box":
      return new BoxGeometry(2 * a, 2 * b, 2 * c);
    case "sphere":
      return new SphereGeometry(a, 32, 20);
    case "ellipsoid":
      return new SphereGeometry(1, 32, 20).scale(a, b, c);
    case "capsule":
      return new CapsuleGeometry(a, 2 * b, 8, 24).rotateX(Math.PI / 2);
    case "cylinder":
      return new CylinderGeometry(a, a, 2 * b, 32).rotateX(Math.PI / 2);
    case "hull":
      return hullGeometry(shape);
    case "plane":
      return new PlaneGeometry(2 * horizon, 2 * horizon);
  }
}

/** The shape as a mesh placed on its body, with its edges drawn where `withEdges` is true. */
export function shapeMesh(shape: Shape, look: Material, horizon: number, withEdges: boolean): Mesh {
  const mesh = new Mesh(shapeGeometry(shape, horizon), look);
  place(mesh, shape.pose);
  if (withEdges && ["box", "hull", "cylinder"].includes(shape.kind)) {
    mesh.add(new LineSegments(new EdgesGeometry(mesh.geometry, edgeAngle), edgeLook));
  }
  return mesh;
}
