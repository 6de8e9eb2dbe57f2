// SPDX-License-Identifier: Apache-2.0
import { box, make } from "../dom";
import type { Program } from "../program";
import type { Notice } from "../protocol";

const shownFor = { info: 5000, warning: 8000, error: 15000 }; // ms
const kept = 100; // in the log
const shownAtOnce = 4;

/** What the program says: for a while over the view, and in a log. */
export class Notices {
  private readonly toasts = box("toasts");
  private readonly log = box("log");
  private last = "";
  private lastTime = -Infinity;

  constructor(program: Program) {
    program.notices.listen((notice) => this.show(notice));
  }

  private show({ level, text }: Notice): void {
    const now = performance.now();
    const isRepeated = text === this.last && now - this.lastTime < 1000;
    this.last = text;
    this.lastTime = now;
    if (isRepeated) return;
    const toast = make("div", { className: `toast ${level}`, textContent: text });
    toast.dataset.testid = "toast";
    this.toasts.append(toast);
    while (this.toasts.children.length > shownAtOnce) this.toasts.firstElementChild?.remove();
    window.setTimeout(() => toast.remove(), shownFor[level]);
    const time = new Date().toLocaleTimeString("en-GB");
    this.log.prepend(make("li", { className: level }, make("time", { textContent: time }), ` ${text}`));
    while (this.log.children.length > kept) this.log.lastElementChild?.remove();
  }
}
