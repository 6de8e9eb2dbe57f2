// SPDX-License-Identifier: Apache-2.0
import { box } from "../dom";
import type { Program } from "../program";
import { colours } from "../scene/colours";
import { SampleHistory } from "./sample_history";
import { TickHistogram } from "./tick_histogram";
import { WrenchPlot } from "./wrench_plot";

/** Force and torque over time, and the histogram of tick times. */
export class Plots {
  private readonly history = new SampleHistory();
  private readonly force = new WrenchPlot(box("force-plot"), "Force", "N", colours.force, 1, 7, 0.5);
  private readonly torque = new WrenchPlot(box("torque-plot"), "Torque", "N m", colours.torque, 4, 8, 0.01);
  private readonly ticks = new TickHistogram(box("tick-plot"));
  private isNews = false;

  constructor(program: Program) {
    program.scenes.listen(() => this.history.clear());
    program.states.listen((state) => {
      this.history.add(state.samples, state.t);
      this.isNews = true;
      if (state.histogram) this.ticks.show(state.histogram, state.numbers);
    });
  }

  draw(): void {
    if (!this.isNews || !Number.isFinite(this.history.newest)) return;
    this.force.draw(this.history);
    this.torque.draw(this.history);
    this.isNews = false;
  }
}
