// SPDX-License-Identifier: Apache-2.0
import { BufferAttribute, BufferGeometry, CanvasTexture, DynamicDrawUsage, Points, PointsMaterial } from "three";

function discTexture(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 32;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.beginPath();
    pen.arc(16, 16, 13, 0, 2 * Math.PI);
    pen.fillStyle = "#fff";
    pen.fill();
    pen.lineWidth = 4;
    pen.strokeStyle = "#1b212b";
    pen.stroke();
  }
  return new CanvasTexture(canvas);
}

/** Round dots of one colour and a size in pixels that does not depend on the distance, seen through everything. */
export class Dots {
  readonly object: Points;
  private readonly positions: BufferAttribute;

  constructor(colour: string, pixels: number, private readonly capacity: number) {
    this.positions = new BufferAttribute(new Float32Array(3 * capacity), 3).setUsage(DynamicDrawUsage);
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.positions);
    geometry.setDrawRange(0, 0);
    const look = new PointsMaterial({
      color: colour,
      size: pixels,
      sizeAttenuation: false,
      map: discTexture(),
      alphaTest: 0.4,
      depthTest: false,
      transparent: true,
      fog: false,
    });
    this.object = new Points(geometry, look);
    this.object.frustumCulled = false;
    this.object.renderOrder = 8;
  }

  /** Draws dots at these points; those beyond the capacity are left out. */
  show(points: readonly (readonly number[])[]): void {
    const count = Math.min(points.length, this.capacity);
    for (let i = 0; i < count; ++i) {
      const [x, y, z] = points[i]!;
      this.positions.setXYZ(i, x!, y!, z!);
    }
    this.positions.needsUpdate = true;
    this.object.geometry.setDrawRange(0, count);
  }
}
