// SPDX-License-Identifier: Apache-2.0
import { GreaterDepth, Group, MeshLambertMaterial } from "three";
import { place, positionOf } from "../poses";
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

const apart = 0.02; // radii of the tool from which the ghost is seen through what hides it

function ghostLook(opacity: number): MeshLambertMaterial {
  return new MeshLambertMaterial({
    color: colours.held,
    emissive: colours.held,
    emissiveIntensity: 0.25,
    transparent: true,
    opacity,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: 2,
    polygonOffsetUnits: 8,
  });
}

/** The tool where it is held: a ghost, fainter where something hides it, as the floor does that it is pressed into. */
export class HeldLayer implements Layer {
  readonly name = "held";
  readonly label = "Tool as it is held";
  readonly colour = colours.held;
  readonly object = new Group();
  private readonly open = new Group();
  private readonly hidden = new Group();
  private readonly look = ghostLook(0.42);
  private readonly hiddenLook = ghostLook(0.14);
  private radius = 1;

  constructor() {
    this.hiddenLook.depthFunc = GreaterDepth;
    this.object.add(this.open, this.hidden);
  }

  begin(scene: Scene, extent: SceneExtent): void {
    drawTool(this.open, scene.tool.shapes, () => this.look, false);
    drawTool(this.hidden, scene.tool.shapes, () => this.hiddenLook, false);
    this.radius = extent.toolRadius;
  }

  show(state: State): void {
    place(this.object, state.tool);
    // Where it is at the solid tool, that one hides it, and shall look as it does.
    this.hidden.visible = positionOf(state.tool).distanceTo(positionOf(state.proxy)) > apart * this.radius;
  }
}
