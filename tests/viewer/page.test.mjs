// SPDX-License-Identifier: Apache-2.0
// The page of the built program in a browser, used as a person uses it.
import assert from "node:assert/strict";
import { writeFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, describe, test } from "node:test";
import { launch, output, ViewerPage, withPage } from "./browser.mjs";
import { Program } from "./program.mjs";
import { floor, lengthOf } from "./scene_facts.mjs";

const forceColour = [255, 77, 79]; // of the curve of the force's size

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const served = (args, use) => withPage(browser, ["serve", ...args], use);

describe("the page of tegotae serve", () => {
  test("shows its scene: the canvas is not blank, and nothing is cut off at 1280 by 720", () =>
    served([], async (page) => {
      await page.until(() => window.tegotae.framesPerSecond > 0);
      assert.ok((await page.colourCount({ x: 300, y: 100, width: 600, height: 400 })) > 50);
      assert.equal(await page.text("connection"), "live");
      assert.equal(await page.text("scene-name"), "table");
      const size = await page.page.evaluate(() => [document.body.scrollWidth, document.body.scrollHeight]);
      assert.deepEqual(size, [1280, 720]);
      for (const name of ["pause", "record", "help-button", "force-plot", "tick-plot", "method"]) {
        const { x, y, width, height } = await page.control(name).boundingBox();
        assert.ok(x >= 0 && y >= 0 && x + width <= 1280 && y + height <= 720, name);
      }
      await page.picture("table");
    }));

  test("dragging the tool onto the floor shows a force, and the floor stops the proxy", () =>
    served([floor.file], async (page) => {
      await page.dragTool(0, 220);
      await page.until(() => Math.hypot(...window.tegotae.state.wrench.slice(0, 3)) > 1);
      await page.untilText("number-force", /^[1-9][\d.]* N$/);
      const { tool, proxy, wrench, hand, points } = await page.state();
      assert.notEqual(hand, null);
      assert.ok(proxy[2] > floor.halfEdge - 1e-4, `the proxy is at ${proxy[2]} m`);
      assert.ok(tool[2] < proxy[2] - 1e-4, "the hand has gone on");
      assert.ok(wrench[2] > 0.6 * lengthOf(wrench.slice(0, 3)), "the floor pushes up");
      assert.ok(points.some(([, , , , force]) => force > 0));
      await page.page.waitForTimeout(600);
      const heights = await page.curveHeights("force-plot", forceColour);
      assert.ok(Math.max(...heights) > 20, "the curve rises above its base");
      await page.picture("pressed");
      await page.letGo();
    }));

  test("stiffness and method act at once; what is out of range changes nothing and is said", () =>
    served([floor.file], async (page) => {
      await page.pressDown(1);
      await page.letGo();
      const felt = async () => {
        await page.page.waitForTimeout(800);
        const { wrench, tool, proxy } = await page.state();
        return lengthOf(wrench.slice(0, 3)) / lengthOf([0, 1, 2].map((i) => proxy[i] - tool[i]));
      };
      await page.type("stiffness", 400);
      await page.untilValue("stiffness", 400);
      const soft = await felt();
      await page.type("stiffness", 800);
      await page.untilValue("stiffness", 800);
      const stiff = await felt();
      assert.ok(Math.abs(soft / 400 - 1) < 0.05, `${soft} N/m is felt`);
      assert.ok(Math.abs(stiff / 800 - 1) < 0.05, `${stiff} N/m is felt`);

      await page.control("method").selectOption("paper");
      await page.until(() => window.tegotae.settings.method === "paper");
      await page.until(() => window.tegotae.state.wrench[2] > 0.5);

      await page.type("stiffness", -5);
      await page.untilText("log", /stiffness/i);
      await page.control("toast").first().waitFor();
      assert.equal(await page.valueOf("stiffness"), 800);
      await page.until(() => document.getElementById("setting-stiffness").value === "800");
    }));

  test("a slider acts, and every permitted end of it is taken", () =>
    served([floor.file], async (page) => {
      const slider = page.control("slider-stiffness");
      for (const end of ["Home", "End"]) {
        const before = await page.valueOf("stiffness");
        await slider.press(end);
        const hasChanged = (last) =>
          window.tegotae.settings.values.find(({ name }) => name === "stiffness").value !== last;
        await page.until(hasChanged, before);
      }
      const { value, least, most } = (await page.settings()).values.find(({ name }) => name === "stiffness");
      assert.ok(value > least && value <= most);
    }));

  test("time stands still, goes on for a step, and begins anew", () =>
    served([floor.file], async (page) => {
      await page.control("pause").click();
      await page.until(() => window.tegotae.state.paused);
      await page.page.waitForTimeout(200);
      const { t } = await page.state();
      await page.page.waitForTimeout(200);
      assert.equal((await page.state()).t, t);
      await page.control("step").click();
      await page.until((stopped) => window.tegotae.state.t > stopped, t);
      assert.ok((await page.state()).t < t + 0.2, "one period, not more");
      await page.control("view").focus();
      await page.page.keyboard.press("Space");
      await page.until(() => !window.tegotae.state.paused);
      const start = (await page.state()).tool[2];
      await page.dragTool(0, -60);
      await page.until((z) => window.tegotae.state.tool[2] > z + 0.005, start);
      await page.letGo();
      await page.control("reset").click();
      await page.until((z) => Math.abs(window.tegotae.state?.tool[2] - z) < 1e-3, start);
    }));

  test("the tool moves and turns by keys alone, and every control can be reached", () =>
    served([], async (page) => {
      const start = await page.state();
      await page.page.keyboard.down("e");
      await page.until((z) => window.tegotae.state.tool[2] > z + 0.02, start.tool[2]);
      await page.page.keyboard.up("e");
      await page.page.keyboard.down("Shift");
      await page.page.keyboard.down("d");
      await page.until(() => Math.abs(window.tegotae.state.tool[6]) > 0.05);
      await page.page.keyboard.up("d");
      await page.page.keyboard.up("Shift");
      await page.until(() => window.tegotae.state.hand === null);

      const reached = new Set();
      for (let i = 0; i < 80; ++i) {
        await page.page.keyboard.press("Tab");
        reached.add(await page.page.evaluate(() => {
          const { outlineStyle } = getComputedStyle(document.activeElement);
          return `${document.activeElement.dataset.testid ?? ""}${outlineStyle === "none" ? " without outline" : ""}`;
        }));
      }
      const wanted = ["pause", "reset", "record", "frame-tool", "help-button", "view", "layer-force", "method",
        "setting-stiffness", "slider-damping", "motion-choice", "motion-choice-go", "curve-force-size"];
      for (const name of wanted) assert.ok(reached.has(name), `${name} is not among ${[...reached]}`);
    }));

  test("the help opens and closes by key", () =>
    served([], async (page) => {
      await page.page.keyboard.press("h");
      await page.control("help").waitFor({ state: "visible" });
      await page.picture("help");
      await page.page.keyboard.press("Escape");
      await page.control("help").waitFor({ state: "hidden" });
    }));

  test("layers can be hidden", () =>
    served([], async (page) => {
      const middle = { x: 300, y: 100, width: 600, height: 400 };
      const all = await page.colourCount(middle);
      for (const layer of ["bodies", "proxy", "held", "grid", "axes"]) await page.control(`layer-${layer}`).uncheck();
      await page.page.waitForTimeout(300);
      assert.ok((await page.colourCount(middle)) < all / 3);
    }));

  test("all text has a contrast of 4.5 or more to its ground", () =>
    served([], async (page) => {
      const { faintTexts } = await import("./contrast.mjs");
      assert.deepEqual(await page.page.evaluate(faintTexts, 4.5), []);
    }));

  test("every scene opens, and an experiment plays in its own", () =>
    served([], async (page) => {
      const isShown = (name) => window.tegotae.scene.name === name && window.tegotae.state?.n > 2;
      const { scenes, experiments } = await page.page.evaluate(() => window.tegotae.scene);
      assert.ok(scenes.length > 10 && experiments.length > 10);
      for (const name of scenes) {
        await page.control("scene-choice").selectOption(name);
        await page.control("scene-choice-go").click();
        await page.until(isShown, name);
      }
      await page.control("experiment-choice").selectOption("paper-cube");
      await page.control("experiment-choice-go").click();
      await page.until(isShown, "paper-cube");
      await page.until(() => window.tegotae.state.motion === "paper-cube" && window.tegotae.state.wrench[1] > 0.5);
      await page.control("stop").click();
      await page.until(() => window.tegotae.state.motion === null && window.tegotae.state.target !== null);
    }));

  test("a second viewer joins, sees the same, and waits for the tool", () =>
    served([floor.file], async (first, program) => {
      const second = await ViewerPage.open(browser, program.address);
      await first.until(() => window.tegotae.state.viewers === 2);
      await first.dragTool(40, 0);
      await second.until(() => window.tegotae.state.hand !== null);
      const name = (await first.state()).hand;
      await second.untilText("hand", new RegExp(`viewer ${name}`));
      await second.dragTool(0, 30);
      await second.control("toast").first().waitFor();
      assert.equal((await second.state()).hand, name);
      await second.page.mouse.up();
      await first.letGo();
      await second.close();
      await first.until(() => window.tegotae.state.viewers === 1);
    }));

  test("with a device in the hand the page says so, and offers no other way to move the tool", async () => {
    const file = join(output, "held.csv");
    writeFileSync(file, "t,x,y,z,qw,qx,qy,qz\n0,0,0,0,1,0,0,0\n1,0,0,0.01,1,0,0,0\n");
    await served([floor.file, "--interface", `playback:${file}`], async (page) => {
      await page.untilText("hand", /^playback is the hand$/);
      assert.match(await page.text("hint"), /^playback is the hand/);
      for (const name of ["motion-choice", "experiment-choice", "stop", "space-mouse"]) {
        await page.control(name).waitFor({ state: "hidden" });
      }
      await page.until(() => window.tegotae.state.t > 1.2);
      const seen = await page.page.evaluate(() => {
        window.told = [];
        const { send } = WebSocket.prototype;
        WebSocket.prototype.send = function (text) {
          window.told.push(text);
          send.call(this, text);
        };
        return window.tegotae.toolScreenPosition();
      });
      await page.dragTool(0, 60);
      await page.page.mouse.up();
      await page.page.keyboard.down("e");
      await page.page.waitForTimeout(500);
      await page.page.keyboard.up("e");
      assert.deepEqual(await page.page.evaluate(() => window.told), [], "the page tells the program nothing");
      const now = await page.page.evaluate(() => window.tegotae.toolScreenPosition());
      assert.ok(Math.hypot(now.x - seen.x, now.y - seen.y) > 1, "a drag, also of the tool, looks around");
      await page.page.keyboard.press("h");
      assert.match(await page.text("help-device"), /playback is the hand/);
      await page.control("help-hand").waitFor({ state: "hidden" });
      await page.picture("device");
    });
  });

  test("a stopped program is shown as such, and the page comes back with it", async () => {
    const program = await Program.start("serve", "--port", "0");
    const page = await ViewerPage.open(browser, program.address);
    assert.equal(await program.stop(), 0);
    await page.control("lost").waitFor({ state: "visible" });
    assert.match(await page.text("lost"), /The program has stopped/);
    assert.equal(await page.text("connection"), "stopped");
    await page.picture("stopped");
    const again = await Program.start("serve", "--port", program.port);
    try {
      await page.control("lost").waitFor({ state: "hidden" });
      await page.until(() => document.body.dataset.connection === "live");
      await page.close();
    } finally {
      await again.stop();
    }
  });

  test("how fast it is drawn and how old what it shows is, as figures", () =>
    served([], async (page) => {
      await page.pressDown(3);
      await page.page.waitForTimeout(3000);
      const figures = await page.page.evaluate(() => {
        const ages = [...window.tegotae.agesWhenDrawn].sort((a, b) => a - b);
        const { framesPerSecond, drawsInSoftware } = window.tegotae;
        return { framesPerSecond, drawsInSoftware, ageMedian: ages[ages.length >> 1], ages: ages.length };
      });
      await page.picture("live-view");
      await page.letGo();
      writeFileSync(join(output, "figures.json"), `${JSON.stringify(figures)}\n`);
      assert.ok(figures.drawsInSoftware, "the figures are those of software rendering");
      assert.ok(figures.framesPerSecond > 0 && figures.ages > 0 && figures.ageMedian >= 0);
    }));
});
