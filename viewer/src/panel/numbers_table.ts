// SPDX-License-Identifier: Apache-2.0
import { make, setText } from "../dom";
import type { Known, Numbers, State } from "../protocol";
import { grouped, trimmed, withUnit } from "../quantities";

/** What of the page itself stands among the numbers. */
export interface PageNumbers {
  age: number | null; // ms
  framesPerSecond: number;
}

interface Row {
  name: string;
  label: string;
  summary: string;
  text: (state: State, page: PageNumbers) => string;
  isBad?: (numbers: Numbers) => boolean;
}

const size = (x: number, y: number, z: number) => Math.hypot(x, y, z);
const told = (value: Known | undefined, tell: (value: number) => string) => (value == null ? "–" : tell(value));
const micro = (value?: Known) => told(value, (us) => withUnit(us * 1e-6, "s"));
const milli = (value?: Known) => told(value, (ms) => withUnit(ms * 1e-3, "s"));
const unit = (value: Known | undefined, name: string) => told(value, (number) => withUnit(number, name));
const rate = (value?: Known) => told(value, (hertz) => `${trimmed(hertz)} Hz`);
const count = (value?: Known) => told(value, grouped);

const rows: readonly Row[] = [
  { name: "force", label: "Force", summary: "Size of the displayed force",
    text: ({ wrench: [x, y, z] }) => withUnit(size(x, y, z), "N") },
  { name: "torque", label: "Torque", summary: "Size of the displayed torque about the centre of mass",
    text: ({ wrench: [, , , x, y, z] }) => withUnit(size(x, y, z), "N m") },
  { name: "depth", label: "Depth", summary: "Greatest penetration at the pose where the tool is held",
    text: ({ numbers }) => unit(numbers.depth, "m") },
  { name: "energy", label: "Energy injected",
    summary: "What the rendering has given to the hand beyond what it took; a passive one stays below zero",
    text: ({ numbers }) => unit(numbers.energy, "J") },
  { name: "near_objects", label: "Near objects", summary: "Objects that may be touched within a period of the physics",
    text: ({ numbers }) => count(numbers.near_objects) },
  { name: "contacts", label: "Contacts", summary: "Contact points, and those of them that push",
    text: ({ numbers }) => `${count(numbers.contacts)} (${count(numbers.active)} push)` },
  { name: "constraints", label: "Constraints", summary: "Rows of the problem that a tick solves",
    text: ({ numbers }) => count(numbers.constraints) },
  { name: "iterations", label: "Iterations", summary: "Of the solver in the last tick",
    text: ({ numbers }) => count(numbers.iterations) },
  { name: "dropped", label: "Dropped points", summary: "Contact points beyond the capacity",
    text: ({ numbers }) => count(numbers.dropped), isBad: ({ dropped }) => (dropped ?? 0) > 0 },
  { name: "status", label: "Status", summary: "Of the last tick",
    text: ({ numbers }) => numbers.status ?? "–", isBad: ({ status }) => status !== undefined && status !== "ok" },
  { name: "safety", label: "Safety", summary: "What the last stage before the hand has done",
    text: ({ numbers }) => numbers.safety?.map((event) => event.replace("_", " ")).join(", ") || "nothing" },
  { name: "haptic_rate", label: "Haptic rate", summary: "Ticks a second, as measured",
    text: ({ numbers }) => rate(numbers.haptic_rate) },
  { name: "physics_rate", label: "Physics rate", summary: "Steps of the physics a second, as measured",
    text: ({ numbers }) => rate(numbers.physics_rate) },
  { name: "physics_step_ms", label: "Physics step", summary: "Median time that a step of the physics takes",
    text: ({ numbers }) => milli(numbers.physics_step_ms) },
  { name: "tick_median_us", label: "Tick, median", summary: "Half of the ticks take less",
    text: ({ numbers }) => micro(numbers.tick_median_us) },
  { name: "tick_p99_us", label: "Tick, 99 %", summary: "99 of 100 ticks take less",
    text: ({ numbers }) => micro(numbers.tick_p99_us) },
  { name: "tick_p999_us", label: "Tick, 99.9 %", summary: "999 of 1000 ticks take less",
    text: ({ numbers }) => micro(numbers.tick_p999_us) },
  { name: "tick_max_us", label: "Tick, longest", summary: "Since the session began",
    text: ({ numbers }) => micro(numbers.tick_max_us) },
  { name: "missed", label: "Missed ticks", summary: "Haptic ticks that ended after their deadline",
    text: ({ numbers }) => count(numbers.missed) },
  { name: "staleness_ms", label: "Model's age", summary: "Age of what the last tick knew of the world",
    text: ({ numbers }) => milli(numbers.staleness_ms) },
  { name: "age", label: "State's age", summary: "Of the state shown, by the clocks of program and page",
    text: (_state, { age }) => (age === null ? "–" : `${age.toFixed(0)} ms`) },
  { name: "frames", label: "Frames drawn", summary: "By this page, a second",
    text: (_state, { framesPerSecond }) => `${framesPerSecond.toFixed(0)} /s` },
];

/** The session in numbers. */
export class NumbersTable {
  private readonly cells = new Map<string, HTMLElement>();

  constructor(root: HTMLElement) {
    for (const row of rows) {
      const cell = make("dd", { textContent: "–" });
      cell.dataset.testid = `number-${row.name}`;
      this.cells.set(row.name, cell);
      root.append(make("div", { title: row.summary }, make("dt", { textContent: row.label }), cell));
    }
  }

  show(state: State, page: PageNumbers): void {
    for (const row of rows) {
      const cell = this.cells.get(row.name);
      if (!cell) continue;
      const text = row.text(state, page);
      setText(cell, text);
      if (row.name === "safety" && cell.title !== text) cell.title = text;
      cell.classList.toggle("bad", row.isBad?.(state.numbers) ?? false);
    }
  }
}
