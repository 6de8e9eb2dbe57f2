// SPDX-License-Identifier: Apache-2.0
import { spawn } from "node:child_process";
import { once } from "node:events";

const program = process.env.TEGOTAE_PROGRAM;
if (program === undefined) throw new Error("TEGOTAE_PROGRAM must name the built program.");

const startsWithin = 20000; // ms

/** A running `tegotae serve` or `tegotae replay`, and the address that it has printed. */
export class Program {
  output = "";
  address = "";
  #child;

  static async start(...args) {
    const started = new Program();
    await started.#spawn(args);
    return started;
  }

  async #spawn(args) {
    this.#child = spawn(program, args, { stdio: ["ignore", "pipe", "pipe"] });
    const found = new Promise((resolve, reject) => {
      const late = setTimeout(() => reject(new Error(`no address is printed: ${this.output}`)), startsWithin);
      const read = (chunk) => {
        this.output += chunk;
        const address = /http:\/\/[^\s"']+/.exec(this.output);
        if (address) {
          clearTimeout(late);
          resolve(address[0].replace(/[.,]$/, ""));
        }
      };
      this.#child.stdout.on("data", read);
      this.#child.stderr.on("data", read);
      this.#child.once("exit", (code) => {
        clearTimeout(late);
        reject(new Error(`the program ended with ${code}: ${this.output}`));
      });
    });
    this.address = await found;
  }

  get port() {
    return new URL(this.address).port;
  }

  /** Asks it to end, as Ctrl-C does, and gives its exit code. */
  async stop() {
    if (this.#child.exitCode !== null || this.#child.signalCode !== null) return this.#child.exitCode;
    const ended = once(this.#child, "exit");
    this.#child.kill("SIGINT");
    const [code] = await ended;
    return code;
  }
}
