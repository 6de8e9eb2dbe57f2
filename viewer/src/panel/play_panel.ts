// SPDX-License-Identifier: Apache-2.0
import { button } from "../dom";
import type { Program } from "../program";
import { Choice } from "./choice";

/** Scenes, scripted motions and experiments by name. */
export class PlayPanel {
  constructor(program: Program) {
    const scene = new Choice("scene-choice", (name) => program.send({ type: "scene", name }));
    const motion = new Choice("motion-choice", (name) => program.send({ type: "motion", name }));
    const experiment = new Choice("experiment-choice", (name) => program.send({ type: "experiment", name }));
    program.scenes.listen(({ scenes, motions, experiments, name }) => {
      scene.offer(scenes.map((each) => ({ name: each, summary: "" })), name);
      motion.offer(motions);
      experiment.offer(experiments, name);
    });
    const stop = button("stop");
    stop.addEventListener("click", () => program.send({ type: "stop" }));
    program.states.listen(({ motion: playing }) => {
      stop.disabled = playing === null;
      const text = playing === null ? "Stop" : `Stop “${playing}”`;
      if (stop.textContent !== text) stop.textContent = text;
    });
  }
}
