// SPDX-License-Identifier: Apache-2.0
import { box, button, setText, takesKeys } from "../dom";
import type { Program } from "../program";
import { grouped } from "../quantities";

/** Pause, step, reset and recording. */
export class Transport {
  private readonly pause = button("pause");
  private readonly record = button("record");

  constructor(private readonly program: Program) {
    this.pause.addEventListener("click", () => this.togglePause());
    button("step").addEventListener("click", () => program.send({ type: "step" }));
    button("reset").addEventListener("click", () => program.send({ type: "reset" }));
    this.record.addEventListener("click", () => this.toggleRecording());
    window.addEventListener("keydown", (event) => this.press(event));
    program.states.listen((state) => {
      const { paused, recording, recording_file, recording_ticks, t } = state;
      setText(this.pause, paused ? "Resume" : "Pause");
      this.pause.setAttribute("aria-pressed", String(paused));
      button("step").disabled = !paused;
      setText(this.record, recording ? "Stop recording" : "Record");
      this.record.setAttribute("aria-pressed", String(recording));
      const ticks = grouped(recording_ticks ?? 0);
      const file = recording_file ?? "";
      setText(box("recording"), recording ? `${file.slice(file.lastIndexOf("/") + 1)} · ${ticks} ticks` : "");
      box("recording").title = recording ? file : "";
      setText(box("time"), `${t.toFixed(2)} s`);
      document.body.classList.toggle("paused", paused);
    });
  }

  private togglePause(): void {
    const { state, scene } = this.program;
    if (state === null || scene?.mode !== "live") return;
    this.program.send({ type: state.paused ? "resume" : "pause" });
  }

  private toggleRecording(): void {
    this.program.send({ type: "record", on: !(this.program.state?.recording ?? false) });
  }

  /** Space, where no control has it for itself. */
  private press(event: KeyboardEvent): void {
    if (event.code !== "Space" || takesKeys(event.target) || event.target instanceof HTMLButtonElement) return;
    if (event.target instanceof HTMLInputElement || document.querySelector("dialog[open]")) return;
    if (event.target instanceof HTMLElement && event.target.tagName === "SUMMARY") return;
    event.preventDefault();
    if (!event.repeat) this.togglePause();
  }
}
