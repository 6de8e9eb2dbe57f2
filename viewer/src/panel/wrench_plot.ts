// SPDX-License-Identifier: Apache-2.0
import uPlot from "uplot";
import { make } from "../dom";
import { colours } from "../scene/colours";
import { axisLook, sizeInside } from "./plot_look";
import type { SampleHistory } from "./sample_history";

const span = 5; // s

/** Force or torque over the last seconds: magnitude and components, each of which can be switched off. */
export class WrenchPlot {
  private readonly plot: uPlot;
  private readonly frame: HTMLElement;

  /** `first` of the three columns in the history, `size` that of their magnitude; `least` height of the plot. */
  constructor(
    root: HTMLElement,
    private readonly title: string,
    unit: string,
    colour: string,
    private readonly first: number,
    private readonly size: number,
    private readonly least: number,
  ) {
    const curves: [string, string][] = [
      ["x", colours.x],
      ["y", colours.y],
      ["z", colours.z],
      ["size", colour],
    ];
    this.frame = make("div", { className: "plot" });
    const switches = curves.map(([name, stroke], i) => this.curveSwitch(name, stroke, i + 1));
    root.append(make("header", {}, make("h2", { textContent: `${title}, ${unit}` }), ...switches), this.frame);
    this.plot = new uPlot(
      {
        ...sizeInside(this.frame),
        legend: { show: false },
        cursor: { drag: { x: false, y: false }, y: false },
        padding: [6, 10, 0, 0],
        scales: { x: { time: false }, y: { range: (_plot, low, high) => this.heights(low, high) } },
        axes: [
          { ...axisLook, size: 24, values: (_plot, ticks) => ticks.map(inSeconds) },
          { ...axisLook, size: 46, values: (_plot, ticks) => ticks.map((tick) => String(Number(tick.toFixed(6)))) },
        ],
        series: [
          {},
          ...curves.map(([label, stroke]) => ({
            label,
            stroke,
            width: label === "size" ? 2 : 1.25,
            points: { show: false },
          })),
        ],
      },
      [[], [], [], [], []],
      this.frame,
    );
    new ResizeObserver(() => this.plot.setSize(sizeInside(this.frame))).observe(this.frame);
  }

  draw(history: SampleHistory): void {
    const columns = history.last(span, 0, this.first, this.first + 1, this.first + 2, this.size);
    this.plot.batch(() => {
      this.plot.setData(columns as unknown as uPlot.AlignedData, false);
      this.plot.setScale("x", { min: history.newest - span, max: history.newest });
    });
  }

  private heights(low: number | null, high: number | null): [number, number] {
    const [below, above] = [Math.min(low ?? 0, 0), Math.max(high ?? 0, 0)];
    const room = 0.08 * (above - below);
    return [Math.min(below - (below < 0 ? room : 0), -0.1 * this.least), Math.max(above + room, this.least)];
  }

  private curveSwitch(name: string, colour: string, series: number): HTMLElement {
    const what = name === "size" ? "magnitude" : `${name} component`;
    const box = make("input", { type: "checkbox", checked: true });
    box.setAttribute("aria-label", `${this.title}, ${what}`);
    box.dataset.testid = `curve-${this.title.toLowerCase()}-${name}`;
    box.addEventListener("change", () => this.plot.setSeries(series, { show: box.checked }));
    const label = make("label", { className: "curve", title: what }, box, name === "size" ? "size" : name);
    label.style.setProperty("--swatch", colour);
    return label;
  }
}

/** The session begins at 0; what is left of it has no time. */
function inSeconds(t: number): string {
  return t < 0 ? "" : `${Number(t.toFixed(3))} s`;
}
