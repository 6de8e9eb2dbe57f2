// SPDX-License-Identifier: Apache-2.0
import {
  CircleGeometry,
  DoubleSide,
  Group,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  Quaternion,
  RingGeometry,
  Vector3,
} from "three";
import { pointOn } from "../poses";
import type { Scene, State, Vector } from "../protocol";
import { colours } from "./colours";
import type { Layer } from "./layer";
import type { SceneExtent } from "./scene_extent";

const capacity = 64; // objects so near; more are not drawn
const radius = 1.1; // of a disc, in radii of the tool

/** The planes that stand for the near objects' surfaces, as discs over against the tool. */
export class PlaneLayer implements Layer {
  readonly name = "planes";
  readonly label = "Planes of near objects";
  readonly colour = colours.plane;
  readonly object = new Group();
  private readonly discs = this.instances(new CircleGeometry(1, 40), 0.2);
  private readonly rims = this.instances(new RingGeometry(0.965, 1, 40), 0.9);
  private size = 1;
  private centre: Vector = [0, 0, 0]; // of the tool's mass

  constructor() {
    this.object.add(this.discs, this.rims);
  }

  begin(scene: Scene, extent: SceneExtent): void {
    this.size = radius * extent.toolRadius;
    this.centre = scene.tool.centre_of_mass;
    this.discs.count = this.rims.count = 0;
  }

  show(state: State): void {
    const count = Math.min(state.planes.length, capacity);
    const turn = new Quaternion(), z = new Vector3(0, 0, 1), place = new Matrix4();
    const tool = pointOn(state.proxy, this.centre);
    for (let i = 0; i < count; ++i) {
      const [px, py, pz, nx, ny, nz] = state.planes[i]!;
      const normal = new Vector3(nx, ny, nz).normalize();
      const height = tool.clone().sub(new Vector3(px, py, pz)).dot(normal);
      turn.setFromUnitVectors(z, normal);
      place.compose(tool.clone().addScaledVector(normal, -height), turn, new Vector3().setScalar(this.size));
      this.discs.setMatrixAt(i, place);
      this.rims.setMatrixAt(i, place);
    }
    for (const mesh of [this.discs, this.rims]) {
      mesh.count = count;
      mesh.instanceMatrix.needsUpdate = true;
    }
  }

  private instances(geometry: CircleGeometry | RingGeometry, opacity: number): InstancedMesh {
    const look = new MeshBasicMaterial({
      color: colours.plane,
      transparent: true,
      opacity,
      side: DoubleSide,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -1,
      polygonOffsetUnits: -2,
    });
    const mesh = new InstancedMesh(geometry, look, capacity);
    mesh.frustumCulled = false;
    mesh.count = 0;
    return mesh;
  }
}
