// SPDX-License-Identifier: Apache-2.0
import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Group, LineBasicMaterial, LineSegments } from "three";
import { roundDown } from "../quantities";
import type { Scene, State } from "../protocol";
import { AdaptiveScale } from "./adaptive_scale";
import { colours } from "./colours";
import { Dots } from "./dots";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";

const capacity = 64;
const fullLength = 0.8; // of the longest line, in radii of the tool
const leastRange = 1e-4; // m of stretch that the longest line stands for at least

/** Where friction holds the tool and how far its bristle is stretched, much exaggerated. */
export class AnchorLayer implements Layer {
  readonly name = "anchors";
  readonly label = "Friction (pink where it slips)";
  readonly colour = colours.sticking;
  readonly object = new Group();
  private readonly sticking = new Dots(colours.sticking, 9, capacity);
  private readonly slipping = new Dots(colours.slipping, 9, capacity);
  private readonly ends = new BufferAttribute(new Float32Array(6 * capacity), 3).setUsage(DynamicDrawUsage);
  private readonly lines: LineSegments;
  private readonly scale = new AdaptiveScale(1, leastRange);

  constructor() {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", this.ends);
    const look = new LineBasicMaterial({ color: colours.sticking, depthTest: false, transparent: true, fog: false });
    this.lines = new LineSegments(geometry, look);
    this.lines.frustumCulled = false;
    this.lines.renderOrder = 9;
    this.object.add(this.lines, this.sticking.object, this.slipping.object);
  }

  /** How many times longer the stretch is drawn than it is. */
  get exaggeration(): number {
    return roundDown(this.scale.metresPerUnit);
  }

  begin(_scene: Scene, extent: SceneExtent): void {
    this.scale.begin(fullLength * extent.toolRadius);
    this.sticking.show([]);
    this.slipping.show([]);
    this.lines.geometry.setDrawRange(0, 0);
  }

  show(state: State): void {
    const anchors = state.anchors.slice(0, capacity);
    const longest = Math.max(0, ...anchors.map(([, , , sx, sy, sz]) => Math.hypot(sx, sy, sz)));
    this.scale.observe(longest, state.t);
    const times = this.exaggeration;
    anchors.forEach(([x, y, z, sx, sy, sz], i) => {
      this.ends.setXYZ(2 * i, x, y, z);
      this.ends.setXYZ(2 * i + 1, x + times * sx, y + times * sy, z + times * sz);
    });
    this.ends.needsUpdate = true;
    this.lines.geometry.setDrawRange(0, 2 * anchors.length);
    this.sticking.show(anchors.filter((anchor) => anchor[6] === 0));
    this.slipping.show(anchors.filter((anchor) => anchor[6] !== 0));
  }
}
