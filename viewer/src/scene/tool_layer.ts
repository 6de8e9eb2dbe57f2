// SPDX-License-Identifier: Apache-2.0
import { Group, MeshLambertMaterial } from "three";
import { place } from "../poses";
import type { Scene, Shape, State } from "../protocol";
import { bodyLook } from "./body_layer";
import { colours } from "./colours";
import { empty } from "./disposal";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";
import { shapeMesh } from "./shape_mesh";

/** The tool's shapes in a look of their own. */
function drawTool(object: Group, shapes: Shape[], look: (shape: Shape) => MeshLambertMaterial, edges: boolean): void {
  empty(object);
  for (const shape of shapes) object.add(shapeMesh(shape, look(shape), 0, edges));
}

/** The tool where the world allows it: solid, in its own colours. */
export class ProxyLayer implements Layer {
  readonly name = "proxy";
  readonly label = "Tool as the world allows it";
  readonly object = new Group();
  colour: string = colours.proxy;

  begin(scene: Scene, _extent: SceneExtent): void {
    drawTool(this.object, scene.tool.shapes, bodyLook, true);
    const first = scene.tool.shapes[0];
    if (first) this.colour = `#${bodyLook(first).color.getHexString()}`;
  }

  show(state: State): void {
    place(this.object, state.proxy);
  }
}

/** The tool where it is held: a ghost, seen only where it is not inside the solid one. */
export class HeldLayer implements Layer {
  readonly name = "held";
  readonly label = "Tool as it is held";
  readonly colour = colours.held;
  readonly object = new Group();
  private readonly look = new MeshLambertMaterial({
    color: colours.held,
    emissive: colours.held,
    emissiveIntensity: 0.25,
    transparent: true,
    opacity: 0.42,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 8,
  });

  begin(scene: Scene, _extent: SceneExtent): void {
    drawTool(this.object, scene.tool.shapes, () => this.look, false);
  }

  show(state: State): void {
    place(this.object, state.tool);
  }
}
