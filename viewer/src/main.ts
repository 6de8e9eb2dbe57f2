// SPDX-License-Identifier: Apache-2.0
import { socketAddress } from "./connection";
import { button, byId, takesKeys } from "./dom";
import { FrameRate } from "./frame_rate";
import { DrivenHand } from "./hand/driven_hand";
import { GamepadHand } from "./hand/gamepad_hand";
import { Hand } from "./hand/hand";
import { KeyHand } from "./hand/key_hand";
import { MouseHand } from "./hand/mouse_hand";
import { SpaceMouse } from "./hand/space_mouse";
import { ConnectionBadge } from "./panel/connection_badge";
import { HandNote } from "./panel/hand_note";
import { Help } from "./panel/help";
import { Legend } from "./panel/legend";
import { Notices } from "./panel/notices";
import { NumbersTable } from "./panel/numbers_table";
import { PlayPanel } from "./panel/play_panel";
import { Plots } from "./panel/plots";
import { SettingsPanel } from "./panel/settings_panel";
import { TimeBar } from "./panel/time_bar";
import { Transport } from "./panel/transport";
import { Program } from "./program";
import { SceneView } from "./scene/scene_view";
import { openTestPort } from "./test_port";

const agesKept = 600;

/** The page: it takes what the program sends, and draws it with the frames of the browser. */
class Page {
  private readonly program = new Program(socketAddress(window.location));
  private readonly view = new SceneView(byId("view", HTMLCanvasElement), this.program);
  private readonly hand = new Hand(this.program);
  private readonly spaceMouse = new SpaceMouse();
  private readonly driven = new DrivenHand(this.hand, this.view, this.program, [
    new KeyHand(this.program),
    new GamepadHand(),
    this.spaceMouse,
  ]);
  private readonly plots = new Plots(this.program);
  private readonly numbers = new NumbersTable(byId("numbers", HTMLElement));
  private readonly legend = new Legend(this.view, this.program);
  private readonly frameRate = new FrameRate();
  private readonly ages: number[] = [];
  // On software rendering the plots take their time from the view, so they are drawn more seldom.
  private readonly plotEvery = this.view.stage.inSoftware ? 120 : 40; // ms
  private readonly numbersEvery = 150; // ms
  private lastPlot = 0;
  private lastNumbers = 0;
  private drawnState = 0;

  constructor() {
    new MouseHand(this.hand, this.view, this.program);
    const parts = [ConnectionBadge, HandNote, Help, Notices, PlayPanel, SettingsPanel, TimeBar, Transport];
    for (const Part of parts) new Part(this.program);
    this.connectControls();
    openTestPort(this.program, this.view, this.ages, () => this.frameRate.perSecond(performance.now()));
    this.program.connect();
    window.requestAnimationFrame((now) => this.frame(now));
  }

  private connectControls(): void {
    button("frame-tool").addEventListener("click", () => this.view.frameTool());
    button("frame-all").addEventListener("click", () => this.view.frameAll());
    window.addEventListener("keydown", (event) => {
      if (takesKeys(event.target) || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.code === "KeyF") this.view.frameTool();
      if (event.code === "KeyG") this.view.frameAll();
    });
    const connect = button("space-mouse");
    connect.hidden = !this.spaceMouse.isPossible;
    connect.addEventListener("click", () => {
      this.spaceMouse.connect().then(
        (found) => this.program.notice("info", found ? "The SpaceMouse moves the tool." : "No SpaceMouse was chosen."),
        (error: unknown) => this.program.notice("error", `The SpaceMouse cannot be opened: ${String(error)}`),
      );
    });
  }

  private frame(now: number): void {
    window.requestAnimationFrame((next) => this.frame(next));
    this.driven.frame(now);
    this.hand.sendDue(now);
    if (this.view.draw()) {
      this.frameRate.count(now);
      this.noteAge();
    }
    if (now - this.lastPlot > this.plotEvery) {
      this.lastPlot = now;
      this.plots.draw();
    }
    if (now - this.lastNumbers > this.numbersEvery) {
      this.lastNumbers = now;
      this.showNumbers(now);
    }
  }

  private noteAge(): void {
    const { state, ageOfState } = this.program;
    if (state === null || ageOfState === null || state.n === this.drawnState) return;
    this.drawnState = state.n;
    this.ages.push(ageOfState);
    if (this.ages.length > agesKept) this.ages.shift();
  }

  private showNumbers(now: number): void {
    const { state } = this.program;
    if (state === null) return;
    const age = this.ages[this.ages.length - 1] ?? null;
    this.numbers.show(state, { age, framesPerSecond: this.frameRate.perSecond(now) });
    this.legend.showScales();
  }
}

new Page();
