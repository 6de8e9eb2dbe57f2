// SPDX-License-Identifier: Apache-2.0
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { Program } from "./program.mjs";

/** Where screenshots and figures are kept. */
export const output = process.env.TEGOTAE_OUTPUT ?? "viewer-output";
mkdirSync(output, { recursive: true });

const patience = 15000; // ms that anything on the page may take

/** Debian's Chromium; WebGL draws on the processor, as on a machine without a graphics card. */
export function launch() {
  return chromium.launch({
    executablePath: "/usr/bin/chromium",
    args: ["--no-sandbox", "--use-angle=swiftshader-webgl", "--enable-unsafe-swiftshader", "--ignore-gpu-blocklist"],
  });
}

/** The page of a program in a browser: what tests do with it. */
export class ViewerPage {
  errors = [];

  static async open(browser, address, size = { width: 1280, height: 720 }) {
    const opened = new ViewerPage();
    opened.page = await browser.newPage({ viewport: size });
    opened.page.setDefaultTimeout(patience);
    opened.page.on("pageerror", (error) => opened.errors.push(error.message));
    opened.page.on("console", (message) => {
      // That a server has gone is what some tests are about.
      const isLoss = /WebSocket|ERR_CONNECTION/.test(message.text());
      if (message.type() === "error" && !isLoss) opened.errors.push(message.text());
    });
    await opened.page.goto(address);
    await opened.until(() => window.tegotae?.state?.n > 0 && window.tegotae.settings !== null);
    return opened;
  }

  /** Waits until a condition holds, which is evaluated in the page with `argument`. */
  async until(condition, argument) {
    await this.page.waitForFunction(condition, argument, { polling: 30 });
  }

  control(name) {
    return this.page.getByTestId(name);
  }

  state() {
    return this.page.evaluate(() => window.tegotae.state);
  }

  settings() {
    return this.page.evaluate(() => window.tegotae.settings);
  }

  async text(name) {
    return (await this.control(name).textContent()) ?? "";
  }

  /** Waits until a text of the page matches. */
  async untilText(name, pattern) {
    await this.until(
      ([id, source, flags]) => {
        const text = document.querySelector(`[data-testid="${id}"]`)?.textContent ?? "";
        return new RegExp(source, flags).test(text);
      },
      [name, pattern.source, pattern.flags],
    );
  }

  /** Presses the left button on the tool and moves it by pixels; the button stays down. */
  async dragTool(x, y) {
    const tool = await this.page.evaluate(() => window.tegotae.toolScreenPosition());
    await this.page.mouse.move(tool.x, tool.y);
    await this.page.mouse.down();
    const steps = 20;
    for (let i = 1; i <= steps; ++i) await this.page.mouse.move(tool.x + (x * i) / steps, tool.y + (y * i) / steps);
  }

  /** Drags the tool down until something pushes it up with `force` (N). */
  async pressDown(force) {
    const tool = await this.page.evaluate(() => window.tegotae.toolScreenPosition());
    await this.page.mouse.move(tool.x, tool.y);
    await this.page.mouse.down();
    for (let y = 2; y < 400 && (await this.state()).wrench[2] < force; y += 2) {
      await this.page.mouse.move(tool.x, tool.y + y);
      await this.page.waitForTimeout(20);
    }
    assert.ok((await this.state()).wrench[2] >= force, "nothing is there to press on");
  }

  async letGo() {
    await this.page.mouse.up();
    await this.until(() => window.tegotae.state.hand === null);
  }

  /** Types a value into a setting's field. */
  async type(setting, value) {
    const field = this.control(`setting-${setting}`);
    await field.fill(String(value));
    await field.press("Enter");
  }

  async valueOf(setting) {
    return (await this.settings()).values.find(({ name }) => name === setting)?.value;
  }

  async untilValue(setting, value) {
    await this.until(
      ([name, wanted]) =>
        Math.abs(window.tegotae.settings.values.find((each) => each.name === name).value - wanted) <= 1e-6 * wanted,
      [setting, value],
    );
  }

  async picture(name) {
    return this.page.screenshot({ path: join(output, `${name}.png`) });
  }

  /** How many colours a part of the page has. */
  async colourCount(clip) {
    const picture = await this.page.screenshot({ clip });
    return this.page.evaluate(async (data) => {
      const bytes = Uint8Array.from(atob(data), (character) => character.charCodeAt(0));
      const bitmap = await createImageBitmap(new Blob([bytes], { type: "image/png" }));
      const pen = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
      pen.drawImage(bitmap, 0, 0);
      const pixels = new Uint32Array(pen.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer);
      return new Set(pixels).size;
    }, picture.toString("base64"));
  }

  /** The heights (pixels above the lowest) at which the curve of this colour is found in a plot. */
  curveHeights(plot, colour) {
    return this.page.evaluate(
      ([id, wanted]) => {
        const canvas = document.querySelector(`[data-testid="${id}"] canvas`);
        const { data, width, height } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
        const rows = [];
        for (let y = 0; y < height; ++y) {
          for (let x = 0; x < width; ++x) {
            const at = 4 * (y * width + x);
            if (wanted.every((value, i) => Math.abs(data[at + i] - value) < 12) && data[at + 3] > 200) {
              rows.push(y);
              break;
            }
          }
        }
        const lowest = Math.max(...rows);
        return rows.map((y) => lowest - y);
      },
      [plot, colour],
    );
  }

  async close() {
    await this.page.close();
    assert.deepEqual(this.errors, [], "the page complains");
  }
}

/** Runs `use` with a program, started with these arguments, and a page on it, and stops both. */
export async function withPage(browser, args, use) {
  const program = await Program.start(...args, "--port", "0");
  try {
    const page = await ViewerPage.open(browser, program.address);
    await use(page, program);
    await page.close();
  } finally {
    await program.stop();
  }
}
