// SPDX-License-Identifier: Apache-2.0
import { Color, ConeGeometry, CylinderGeometry, Group, Mesh, MeshBasicMaterial, Vector3 } from "three";

const headLength = 4.5; // in radii of the shaft
const headRadius = 2.4;

/** An arrow with one head, or two for a torque. */
export class Arrow {
  readonly object = new Group();
  private readonly shaft: Mesh;
  private readonly heads: Mesh[] = [];

  /** `radius` of the shaft, m; one that is `onTop` is drawn over all else, so that the tool does not hide it. */
  constructor(colour: Color, private readonly radius: number, headCount: 1 | 2, onTop: boolean) {
    const look = new MeshBasicMaterial({ color: colour, depthTest: !onTop, transparent: onTop, fog: false });
    this.shaft = new Mesh(new CylinderGeometry(1, 1, 1, 10).translate(0, 0.5, 0), look);
    this.object.add(this.shaft);
    for (let i = 0; i < headCount; ++i) {
      const head = new Mesh(new ConeGeometry(headRadius, headLength, 14).translate(0, -headLength / 2, 0), look);
      this.heads.push(head);
      this.object.add(head);
    }
    this.object.traverse((part) => (part.renderOrder = 10));
  }

  /** From `start` along the unit vector `direction`; one shorter than its heads is drawn smaller as a whole. */
  point(start: Vector3, direction: Vector3, length: number): void {
    const heads = this.heads.length * headLength * this.radius * 0.8;
    const size = this.radius * Math.min(1, length / (1.5 * heads));
    this.object.visible = length > 1e-6 * this.radius;
    this.object.position.copy(start);
    this.object.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), direction);
    this.shaft.scale.set(size, Math.max(length - headLength * size, 1e-9), size);
    this.heads.forEach((head, i) => {
      head.position.y = length - i * 0.75 * headLength * size;
      head.scale.setScalar(size);
    });
  }
}
