// SPDX-License-Identifier: Apache-2.0
import { Vector3 } from "three";
import type { Program } from "../program";
import { translated, turnBy, turned } from "../poses";
import type { SceneView } from "../scene/scene_view";
import type { Hand } from "./hand";

const turnPerPixel = Math.PI / 400; // rad
const wheelStep = 0.0012; // of the distance to the tool, a pixel of the wheel

/** The tool dragged with the mouse: across the view, turned with Shift, along the view with the wheel. */
export class MouseHand {
  private pointer: number | null = null;

  constructor(private readonly hand: Hand, private readonly view: SceneView, private readonly program: Program) {
    const area = view.stage.canvas.parentElement ?? view.stage.canvas;
    // Before the camera's own listeners, which must not see what the tool takes.
    area.addEventListener("pointerdown", (event) => this.press(event), { capture: true });
    area.addEventListener("pointermove", (event) => this.drag(event), { capture: true });
    area.addEventListener("wheel", (event) => this.roll(event), { capture: true, passive: false });
    for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const) {
      area.addEventListener(end, (event) => this.letGo(event), { capture: true });
    }
  }

  private press(event: PointerEvent): void {
    const { canvas } = this.view.stage;
    if (event.target !== canvas || event.button !== 0 || this.pointer !== null) return;
    if (!this.program.pageIsHand || !this.view.isToolAt(event.clientX, event.clientY)) return;
    event.stopPropagation();
    if (!this.hand.take("mouse")) return;
    this.pointer = event.pointerId;
    canvas.setPointerCapture(event.pointerId);
    canvas.classList.add("grabbing");
  }

  private drag(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) {
      if (event.target === this.view.stage.canvas && event.buttons === 0) this.hover(event);
      return;
    }
    event.stopPropagation();
    if (event.shiftKey) this.turn(event.movementX, event.movementY);
    else this.slide(event.movementX, event.movementY);
  }

  private slide(x: number, y: number): void {
    const { camera } = this.view.stage;
    const metre = this.view.stage.pixelsPerMetre(this.view.toolCentre);
    const step = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0).multiplyScalar(x / metre);
    step.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrixWorld, 1), -y / metre);
    this.hand.move((target) => translated(target, step));
  }

  private turn(x: number, y: number): void {
    const { camera } = this.view.stage;
    const axis = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1).multiplyScalar(x * turnPerPixel);
    axis.addScaledVector(new Vector3().setFromMatrixColumn(camera.matrixWorld, 0), y * turnPerPixel);
    const centre = this.program.scene?.tool.centre_of_mass ?? [0, 0, 0];
    this.hand.move((target) => turned(target, turnBy(axis), centre));
  }

  private roll(event: WheelEvent): void {
    if (this.pointer === null) return;
    event.preventDefault();
    event.stopPropagation();
    const { camera } = this.view.stage;
    const away = this.view.toolCentre.sub(camera.position);
    const step = away.multiplyScalar(-wheelStep * Math.max(-100, Math.min(100, event.deltaY)));
    this.hand.move((target) => translated(target, step));
  }

  private letGo(event: PointerEvent): void {
    if (event.pointerId !== this.pointer) return;
    this.pointer = null;
    this.hand.release("mouse");
    this.view.stage.canvas.classList.remove("grabbing");
  }

  private hover(event: PointerEvent): void {
    const canTake = this.program.pageIsHand && this.view.isToolAt(event.clientX, event.clientY);
    this.view.stage.canvas.classList.toggle("grab", canTake);
  }
}
