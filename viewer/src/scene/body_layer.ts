// SPDX-License-Identifier: Apache-2.0
import { Color, Group, MeshLambertMaterial, SRGBColorSpace } from "three";
import { place } from "../poses";
import type { Scene, Shape, State } from "../protocol";
import { colours } from "./colours";
import { empty } from "./disposal";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";
import { shapeMesh } from "./shape_mesh";

const planeShade = 0.32; // a ground without end in its full light colour would outshine all that stands on it

/** The shape's colour under light. It is drawn a little deeper than it is, so that lines on its surface show. */
export function bodyLook(shape: Shape): MeshLambertMaterial {
  const [r, g, b, a] = shape.colour;
  const shade = shape.kind === "plane" ? planeShade : 1;
  const color = new Color().setRGB(r * shade, g * shade, b * shade, SRGBColorSpace);
  const look = new MeshLambertMaterial({ color, transparent: a < 1, opacity: a });
  look.polygonOffset = true;
  look.polygonOffsetFactor = 1;
  look.polygonOffsetUnits = 4;
  return look;
}

/** The bodies of the world. */
export class BodyLayer implements Layer {
  readonly name = "bodies";
  readonly label = "Bodies";
  readonly colour = colours.bodies;
  readonly object = new Group();
  private readonly moving: Group[] = [];

  begin(scene: Scene, extent: SceneExtent): void {
    empty(this.object);
    this.moving.length = 0;
    for (const body of scene.bodies) {
      const group = new Group();
      group.name = body.name;
      for (const shape of body.shapes) group.add(shapeMesh(shape, bodyLook(shape), extent.horizon, true));
      place(group, body.pose);
      this.object.add(group);
      if (body.moving_index >= 0) this.moving[body.moving_index] = group;
    }
  }

  show(state: State): void {
    state.bodies.forEach((pose, i) => {
      const body = this.moving[i];
      if (body) place(body, pose);
    });
  }
}
