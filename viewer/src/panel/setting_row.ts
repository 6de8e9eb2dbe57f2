// SPDX-License-Identifier: Apache-2.0
import { make } from "../dom";
import type { Setting } from "../protocol";
import { SliderScale, sliderSteps } from "./slider_scale";

const pause = 50; // ms without change after which a value is sent

/** One setting of the rendering: a slider and a number, or a switch. */
export class SettingRow {
  readonly root = make("div", { className: "setting" });
  private readonly number = make("input", { type: "number", step: "any" });
  private readonly slider = make("input", { type: "range", min: "0", max: String(sliderSteps) });
  private readonly toggle = make("input", { type: "checkbox" });
  private readonly own = make("input", { type: "checkbox" });
  private scale: SliderScale;
  private timer = 0;
  private isTyping = false;

  constructor(private setting: Setting, private readonly send: (value: number | null) => void) {
    this.scale = new SliderScale(setting);
    this.nameParts();
    if (setting.is_switch) this.buildSwitch();
    else this.buildNumber();
    this.show(setting);
  }

  /** Takes over what the program says. */
  show(setting: Setting): void {
    const isNewRange = setting.least !== this.setting.least || setting.most !== this.setting.most;
    this.setting = setting;
    const isBeyond = setting.value !== null && setting.value > this.scale.most;
    if (isNewRange || isBeyond) this.scale = new SliderScale(setting);
    if (this.timer === 0 && !this.isTyping) this.restore();
  }

  /** Shows what is in force again, whatever has been typed. */
  restore(): void {
    window.clearTimeout(this.timer);
    this.timer = 0;
    this.isTyping = false;
    const { value, available } = this.setting;
    this.root.classList.toggle("unavailable", !available);
    for (const control of [this.number, this.slider, this.toggle, this.own]) control.disabled = !available;
    this.own.checked = value === null;
    this.toggle.checked = value === 1;
    if (value === null) {
      this.number.value = "";
      this.number.placeholder = "own";
      return;
    }
    if (!this.slider.matches(":active")) this.slider.value = String(this.scale.positionOf(value));
    if (Number(this.number.value) !== value || this.number.value === "") {
      this.number.value = String(Number(value.toPrecision(4)));
    }
    this.number.removeAttribute("aria-invalid");
  }

  private nameParts(): void {
    const { name, label, unit } = this.setting;
    this.number.id = `setting-${name}`;
    this.number.dataset.testid = `setting-${name}`;
    this.slider.dataset.testid = `slider-${name}`;
    this.toggle.dataset.testid = `setting-${name}`;
    this.own.dataset.testid = `own-${name}`;
    this.slider.setAttribute("aria-label", `${label}, slider`);
    if (unit !== "") this.number.setAttribute("aria-label", `${label} in ${unit}`);
  }

  private buildSwitch(): void {
    const label = make("label", { className: "switch" }, this.toggle, this.setting.label);
    this.root.append(label);
    this.toggle.addEventListener("change", () => this.send(this.toggle.checked ? 1 : 0));
  }

  private buildNumber(): void {
    const { label, unit, name } = this.setting;
    const unitLabel = make("span", { className: "unit", textContent: unit });
    const title = make("label", { htmlFor: this.number.id, textContent: label });
    this.root.append(title, this.slider, this.number, unitLabel);
    if (name === "friction") {
      const what = make("label", { className: "own", title: "Each object has the friction that the scene gives it" });
      what.append(this.own, "scene’s");
      unitLabel.replaceWith(what);
    }
    this.slider.addEventListener("input", () => {
      const value = this.scale.valueAt(Number(this.slider.value));
      this.number.value = String(value);
      this.sendSoon(value);
    });
    this.number.addEventListener("input", () => {
      this.isTyping = true;
      const value = this.number.valueAsNumber;
      this.number.setAttribute("aria-invalid", String(!Number.isFinite(value)));
      if (Number.isFinite(value)) this.slider.value = String(this.scale.positionOf(value));
    });
    this.number.addEventListener("change", () => {
      this.isTyping = false;
      if (Number.isFinite(this.number.valueAsNumber)) this.sendSoon(this.number.valueAsNumber);
      else this.restore();
    });
    this.own.addEventListener("change", () => this.send(this.own.checked ? null : this.scale.valueAt(sliderSteps / 4)));
  }

  private sendSoon(value: number): void {
    window.clearTimeout(this.timer);
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.send(value);
    }, pause);
  }
}
