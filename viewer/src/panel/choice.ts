// SPDX-License-Identifier: Apache-2.0
import { box, button, make, select, setText } from "../dom";
import type { Named } from "../protocol";

/** A list of names with a button that does something with the chosen one, and its summary below. */
export class Choice {
  private readonly list: HTMLSelectElement;
  private summaries = new Map<string, string>();

  /** `id` of the list; its button is "ID-go", its summary "ID-summary", and all of it "ID-row". */
  constructor(private readonly id: string, act: (name: string) => void) {
    this.list = select(id);
    this.list.addEventListener("change", () => this.summarise());
    button(`${id}-go`).addEventListener("click", () => act(this.list.value));
  }

  offer(choices: readonly Named[], chosen?: string): void {
    this.summaries = new Map(choices.map(({ name, summary }) => [name, summary]));
    this.list.replaceChildren(
      ...choices.map(({ name, summary }) => make("option", { value: name, textContent: name, title: summary })),
    );
    if (chosen !== undefined && this.summaries.has(chosen)) this.list.value = chosen;
    box(`${this.id}-row`).hidden = choices.length === 0;
    this.summarise();
  }

  private summarise(): void {
    const summary = this.summaries.get(this.list.value) ?? "";
    this.list.title = summary;
    setText(box(`${this.id}-summary`), summary);
  }
}
