// SPDX-License-Identifier: Apache-2.0
// A recording made on the page, and its replay.
import assert from "node:assert/strict";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import { launch, withPage } from "./browser.mjs";
import { floor, forceOf } from "./scene_facts.mjs";

const folder = mkdtempSync(join(tmpdir(), "tegotae-page-"));
let browser;
before(async () => (browser = await launch()));
after(async () => {
  await browser.close();
  rmSync(folder, { recursive: true });
});

/** Keeps every sample that the page is shown while it records, in `window.seen`. */
function keepSamples() {
  window.seen = [];
  let last = -1;
  setInterval(() => {
    const { state } = window.tegotae;
    if (!state?.recording) return;
    for (const sample of state.samples) if (sample[0] > last) window.seen.push(sample);
    last = state.samples[state.samples.length - 1]?.[0] ?? last;
  }, 8);
}

/** Records a motion that presses on the floor: the file, and the samples seen meanwhile. */
async function recorded() {
  let file = "", samples = [];
  await withPage(browser, ["serve", floor.file, "--recordings", folder], async (page) => {
    await page.page.evaluate(keepSamples);
    await page.control("record").click();
    await page.until(() => window.tegotae.state.recording_ticks > 0);
    file = (await page.state()).recording_file;
    await page.control("motion-choice").selectOption("press");
    await page.control("motion-choice-go").click();
    await page.until(() => window.tegotae.state.wrench[2] > 1);
    await page.until(() => window.tegotae.state.motion === null);
    await page.untilText("recording", /\.mcap/);
    await page.control("record").click();
    await page.until(() => !window.tegotae.state.recording);
    samples = await page.page.evaluate(() => window.seen);
  });
  return { file, samples };
}

/** Goes through the whole replay: the greatest force shown, N. */
async function strongestOf(page) {
  return page.page.evaluate(async () => {
    let best = 0;
    const { duration } = window.tegotae.scene;
    for (let i = 0; i <= 80; ++i) {
      window.tegotae.send({ type: "seek", t: (duration * i) / 80 });
      await new Promise((resolve) => setTimeout(resolve, 60));
      for (const [, x, y, z] of window.tegotae.state.samples) best = Math.max(best, Math.hypot(x, y, z));
    }
    return best;
  });
}

test("a recording is started and stopped on the page, and its replay shows the same forces", async () => {
  const { file, samples } = await recorded();
  const strongest = Math.max(...samples.map(forceOf));
  assert.ok(strongest > 1);
  await withPage(browser, ["replay", file], async (page) => {
    assert.equal(await page.page.evaluate(() => window.tegotae.scene.mode), "replay");
    await page.control("record").waitFor({ state: "hidden" });
    await page.control("method").waitFor({ state: "hidden" });
    await page.control("time-bar").waitFor({ state: "visible" });
    if (!(await page.state()).paused) await page.control("play").click();
    await page.until(() => window.tegotae.state.paused);
    const shown = await strongestOf(page);
    assert.ok(Math.abs(shown / strongest - 1) < 0.02, `${shown} N in place of ${strongest} N`);

    const { duration } = await page.page.evaluate(() => window.tegotae.scene);
    await page.control("time-bar").fill((duration / 2).toFixed(3));
    await page.until((t) => Math.abs(window.tegotae.state.t - t) < 0.1, duration / 2);
    await page.page.waitForTimeout(500);
    await page.picture("replay");
    await page.page.keyboard.press("Space");
    await page.until((t) => !window.tegotae.state.paused && window.tegotae.state.t > t + 0.2, duration / 2);
  });
});
