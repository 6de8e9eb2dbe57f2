// SPDX-License-Identifier: Apache-2.0
//
// node bench/live/page_frames.mjs [--json FILE] [--seconds N]
//
// How many frames a second the page draws in Chromium, on the processor alone, and how old the states are that it
// draws, while a motion plays in a loop. TEGOTAE_PROGRAM names the program that serves it.
import { writeFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { parseArgs } from "node:util";
import { launch, ViewerPage } from "../../tests/viewer/browser.mjs";
import { Program } from "../../tests/viewer/program.mjs";

const motion = "circle";
const size = { width: 1280, height: 720 };
const between = 250; // ms from one look at the frame rate to the next
const warmUp = 3000; // ms

/** Nearest rank. */
function percentile(values, part) {
  const sorted = [...values].sort((a, b) => a - b);
  return sorted[Math.max(Math.ceil(part * sorted.length), 1) - 1];
}

/** Looks at the page for so many seconds while the motion plays. */
async function watched(page, seconds) {
  return page.page.evaluate(
    async ([name, milliseconds, pause]) => {
      const { tegotae } = window;
      const rates = [];
      const ages = [];
      let newest = tegotae.agesWhenDrawn.at(-1);
      const begun = performance.now();
      while (performance.now() - begun < milliseconds) {
        if (tegotae.state.motion === null) tegotae.send({ type: "motion", name });
        await new Promise((resolve) => setTimeout(resolve, pause));
        rates.push(tegotae.framesPerSecond);
        // Ages have fractions of a microsecond: the newest that was seen marks where this look begins.
        const drawn = tegotae.agesWhenDrawn;
        ages.push(...drawn.slice(drawn.lastIndexOf(newest) + 1));
        newest = drawn.at(-1);
      }
      return { rates, ages };
    },
    [motion, 1000 * seconds, between],
  );
}

async function measure(seconds) {
  const loadBefore = loadavg()[0];
  const program = await Program.start("serve", "--port", "0");
  const browser = await launch();
  try {
    const page = await ViewerPage.open(browser, program.address, size);
    await page.page.evaluate((name) => window.tegotae.send({ type: "motion", name }), motion);
    await page.page.waitForTimeout(warmUp);
    const { rates, ages } = await watched(page, seconds);
    const drawsInSoftware = await page.page.evaluate(() => window.tegotae.drawsInSoftware);
    const version = browser.version();
    await page.close();
    return {
      browser: `Chromium ${version}`,
      width: size.width,
      height: size.height,
      draws_in_software: drawsInSoftware,
      motion,
      seconds,
      cores: cpus().length,
      load_before: loadBefore,
      frames_per_second: { median: percentile(rates, 0.5), min: Math.min(...rates), max: Math.max(...rates) },
      states_drawn: ages.length,
      states_drawn_per_second: ages.length / seconds,
      age_ms: { median: percentile(ages, 0.5), p99: percentile(ages, 0.99), max: Math.max(...ages) },
    };
  } finally {
    await browser.close();
    await program.stop();
  }
}

function textOf(figures) {
  const { frames_per_second: rate, age_ms: age } = figures;
  const fixed = (value) => value.toFixed(1).padStart(8);
  return [
    `${figures.browser}, ${figures.width} x ${figures.height}, ${figures.draws_in_software ? "software" : "GPU"} ` +
      `rendering, motion '${motion}', ${figures.seconds} s; ${figures.cores} cores, load before: ` +
      figures.load_before.toFixed(2),
    `frames a second: median ${fixed(rate.median)}, least ${fixed(rate.min)}, most ${fixed(rate.max)}`,
    `age of a state when drawn, ms: median ${fixed(age.median)}, p99 ${fixed(age.p99)}, max ${fixed(age.max)}`,
    `states drawn: ${figures.states_drawn}, ${figures.states_drawn_per_second.toFixed(1)} a second`,
  ].join("\n");
}

const { values } = parseArgs({
  options: { json: { type: "string" }, seconds: { type: "string", default: "20" } },
});
const figures = await measure(Number(values.seconds));
console.log(textOf(figures));
if (values.json !== undefined) writeFileSync(values.json, `${JSON.stringify(figures, null, 2)}\n`);
