// SPDX-License-Identifier: Apache-2.0
import { Raycaster, Vector2, Vector3, type Object3D } from "three";
import type { Program } from "../program";
import { pointOn } from "../poses";
import type { Scene, State } from "../protocol";
import { AnchorLayer } from "./anchor_layer";
import { AxesLayer } from "./axes_layer";
import { BodyLayer } from "./body_layer";
import { GroundLayer } from "./ground_layer";
import type { Layer } from "./layer";
import { PlaneLayer } from "./plane_layer";
import { ActivePointLayer, NearPointLayer } from "./point_layer";
import { RubberLayer } from "./rubber_layer";
import { extentOf, type SceneExtent } from "./scene_extent";
import { Stage } from "./stage";
import { HeldLayer, ProxyLayer } from "./tool_layer";
import { ForceLayer, TorqueLayer } from "./wrench_layers";

const grabDistance = 14; // pixels from its centre within which a small tool is taken

/** The 3-D view of the program's world. */
export class SceneView {
  readonly stage: Stage;
  readonly force = new ForceLayer();
  readonly torque = new TorqueLayer();
  readonly anchors = new AnchorLayer();
  private readonly proxy = new ProxyLayer();
  private readonly held = new HeldLayer();
  readonly layers: readonly Layer[] = [
    this.proxy,
    this.held,
    new RubberLayer(),
    this.force,
    this.torque,
    new ActivePointLayer(),
    new NearPointLayer(),
    this.anchors,
    new PlaneLayer(),
    new BodyLayer(),
    new GroundLayer(),
    new AxesLayer(),
  ];
  extent: SceneExtent | null = null;
  private scene: Scene | null = null;
  private state: State | null = null;
  private fresh = false;

  constructor(canvas: HTMLCanvasElement, program: Program) {
    this.stage = new Stage(canvas);
    this.stage.scene.add(...this.layers.map((layer) => layer.object));
    program.scenes.listen((scene) => this.begin(scene));
    program.states.listen((state) => this.take(state));
  }

  /** Draws the newest state where there is one; tells whether it has drawn. */
  draw(): boolean {
    if (this.fresh && this.state) {
      for (const layer of this.layers) layer.show(this.state);
      this.fresh = false;
      this.stage.touch();
    }
    return this.stage.draw();
  }

  switchLayer(layer: Layer, on: boolean): void {
    layer.object.visible = on;
    this.stage.touch();
  }

  /** The tool's centre of mass as the world allows it. */
  get toolCentre(): Vector3 {
    if (!this.scene || !this.state) return new Vector3();
    return pointOn(this.state.proxy, this.scene.tool.centre_of_mass);
  }

  frameTool(): void {
    if (this.extent) this.stage.frame(this.toolCentre, 8 * this.extent.toolRadius);
  }

  frameAll(): void {
    if (this.extent) this.stage.begin(this.extent, this.toolCentre);
  }

  /** Whether the tool, solid or ghost, is under a place of the page. */
  isToolAt(x: number, y: number): boolean {
    const centre = this.stage.onScreen(this.toolCentre);
    if (Math.hypot(centre.x - x, centre.y - y) < grabDistance) return true;
    const { left, top, width, height } = this.stage.canvas.getBoundingClientRect();
    const ray = new Raycaster();
    ray.setFromCamera(new Vector2((2 * (x - left)) / width - 1, 1 - (2 * (y - top)) / height), this.stage.camera);
    const shown = [this.proxy, this.held].map((layer): Object3D => layer.object).filter((object) => object.visible);
    return ray.intersectObjects(shown, true).length > 0;
  }

  private begin(scene: Scene): void {
    const first = this.scene === null || this.scene.name !== scene.name;
    this.scene = scene;
    this.state = null;
    this.extent = extentOf(scene);
    for (const layer of this.layers) layer.begin(scene, this.extent);
    if (first) this.needsFirstView = true;
    this.stage.touch();
  }

  private needsFirstView = false;

  private take(state: State): void {
    this.state = state;
    this.fresh = true;
    if (this.needsFirstView) this.frameAll();
    this.needsFirstView = false;
  }
}
