// SPDX-License-Identifier: Apache-2.0
import { box, make, setText } from "../dom";
import type { Program } from "../program";
import { roundDown, roundWithUnit } from "../quantities";
import type { SceneView } from "../scene/scene_view";

const barWidth = 90; // pixels at most

/** What is drawn and in which colour, with a switch each, and how large it is drawn. */
export class Legend {
  private readonly bars: { line: HTMLElement; text: HTMLElement; unit: string; metres: () => number }[] = [];

  constructor(private readonly view: SceneView, program: Program) {
    this.addBar("#e8ecf2", "m", () => 1);
    this.addBar(view.force.colour, "N", () => view.force.scale.metresPerUnit);
    this.addBar(view.torque.colour, "N m", () => view.torque.scale.metresPerUnit);
    program.scenes.listen(() => this.fill());
    this.fill();
  }

  /** Scales as they are at the tool now. */
  showScales(): void {
    const metre = this.view.stage.pixelsPerMetre(this.view.toolCentre);
    for (const { line, text, unit, metres } of this.bars) {
      const pixels = metre * metres();
      const value = roundDown(barWidth / pixels);
      line.style.width = `${(value * pixels).toFixed(1)}px`;
      setText(text, roundWithUnit(value, unit));
    }
    setText(box("stretch-scale"), `friction stretched × ${roundWithUnit(this.view.anchors.exaggeration, "")}`);
  }

  private fill(): void {
    const list = box("layers");
    const shown = new Map(this.view.layers.map((layer) => [layer.name, layer.object.visible]));
    list.replaceChildren(
      ...this.view.layers.map((layer) => {
        const toggle = make("input", { type: "checkbox", checked: shown.get(layer.name) ?? true });
        toggle.dataset.testid = `layer-${layer.name}`;
        toggle.addEventListener("change", () => this.view.switchLayer(layer, toggle.checked));
        const swatch = make("span", { className: "swatch" });
        swatch.style.background = layer.colour;
        return make("li", {}, make("label", {}, toggle, swatch, layer.label));
      }),
    );
  }

  private addBar(colour: string, unit: string, metres: () => number): void {
    const line = make("span", { className: "bar" }), text = make("span");
    line.style.background = colour;
    box("scales").append(make("div", { className: "scale" }, line, text));
    this.bars.push({ line, text, unit, metres });
  }
}
