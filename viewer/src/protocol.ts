// SPDX-License-Identifier: Apache-2.0
// Messages between the program and its pages, version 1, as docs/live-view.md describes them. SI units.

/** x, y, z. */
export type Vector = [number, number, number];
/** x, y, z (m), then the unit quaternion w, x, y, z. */
export type Pose = [number, number, number, number, number, number, number];
/** Force (N), then torque (N m). */
export type Wrench = [number, number, number, number, number, number];

export type ShapeKind = "box" | "sphere" | "capsule" | "cylinder" | "ellipsoid" | "hull" | "plane";

export interface Shape {
  kind: ShapeKind;
  size: Vector;
  pose: Pose;
  colour: [number, number, number, number];
  vertices?: number[];
  triangles?: number[];
}

export interface Tool {
  name: string;
  centre_of_mass: Vector;
  gyration_length: number;
  shapes: Shape[];
}

export interface Body {
  name: string;
  moving_index: number;
  pose: Pose;
  shapes: Shape[];
}

export interface Named {
  name: string;
  summary: string;
}

export interface Welcome {
  type: "welcome";
  viewer: number;
}

export interface Scene {
  type: "scene";
  protocol: number;
  mode: "live" | "replay";
  name: string;
  program: string;
  z_up: Vector;
  tool: Tool;
  bodies: Body[];
  scenes: string[];
  experiments: Named[];
  motions: Named[];
  methods: Named[];
  interface: string;
  duration?: number;
}

export interface Setting {
  name: string;
  label: string;
  unit: string;
  value: number | null;
  least: number;
  most: number;
  zero_too: boolean;
  is_switch: boolean;
  available: boolean;
}

export interface Settings {
  type: "settings";
  method: string;
  values: Setting[];
}

export interface Histogram {
  edges_us: number[];
  counts: number[];
}

export type Known = number | null;

/** A number that is not known is null; every member may be absent. */
export interface Numbers {
  tick_median_us?: Known;
  tick_p99_us?: Known;
  tick_p999_us?: Known;
  tick_max_us?: Known;
  ticks?: Known;
  haptic_rate?: Known;
  physics_rate?: Known;
  physics_step_ms?: Known;
  staleness_ms?: Known;
  missed?: Known;
  near_objects?: Known;
  contacts?: Known;
  active?: Known;
  constraints?: Known;
  dropped?: Known;
  iterations?: Known;
  depth?: Known;
  energy?: Known;
  status?: string;
  safety?: string[];
}

/** Time (s), then the displayed wrench. */
export type Sample = [number, number, number, number, number, number, number];

export interface State {
  type: "state";
  n: number;
  t: number;
  made: number;
  tool: Pose;
  proxy: Pose;
  target: Pose | null;
  wrench: Wrench;
  bodies: Pose[];
  planes: [number, number, number, number, number, number, number][];
  points: [number, number, number, number, number][];
  anchors: [number, number, number, number, number, number, number][];
  samples: Sample[];
  numbers: Numbers;
  histogram?: Histogram;
  paused: boolean;
  recording: boolean;
  recording_file?: string;
  recording_ticks?: number;
  motion: string | null;
  hand: number | null;
  viewers: number;
}

export interface Notice {
  type: "notice";
  level: "info" | "warning" | "error";
  text: string;
}

export interface End {
  type: "end";
  text: string;
}

export type FromProgram = Welcome | Scene | Settings | State | Notice | End;

export type FromPage =
  | { type: "hand"; pose: Pose }
  | { type: "release" | "pause" | "resume" | "step" | "reset" | "stop" }
  | { type: "set"; name: string; value: number | null }
  | { type: "method" | "motion" | "scene" | "experiment"; name: string }
  | { type: "record"; on: boolean }
  | { type: "seek"; t: number }
  | { type: "play"; speed: number };

const kinds: readonly string[] = ["welcome", "scene", "settings", "state", "notice", "end"];

/** The message in a text frame, or null where it is of a type that this page does not know. */
export function parse(text: string): FromProgram | null {
  const message = JSON.parse(text) as { type?: unknown };
  if (typeof message.type !== "string" || !kinds.includes(message.type)) return null;
  return message as FromProgram;
}
