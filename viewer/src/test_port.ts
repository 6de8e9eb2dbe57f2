// SPDX-License-Identifier: Apache-2.0
import type { Program } from "./program";
import type { FromPage, Scene, Settings, State } from "./protocol";
import type { SceneView } from "./scene/scene_view";

/** What tests of the page read and do that no control shows, as `window.tegotae`. The page itself does not use it. */
export interface TestPort {
  readonly state: State | null;
  readonly scene: Scene | null;
  readonly settings: Settings | null;
  /** Frames of the 3-D view drawn within the last second. */
  readonly framesPerSecond: number;
  /** ms since the newest state was put together. */
  readonly ageOfState: number | null;
  /** ms that the last states were old when they had been drawn, at most 600 of them. */
  readonly agesWhenDrawn: readonly number[];
  readonly drawsInSoftware: boolean;
  send(message: FromPage): void;
  /** Pixels of the page at which the tool's centre of mass is seen. */
  toolScreenPosition(): { x: number; y: number };
}

declare global {
  interface Window {
    tegotae?: TestPort;
  }
}

export function openTestPort(
  program: Program,
  view: SceneView,
  agesWhenDrawn: readonly number[],
  framesPerSecond: () => number,
): void {
  window.tegotae = {
    get state() {
      return program.state;
    },
    get scene() {
      return program.scene;
    },
    get settings() {
      return program.settings;
    },
    get framesPerSecond() {
      return framesPerSecond();
    },
    get ageOfState() {
      return program.ageOfState;
    },
    agesWhenDrawn,
    drawsInSoftware: view.stage.inSoftware,
    send: (message) => program.send(message),
    toolScreenPosition: () => view.stage.onScreen(view.toolCentre),
  };
}
