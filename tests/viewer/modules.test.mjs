// SPDX-License-Identifier: Apache-2.0
// Parts of the page that need no browser.
import assert from "node:assert/strict";
import { describe, test } from "node:test";
import { bundled } from "./bundled.mjs";

function near(actual, expected, tolerance = 1e-12) {
  assert.equal(actual.length, expected.length);
  actual.forEach((value, i) => assert.ok(Math.abs(value - expected[i]) <= tolerance, `${actual} is not ${expected}`));
}

describe("poses", async () => {
  const { pointOn, translated, turned, turnBy } = await bundled("poses.ts");
  const { Vector3 } = await import("three");
  const quarter = Math.SQRT1_2;
  const pose = [1, 2, 3, quarter, 0, 0, quarter]; // a quarter turn about z

  test("a point of the body is where the pose puts it", () => {
    near(pointOn(pose, [1, 0, 0]).toArray(), [1, 3, 3]);
  });

  test("a translation leaves the rotation alone", () => {
    near(translated(pose, new Vector3(0.5, 0, -1)), [1.5, 2, 2, quarter, 0, 0, quarter]);
  });

  test("a turn leaves the centre where it is, and the quaternion a unit one", () => {
    const centre = [0.1, -0.2, 0.3];
    const after = turned(pose, turnBy(new Vector3(0.3, -0.8, 0.4)), centre);
    near(pointOn(after, centre).toArray(), pointOn(pose, centre).toArray());
    assert.ok(Math.abs(Math.hypot(...after.slice(3)) - 1) < 1e-12);
    const rightAngle = turnBy(new Vector3(0, 0, Math.PI / 2));
    near(turned([0, 0, 0, 1, 0, 0, 0], rightAngle, [0, 0, 0]).slice(3), [quarter, 0, 0, quarter]);
  });

  test("no turn is the identity", () => near(turnBy(new Vector3()).toArray(), [0, 0, 0, 1]));
});

describe("quantities", async () => {
  const { grouped, roundDown, roundWithUnit, withUnit } = await bundled("quantities.ts");

  test("three digits and a prefix", () => {
    assert.equal(withUnit(0.01234, "m"), "12.3 mm");
    assert.equal(withUnit(12.34, "N"), "12.3 N");
    assert.equal(withUnit(-0.00031, "J"), "-310 µJ");
    assert.equal(withUnit(2e-8, "s"), "0.02 µs");
    assert.equal(withUnit(0, "N"), "0 N");
    assert.equal(withUnit(NaN, "N"), "–");
    assert.equal(roundWithUnit(0.02, "N m"), "20 mN m");
    assert.equal(roundWithUnit(5, ""), "5");
  });

  test("round numbers are not above what they round", () => {
    const pairs = [[1, 1], [1.99, 1], [2, 2], [4.9, 2], [5, 5], [9.9, 5], [0.01, 0.01], [0.0299, 0.02]];
    for (const [value, round] of pairs) {
      assert.ok(Math.abs(roundDown(value) - round) < 1e-12 * round, `${value}`);
    }
  });

  test("counts are grouped", () => assert.equal(grouped(1234567), "1\u202f234\u202f567"));
});

describe("slider", async () => {
  const { SliderScale, sliderSteps } = await bundled("panel/slider_scale.ts");
  const setting = (changes) => ({ name: "", label: "", unit: "", value: 1, least: 0, most: 10, zero_too: false,
    is_switch: false, available: true, ...changes });

  test("gives back what it is set to, over decades", () => {
    const scale = new SliderScale(setting({ name: "stiffness", value: 500, least: 1e-9, most: 1e9 }));
    assert.ok(scale.isLogarithmic);
    for (const value of [50, 120, 1000, 20000]) {
      assert.ok(Math.abs(scale.valueAt(scale.positionOf(value)) / value - 1) < 0.01, `${value}`);
    }
    assert.equal(scale.positionOf(50), 0);
    assert.equal(scale.positionOf(20000), sliderSteps);
  });

  test("reaches a value outside of what is usual, and never leaves what is permitted", () => {
    const stiffness = { name: "stiffness", least: 1, most: 1e9 };
    assert.equal(new SliderScale(setting({ ...stiffness, value: 1e5 })).valueAt(sliderSteps), 1e5);
    assert.equal(new SliderScale(setting({ ...stiffness, value: 500, most: 800 })).valueAt(sliderSteps), 800);
    const rate = { name: "physics_rate", value: 100, least: 60, most: 2000 };
    assert.equal(new SliderScale(setting(rate)).valueAt(0), 60);
  });

  test("has zero at its left end where zero is permitted", () => {
    const scale = new SliderScale(setting({ name: "damping", value: 0, least: 0, most: 1e4 }));
    assert.equal(scale.valueAt(0), 0);
    assert.equal(scale.positionOf(0), 0);
    assert.ok(scale.valueAt(1) > 0 && scale.positionOf(scale.valueAt(1)) >= 1);
  });

  test("is linear where a range has no decades", () => {
    const scale = new SliderScale(setting({ name: "friction", value: null, most: 10 }));
    assert.ok(!scale.isLogarithmic);
    assert.equal(scale.valueAt(sliderSteps / 2), 1);
  });
});

describe("history of samples", async () => {
  const { SampleHistory } = await bundled("panel/sample_history.ts");
  const sample = (t, f = 0) => [t, 0, f, 0, 0, 0, 2 * f];

  test("takes a sample once, though states overlap", () => {
    const history = new SampleHistory();
    history.add([sample(0.001), sample(0.002)], 0.002);
    history.add([sample(0.001), sample(0.002), sample(0.003, 5)], 0.003);
    const [t, fy, size, torque] = history.last(5, 0, 2, 7, 8);
    near([...t], [0.001, 0.002, 0.003]);
    near([...fy], [0, 0, 5]);
    near([...size], [0, 0, 5]);
    near([...torque], [0, 0, 10]);
  });

  test("shows the last seconds alone", () => {
    const history = new SampleHistory();
    for (let i = 0; i < 8000; ++i) history.add([sample(i / 1000)], i / 1000);
    const [t] = history.last(5, 0);
    assert.ok(Math.abs(t[0] - 2.999) < 1e-9 && t.length === 5001);
  });

  test("begins anew when time goes back", () => {
    const history = new SampleHistory();
    history.add([sample(7)], 7);
    history.add([sample(0.5)], 0.5);
    near([...history.last(5, 0)[0]], [0.5]);
  });

  test("keeps the newest when it is full", () => {
    const history = new SampleHistory();
    for (let i = 0; i < 150000; ++i) history.add([sample(i / 10000)], i / 10000);
    const [t] = history.last(2, 0);
    assert.ok(Math.abs(t[t.length - 1] - 14.9999) < 1e-9 && t.length > 19990);
    assert.ok(t.every((value, i) => i === 0 || value > t[i - 1]));
  });
});

describe("scale of arrows", async () => {
  const { AdaptiveScale } = await bundled("scene/adaptive_scale.ts");

  test("no arrow is longer than the longest", () => {
    const scale = new AdaptiveScale(0.2, 2);
    for (const value of [0.5, 3, 40, 7]) {
      scale.observe(value, 0);
      assert.ok(value * scale.metresPerUnit <= 0.2 + 1e-12);
    }
    assert.ok(Math.abs(scale.metresPerUnit - 0.2 / 50) < 1e-15);
  });

  test("comes back when all has long been small, not further than at first", () => {
    const scale = new AdaptiveScale(0.2, 2);
    scale.observe(40, 0);
    for (let t = 0; t < 3; t += 0.1) scale.observe(0.1, t);
    assert.ok(Math.abs(scale.metresPerUnit - 0.2 / 50) < 1e-15, "for a while it stays");
    for (let t = 3; t < 10; t += 0.1) scale.observe(0.1, t);
    assert.ok(Math.abs(scale.metresPerUnit - 0.1) < 1e-12);
  });
});

describe("hands", async () => {
  const { gamepadVelocity, stick } = await bundled("hand/gamepad_hand.ts");
  const { capAfter, capVelocity } = await bundled("hand/space_mouse.ts");
  const report = (...counts) => new DataView(new Int16Array(counts).buffer);
  const atRest = { translation: [0, 0, 0], rotation: [0, 0, 0] };

  test("a stick rests in its middle and reaches the end", () => {
    assert.equal(stick(0.1), 0);
    assert.equal(stick(1), 1);
    assert.equal(stick(-1), -1);
    assert.ok(stick(0.5) > 0 && stick(0.5) < 0.3);
  });

  test("a gamepad moves right, up and away", () => {
    const buttons = Array.from({ length: 16 }, () => ({ value: 0 }));
    assert.equal(gamepadVelocity([0.05, 0, 0, 0], buttons), null);
    buttons[7].value = 1;
    near(gamepadVelocity([1, -1, 0, 0], buttons).linear, [1, 1, 1]);
    near(gamepadVelocity([0, 0, 1, 0], buttons).angular, [0, 1, 0]);
  });

  test("a SpaceMouse tells of its cap in two reports, or in one", () => {
    const slid = capAfter(atRest, 1, report(350, -175, 700));
    near(slid.translation, [1, -0.5, 1]);
    const both = capAfter(slid, 2, report(0, 5, 350));
    near(both.translation, [1, -0.5, 1]);
    near(both.rotation, [0, 0, 1]);
    near(capAfter(atRest, 1, report(0, 0, 0, 350, 0, 0)).rotation, [1, 0, 0]);
    assert.equal(capAfter(both, 3, report(1)), both, "buttons do not move it");
  });

  test("the cap's axes are the hand's", () => {
    assert.equal(capVelocity(atRest), null);
    near(capVelocity({ translation: [0.1, 0.2, 0.3], rotation: [0, -1, 0] }).linear, [0.1, -0.3, -0.2]);
    near(capVelocity({ translation: [0, 0, 0], rotation: [0, -1, 0] }).angular, [0, 0, 1]);
  });
});

describe("what the hand tells the program", async () => {
  const { Hand } = await bundled("hand/hand.ts");
  const { Emitter } = await bundled("emitter.ts");
  const pose = (x) => [x, 0, 0, 1, 0, 0, 0];

  /** A program that keeps what it is told. */
  function listening(state) {
    const emitters = { connectionStates: new Emitter(), scenes: new Emitter(), states: new Emitter() };
    const program = { ...emitters, sent: [], notices: [], viewer: 1, pageIsHand: true, state };
    program.send = (message) => program.sent.push(message);
    program.notice = (_level, text) => program.notices.push(text);
    return program;
  }

  test("it begins at the target, sends the last pose and lets go", () => {
    const program = listening({ target: pose(1), hand: null, motion: null });
    const hand = new Hand(program);
    hand.move(() => pose(9));
    assert.deepEqual(program.sent, [], "who holds nothing moves nothing");
    assert.ok(hand.take("mouse"));
    for (let i = 0; i < 20; ++i) hand.move(([x]) => pose(x + 1));
    assert.ok(program.sent.length <= 2, "not faster than 60 messages a second");
    hand.release("mouse");
    assert.deepEqual(program.sent.slice(-2), [{ type: "hand", pose: pose(21) }, { type: "release" }]);
  });

  test("it says that it is still there, until the last holder has let go", () => {
    const program = listening({ target: pose(1), hand: 1, motion: null });
    const hand = new Hand(program);
    hand.take("mouse");
    hand.take("keys");
    const now = performance.now();
    for (let ms = 0; ms <= 1000; ms += 10) hand.sendDue(now + ms);
    assert.ok(program.sent.length >= 3 && program.sent.length <= 6, `${program.sent.length} messages in a second`);
    hand.release("mouse");
    assert.ok(hand.isHolding);
    hand.release("keys");
    assert.equal(program.sent.pop().type, "release");
  });

  test("it leaves the tool to what moves it, and says so", () => {
    for (const state of [{ target: null, hand: null, motion: "press" }, { target: pose(0), hand: 2, motion: null }]) {
      const program = listening(state);
      assert.equal(new Hand(program).take("mouse"), false);
      assert.match(program.notices[0], state.motion ? /press/ : /Viewer 2/);
    }
  });

  test("it never takes the tool where a device is the hand", () => {
    const program = listening({ target: pose(0), hand: null, motion: null });
    program.pageIsHand = false;
    assert.equal(new Hand(program).take("mouse"), false);
    assert.deepEqual(program.sent, []);
  });

  test("it lets go without a word when another one has taken over", () => {
    const program = listening({ target: pose(0), hand: null, motion: null });
    const hand = new Hand(program);
    hand.take("mouse");
    program.states.emit({ hand: 3 });
    assert.ok(!hand.isHolding);
    assert.deepEqual(program.sent, []);
  });
});

describe("protocol", async () => {
  const { parse } = await bundled("protocol.ts");
  const { socketAddress } = await bundled("connection.ts");

  test("unknown messages are left alone", () => {
    assert.equal(parse('{"type": "later version"}'), null);
    assert.equal(parse('{"type": 3}'), null);
    assert.deepEqual(parse('{"type": "welcome", "viewer": 2}'), { type: "welcome", viewer: 2 });
  });

  test("the socket is at the page's own address, with its token", () => {
    assert.equal(socketAddress(new URL("http://127.0.0.1:7000/")), "ws://127.0.0.1:7000/live");
    assert.equal(socketAddress(new URL("https://host/?token=a%26b")), "wss://host/live?token=a%26b");
  });
});
