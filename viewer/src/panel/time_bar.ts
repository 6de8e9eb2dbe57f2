// SPDX-License-Identifier: Apache-2.0
import { box, button, input, select, setText, takesKeys } from "../dom";
import type { Program } from "../program";

const seekEvery = 40; // ms between messages while the bar is dragged

/** Where in a recording the page is; plays, stops and goes to any time of it. */
export class TimeBar {
  private readonly bar = input("time-bar");
  private readonly play = button("play");
  private readonly speed = select("speed");
  private timer = 0;

  constructor(private readonly program: Program) {
    this.bar.addEventListener("input", () => this.seekSoon());
    this.play.addEventListener("click", () => this.toggle());
    this.speed.addEventListener("change", () => {
      if (program.state?.paused === false) this.start();
    });
    window.addEventListener("keydown", (event) => {
      const { target } = event;
      const onControl = target instanceof HTMLButtonElement || (takesKeys(target) && target !== this.bar);
      if (event.code !== "Space" || onControl || document.querySelector("dialog[open]")) return;
      if (program.scene?.mode !== "replay") return;
      event.preventDefault();
      if (!event.repeat) this.toggle();
    });
    program.scenes.listen(({ mode, duration }) => {
      document.body.classList.toggle("replay", mode === "replay");
      this.bar.max = String(duration ?? 0);
    });
    program.states.listen(({ t, paused }) => {
      if (program.scene?.mode !== "replay") return;
      if (this.timer === 0) this.bar.value = String(t);
      const text = `${t.toFixed(2)} s of ${(program.scene.duration ?? 0).toFixed(2)} s`;
      this.bar.setAttribute("aria-valuetext", text);
      setText(box("time-bar-text"), text);
      setText(this.play, paused ? "Play" : "Pause");
    });
  }

  private toggle(): void {
    if (this.program.state?.paused) this.start();
    else this.program.send({ type: "pause" });
  }

  private start(): void {
    this.program.send({ type: "play", speed: Number(this.speed.value) });
  }

  private seekSoon(): void {
    if (this.timer !== 0) return;
    this.timer = window.setTimeout(() => {
      this.timer = 0;
      this.program.send({ type: "seek", t: Number(this.bar.value) });
    }, seekEvery);
  }
}
