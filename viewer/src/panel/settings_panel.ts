// SPDX-License-Identifier: Apache-2.0
import { box, make, select, setText } from "../dom";
import type { Program } from "../program";
import type { Setting, Settings } from "../protocol";
import { SettingRow } from "./setting_row";

/** Those that stand in the panel at once; the others are folded away below. */
const first = ["stiffness", "damping", "metric_length", "friction", "physics_rate"];

/** The rendering method and its settings, which act at once. */
export class SettingsPanel {
  private readonly method = select("method");
  private readonly rows = new Map<string, SettingRow>();
  private method_summaries = new Map<string, string>();

  constructor(private readonly program: Program) {
    this.method.addEventListener("change", () => program.send({ type: "method", name: this.method.value }));
    program.scenes.listen((scene) => {
      this.method_summaries = new Map(scene.methods.map(({ name, summary }) => [name, summary]));
      this.method.replaceChildren(
        ...scene.methods.map(({ name, summary }) => make("option", { value: name, textContent: name, title: summary })),
      );
      this.forgetRows();
      if (program.settings) this.show(program.settings);
    });
    program.settingsChanges.listen((settings) => this.show(settings));
    program.notices.listen(({ level }) => {
      if (level === "info" || !program.settings) return;
      for (const row of this.rows.values()) row.restore();
      this.method.value = program.settings.method;
    });
  }

  private forgetRows(): void {
    this.rows.clear();
    box("settings").replaceChildren();
    box("more-settings").replaceChildren();
  }

  private show(settings: Settings): void {
    this.method.value = settings.method;
    setText(box("method-summary"), this.method_summaries.get(settings.method) ?? "");
    for (const setting of settings.values) {
      const row = this.rows.get(setting.name);
      if (row) row.show(setting);
      else this.add(setting);
    }
    box("more").hidden = box("more-settings").children.length === 0;
  }

  private add(setting: Setting): void {
    const row = new SettingRow(setting, (value) => this.program.send({ type: "set", name: setting.name, value }));
    this.rows.set(setting.name, row);
    box(first.includes(setting.name) ? "settings" : "more-settings").append(row.root);
  }
}
