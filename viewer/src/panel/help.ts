// SPDX-License-Identifier: Apache-2.0
import { box, button, byId, takesKeys } from "../dom";
import type { Program } from "../program";

/** The overlay that tells newcomers how to move tool and camera. */
export class Help {
  constructor(program: Program) {
    const dialog = byId("help", HTMLDialogElement);
    const toggle = () => (dialog.open ? dialog.close() : dialog.showModal());
    button("help-button").addEventListener("click", toggle);
    button("help-close").addEventListener("click", () => dialog.close());
    dialog.addEventListener("click", (event) => {
      if (event.target === dialog) dialog.close();
    });
    window.addEventListener("keydown", (event) => {
      if (takesKeys(event.target) || event.ctrlKey || event.metaKey || event.altKey) return;
      if (event.key === "?" || event.code === "KeyH") toggle();
    });
    const hint = box("hint");
    hint.addEventListener("click", toggle);
    // Who has held the tool once knows what it says.
    program.states.listen(({ hand }) => {
      if (hand !== null && hand === program.viewer) hint.hidden = true;
    });
  }
}
