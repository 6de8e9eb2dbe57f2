// SPDX-License-Identifier: Apache-2.0
import { box } from "../dom";
import type { Program } from "../program";

const byPage = "Drag the tool · Shift turns it · drag elsewhere to look around · H for help";
const keys = "Keys W A S D Q E move the tool, with Shift they turn it; H shows help.";

/** Who the hand is: the page, or a device; of the ways to move the tool only those that act are offered. */
export class HandNote {
  constructor(program: Program) {
    program.scenes.listen(() => {
      const { device } = program;
      document.body.classList.toggle("device", device !== null);
      box("hint").textContent =
        device === null ? byPage : `${device} is the hand: move it, and the tool moves · drag to look around · H for help`;
      box("help-device").hidden = device === null;
      box("help-device").textContent = `${device ?? ""} is the hand: it alone moves the tool.`;
      box("view").ariaLabel = `3-D view of the scene. ${device === null ? keys : `${device} is the hand; H shows help.`}`;
    });
  }
}
