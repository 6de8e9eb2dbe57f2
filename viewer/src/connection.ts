// SPDX-License-Identifier: Apache-2.0
import { Emitter } from "./emitter";
import { parse, type FromPage, type FromProgram } from "./protocol";

/** How the connection is; one that has stopped may have been refused to this page alone, while the program goes on. */
export type ConnectionState =
  | { kind: "connecting" }
  | { kind: "live" }
  | { kind: "stopped"; text: string; refused: boolean };

const firstPause = 500; // ms before the first new attempt; each next one waits twice as long
const longestPause = 8000; // ms
const refusals = [1003, 1007, 1008, 1009]; // close codes that tell of this page, not of the program

/** The WebSocket to the program: it comes back by itself after a loss. */
export class Connection {
  readonly messages = new Emitter<FromProgram>();
  readonly states = new Emitter<ConnectionState>();
  private socket: WebSocket | null = null;
  private pause = firstPause;
  private ended = "";

  constructor(private readonly url: string) {}

  open(): void {
    this.socket = new WebSocket(this.url);
    this.socket.onmessage = (event) => this.receive(String(event.data));
    this.socket.onclose = (event) => this.lost(event);
  }

  /** Sends, or does nothing while there is no connection. */
  send(message: FromPage): void {
    if (this.socket?.readyState === WebSocket.OPEN) this.socket.send(JSON.stringify(message));
  }

  private receive(text: string): void {
    const message = parse(text);
    if (message === null) return;
    if (message.type === "welcome") {
      this.pause = firstPause;
      this.ended = "";
      this.states.emit({ kind: "live" });
    }
    if (message.type === "end") this.ended = message.text;
    this.messages.emit(message);
  }

  private lost({ code, reason }: CloseEvent): void {
    this.socket = null;
    this.states.emit({ kind: "stopped", text: this.ended || reason, refused: refusals.includes(code) });
    window.setTimeout(() => this.open(), this.pause);
    this.pause = Math.min(2 * this.pause, longestPause);
  }
}

/** Address of the program's socket for a page that was loaded from `page`: same host, and the token of its query. */
export function socketAddress(page: Location): string {
  const address = new URL("/live", page.href);
  address.protocol = page.protocol === "https:" ? "wss:" : "ws:";
  const token = new URLSearchParams(page.search).get("token");
  if (token !== null) address.searchParams.set("token", token);
  return address.href;
}
