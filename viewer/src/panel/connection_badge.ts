// SPDX-License-Identifier: Apache-2.0
import { box, setText } from "../dom";
import type { Program } from "../program";

/** Whether the page is connected, who looks and who moves the tool. */
export class ConnectionBadge {
  constructor(private readonly program: Program) {
    program.connectionStates.listen((state) => {
      const lost = box("lost");
      document.body.dataset.connection = state.kind;
      setText(box("connection"), { connecting: "connecting", live: "live", stopped: "stopped" }[state.kind]);
      lost.hidden = state.kind !== "stopped";
      if (state.kind !== "stopped") return;
      setText(box("lost-title"), state.refused ? "The program closed the connection." : "The program has stopped.");
      setText(box("lost-text"), state.text === "" ? "It cannot be reached." : state.text);
    });
    program.scenes.listen(({ name, mode, program: version }) => {
      setText(box("scene-name"), name);
      setText(box("version"), version);
      document.title = `${name} · tegotae`;
      setText(box("interface"), mode === "replay" ? "a recording" : "");
    });
    program.states.listen(({ viewers, hand, motion }) => {
      setText(box("viewers"), viewers === 1 ? "1 viewer" : `${viewers} viewers`);
      setText(box("hand"), this.handText(hand, motion));
    });
  }

  private handText(hand: number | null, motion: string | null): string {
    if (this.program.scene?.mode === "replay") return "";
    const { device } = this.program;
    if (device !== null) return `${device} is the hand`;
    if (motion !== null) return `“${motion}” plays`;
    if (hand === null) return "nobody holds the tool";
    return hand === this.program.viewer ? "you hold the tool" : `viewer ${hand} holds the tool`;
  }
}
