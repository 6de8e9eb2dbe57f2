// SPDX-License-Identifier: Apache-2.0
import { Color, DirectionalLight, Fog, HemisphereLight, PerspectiveCamera, Scene, Vector3, WebGLRenderer } from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { colours } from "./colours";
import type { SceneExtent } from "./scene_extent";
import { drawsInSoftware } from "./software_rendering";

const fieldOfView = 40; // degrees, vertical
const softwarePixels = 640e3; // that a processor draws fast enough; larger views are drawn coarser

/** Canvas, camera and light. It draws only after something has changed. */
export class Stage {
  readonly inSoftware = drawsInSoftware();
  readonly scene = new Scene();
  readonly camera = new PerspectiveCamera(fieldOfView, 1, 0.01, 100);
  controls: OrbitControls;
  private readonly renderer: WebGLRenderer;
  private readonly sun = new DirectionalLight(0xffffff, 1.7);
  private readonly sky = new HemisphereLight(0xdfe8f5, 0x59606b, 1.35);
  private changed = true;

  constructor(readonly canvas: HTMLCanvasElement) {
    this.renderer = new WebGLRenderer({ canvas, antialias: !this.inSoftware, powerPreference: "high-performance" });
    this.scene.background = new Color(colours.background);
    this.scene.add(this.sun, this.sky);
    this.controls = this.newControls();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement ?? canvas);
    this.resize();
  }

  /** Light, fog and first view for a scene, with the tool's centre of mass at `tool`. */
  begin(extent: SceneExtent, tool: Vector3): void {
    const { up, toolRadius, bounds } = extent;
    const right = new Vector3(1, 0, 0).cross(up).lengthSq() > 0.5 ? new Vector3(1, 0, 0) : new Vector3(0, 1, 0);
    const back = right.clone().cross(up);
    this.sky.position.copy(up);
    this.sun.position.copy(up).addScaledVector(right, 0.55).addScaledVector(back, 0.8);
    const distance = Math.min(Math.max(2.5 * bounds.radius, 7 * toolRadius), 15 * toolRadius);
    this.camera.up.copy(up);
    this.camera.near = 0.1 * toolRadius;
    this.camera.far = 2 * extent.horizon;
    this.scene.fog = new Fog(colours.background, 4 * distance, 14 * distance);
    this.controls.dispose();
    this.controls = this.newControls();
    // The whole of a scene stands below and beside its tool more often than above.
    const target = tool.clone().lerp(bounds.center, bounds.radius < 12 * toolRadius ? 0.4 : 0);
    const direction = back.clone().addScaledVector(right, 0.55).addScaledVector(up, 0.55).normalize();
    this.look(target, direction, distance);
    this.camera.updateProjectionMatrix();
  }

  /** Brings the point to the middle of the view, `distance` away, seen from where it is seen now. */
  frame(point: Vector3, distance: number): void {
    this.look(point, this.camera.position.clone().sub(this.controls.target).normalize(), distance);
  }

  /** Something to draw has changed. */
  touch(): void {
    this.changed = true;
  }

  /** Draws where something has changed since; tells whether. */
  draw(): boolean {
    if (!this.changed) return false;
    this.changed = false;
    this.renderer.render(this.scene, this.camera);
    return true;
  }

  /** Pixels of the page that a length of 1 m at the point has across the view. */
  pixelsPerMetre(point: Vector3): number {
    const forward = this.camera.getWorldDirection(new Vector3());
    const depth = Math.max(point.clone().sub(this.camera.position).dot(forward), 1e-9);
    return this.canvas.clientHeight / (2 * depth * Math.tan((fieldOfView * Math.PI) / 360));
  }

  /** Where in the page the point is seen, in pixels from its upper left corner. */
  onScreen(point: Vector3): { x: number; y: number } {
    this.camera.updateMatrixWorld();
    const p = point.clone().project(this.camera);
    const { left, top, width, height } = this.canvas.getBoundingClientRect();
    return { x: left + ((p.x + 1) / 2) * width, y: top + ((1 - p.y) / 2) * height };
  }

  private look(target: Vector3, direction: Vector3, distance: number): void {
    this.controls.target.copy(target);
    this.camera.position.copy(target).addScaledVector(direction, distance);
    this.controls.update();
    this.touch();
  }

  private newControls(): OrbitControls {
    const controls = new OrbitControls(this.camera, this.canvas);
    controls.enableDamping = false;
    controls.zoomToCursor = true;
    controls.addEventListener("change", () => this.touch());
    return controls;
  }

  private resize(): void {
    const { clientWidth, clientHeight } = this.canvas.parentElement ?? this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    const coarser = Math.min(1, Math.sqrt(softwarePixels / (clientWidth * clientHeight)));
    this.renderer.setPixelRatio(this.inSoftware ? coarser : Math.min(window.devicePixelRatio, 2));
    this.renderer.setSize(clientWidth, clientHeight);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.touch();
  }
}
