// SPDX-License-Identifier: Apache-2.0
import { CanvasTexture, Color, Group, Sprite, SpriteMaterial, Vector3 } from "three";
import type { Scene } from "../protocol";
import { Arrow } from "./arrow";
import { colours } from "./colours";
import { empty } from "./disposal";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";

function letter(text: string, colour: string): Sprite {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const pen = canvas.getContext("2d");
  if (pen) {
    pen.font = "bold 52px system-ui, sans-serif";
    pen.textAlign = "center";
    pen.textBaseline = "middle";
    pen.lineWidth = 10;
    pen.strokeStyle = "#10141a";
    pen.strokeText(text, 32, 34);
    pen.fillStyle = colour;
    pen.fillText(text, 32, 34);
  }
  const look = new SpriteMaterial({ map: new CanvasTexture(canvas), sizeAttenuation: false, depthTest: false });
  const sprite = new Sprite(look);
  sprite.scale.setScalar(0.03);
  return sprite;
}

/** The world's axes, at its origin. */
export class AxesLayer implements Layer {
  readonly name = "axes";
  readonly label = "World axes x, y, z";
  readonly colour = `linear-gradient(90deg, ${colours.x} 33%, ${colours.y} 33% 66%, ${colours.z} 66%)`;
  readonly object = new Group();
  private readonly letters = { x: letter("x", colours.x), y: letter("y", colours.y), z: letter("z", colours.z) };

  begin(_scene: Scene, extent: SceneExtent): void {
    for (const sprite of Object.values(this.letters)) this.object.remove(sprite);
    empty(this.object);
    const length = Math.min(Math.max(0.25 * extent.bounds.radius, extent.toolRadius), 1.5 * extent.toolRadius);
    const directions = { x: new Vector3(1, 0, 0), y: new Vector3(0, 1, 0), z: new Vector3(0, 0, 1) };
    for (const axis of ["x", "y", "z"] as const) {
      const arrow = new Arrow(new Color(colours[axis]), 0.02 * length, 1, false);
      arrow.point(new Vector3(), directions[axis], length);
      this.letters[axis].position.copy(directions[axis]).multiplyScalar(1.15 * length);
      this.object.add(arrow.object, this.letters[axis]);
    }
  }

  show(): void {}
}
