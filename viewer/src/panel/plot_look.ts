// SPDX-License-Identifier: Apache-2.0
import type uPlot from "uplot";

export const ink = "#b6bfcc";
export const faint = "#ffffff1f";
export const font = "11px system-ui, sans-serif";

/** What all axes have in common. */
export const axisLook: uPlot.Axis = {
  stroke: ink,
  font,
  grid: { stroke: faint, width: 1 },
  ticks: { stroke: faint, width: 1, size: 4 },
};

/** The width and height that a plot may take inside its frame. */
export function sizeInside(frame: HTMLElement): { width: number; height: number } {
  return { width: Math.max(frame.clientWidth, 80), height: Math.max(frame.clientHeight, 60) };
}
