// SPDX-License-Identifier: Apache-2.0
import uPlot from "uplot";
import { make } from "../dom";
import type { Histogram, Known, Numbers } from "../protocol";
import { axisLook, font, ink, sizeInside } from "./plot_look";

const floorCount = 0.5; // on the axis of counts, which is logarithmic too and has no place for 0

const decades: uPlot.Axis = {
  ...axisLook,
  filter: onlyDecades,
  grid: { ...axisLook.grid, filter: onlyDecades },
  ticks: { ...axisLook.ticks, filter: onlyDecades },
};

/** How long the ticks took, with both axes logarithmic so that the few slow ones show. */
export class TickHistogram {
  private readonly plot: uPlot;
  private numbers: Numbers = {};

  constructor(root: HTMLElement) {
    const frame = make("div", { className: "plot" });
    root.append(make("header", {}, make("h2", { textContent: "Tick time, ticks a bin" })), frame);
    const steps = uPlot.paths.stepped?.({ align: 1 });
    this.plot = new uPlot(
      {
        ...sizeInside(frame),
        legend: { show: false },
        cursor: { show: false },
        padding: [6, 12, 0, 0],
        scales: { x: { time: false, distr: 3 }, y: { distr: 3, range: (_plot, _low, high) => [floorCount, 2 * high] } },
        axes: [
          { ...decades, size: 24, values: (_plot, ticks) => ticks.map(inTime) },
          { ...decades, size: 46, values: (_plot, ticks) => ticks.map(inThousands) },
        ],
        series: [
          {},
          { stroke: "#59c2b0", fill: "#59c2b066", width: 1, points: { show: false }, ...(steps && { paths: steps }) },
        ],
        hooks: { draw: [(plot) => this.drawMarks(plot)] },
      },
      [[], []],
      frame,
    );
    new ResizeObserver(() => this.plot.setSize(sizeInside(frame))).observe(frame);
  }

  show({ edges_us, counts }: Histogram, numbers: Numbers): void {
    this.numbers = numbers;
    const first = counts.findIndex((count) => count > 0);
    let last = counts.length - 1;
    while (last > 0 && counts[last] === 0) --last;
    if (first < 0) return;
    // One edge more than bins: the last one ends the last step.
    const edges = edges_us.slice(first, last + 2).map((edge) => Math.max(edge, 1e-2));
    const heights = counts.slice(first, last + 1).map((count) => Math.max(count, floorCount));
    while (heights.length < edges.length) heights.push(floorCount);
    this.plot.setData([edges, heights]);
  }

  private drawMarks(plot: uPlot): void {
    const { tick_median_us, tick_p99_us, tick_p999_us } = this.numbers;
    const marks: [Known | undefined, string][] = [
      [tick_median_us, "50 %"],
      [tick_p99_us, "99 %"],
      [tick_p999_us, "99.9 %"],
    ];
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.font = font;
    ctx.fillStyle = ctx.strokeStyle = ink;
    ctx.setLineDash([3, 3]);
    marks.forEach(([us, label], i) => {
      const x = us == null ? NaN : plot.valToPos(us, "x", true);
      if (!(x >= bbox.left && x <= bbox.left + bbox.width)) return;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.save();
      ctx.setLineDash([]);
      ctx.lineWidth = 4;
      ctx.strokeStyle = "#12161c";
      ctx.strokeText(label, x + 4, bbox.top + 10 + 13 * i);
      ctx.restore();
      ctx.fillText(label, x + 4, bbox.top + 10 + 13 * i);
    });
    ctx.restore();
  }
}

function onlyDecades(_plot: uPlot, ticks: number[]): (number | null)[] {
  return ticks.map((value) => (Math.abs(Math.log10(value) - Math.round(Math.log10(value))) < 1e-6 ? value : null));
}

function inTime(us: number | null): string {
  if (us === null) return "";
  return us >= 999999 ? `${us / 1e6} s` : us >= 999 ? `${us / 1000} ms` : `${us} µs`;
}

function inThousands(count: number | null): string {
  if (count === null) return "";
  return count >= 999999 ? `${count / 1e6} M` : count >= 999 ? `${count / 1000} k` : String(count);
}
