// SPDX-License-Identifier: Apache-2.0
import { Connection, type ConnectionState } from "./connection";
import { Emitter } from "./emitter";
import type { FromPage, FromProgram, Notice, Scene, Settings, State } from "./protocol";

/** What the page knows of the program, who wants to hear of it, and the way to tell it something. */
export class Program {
  readonly scenes = new Emitter<Scene>();
  readonly settingsChanges = new Emitter<Settings>();
  readonly states = new Emitter<State>();
  readonly notices = new Emitter<Notice>();
  readonly connectionStates = new Emitter<ConnectionState>();

  scene: Scene | null = null;
  settings: Settings | null = null;
  state: State | null = null;
  /** Number of this page among those that look. */
  viewer: number | null = null;
  connection: ConnectionState = { kind: "connecting" };

  private readonly link: Connection;

  constructor(url: string) {
    this.link = new Connection(url);
    this.link.messages.listen((message) => this.take(message));
    this.link.states.listen((state) => {
      this.connection = state;
      this.connectionStates.emit(state);
    });
  }

  connect(): void {
    this.connectionStates.emit(this.connection);
    this.link.open();
  }

  send(message: FromPage): void {
    this.link.send(message);
  }

  /** Shows a sentence as if the program had said it. */
  notice(level: Notice["level"], text: string): void {
    this.notices.emit({ type: "notice", level, text });
  }

  get isLive(): boolean {
    return this.connection.kind === "live" && this.scene?.mode === "live";
  }

  /** Name of the interface that a person holds in the page's place; null where the page is the hand, or in a replay. */
  get device(): string | null {
    const { scene } = this;
    return scene?.mode !== "live" || scene.interface === "page" ? null : scene.interface;
  }

  /** Whether mouse, keys and the like on this page may move the tool. */
  get pageIsHand(): boolean {
    return this.isLive && this.device === null;
  }

  /** ms since the state shown was put together, by the clocks of program and page. */
  get ageOfState(): number | null {
    return this.state === null ? null : Date.now() - this.state.made;
  }

  private take(message: FromProgram): void {
    switch (message.type) {
      case "welcome":
        this.viewer = message.viewer;
        break;
      case "scene":
        this.scene = message;
        this.state = null;
        this.scenes.emit(message);
        break;
      case "settings":
        this.settings = message;
        this.settingsChanges.emit(message);
        break;
      case "state":
        if (this.scene === null) break;
        this.state = message;
        this.states.emit(message);
        break;
      case "notice":
        this.notices.emit(message);
        break;
      case "end":
        break;
    }
  }
}
