// SPDX-License-Identifier: Apache-2.0
import type { Scene, State } from "../protocol";
import { colours } from "./colours";
import { Dots } from "./dots";
import type { Layer } from "./layer";

const capacity = 4096;

/** The contact points, or of them those that push. */
class PointLayer implements Layer {
  private readonly dots: Dots;

  constructor(
    readonly name: string,
    readonly label: string,
    readonly colour: string,
    pixels: number,
    private readonly pushing: boolean,
  ) {
    this.dots = new Dots(colour, pixels, capacity);
  }

  get object() {
    return this.dots.object;
  }

  begin(_scene: Scene): void {
    this.dots.show([]);
  }

  show(state: State): void {
    this.dots.show(state.points.filter((point) => point[4] > 0 === this.pushing));
  }
}

export class NearPointLayer extends PointLayer {
  constructor() {
    super("points", "Contact points", colours.point, 7, false);
  }
}

export class ActivePointLayer extends PointLayer {
  constructor() {
    super("active", "Contact points that push", colours.activePoint, 11, true);
  }
}
