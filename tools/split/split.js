// SPDX-License-Identifier: Apache-2.0
//
// node split.js INPUT OUTPUT: splits a triangle mesh into convex pieces by V-HACD. The program tegotae runs it.
// INPUT:  JSON {positions: [x, y, z, ...], indices: [i, j, k, ...], pieces, resolution, vertices}
// OUTPUT: JSON {pieces: [[x, y, z, ...], ...]}, the vertices of each piece.
// Exit code 3 where the package vhacd-js is not installed.
import { readFileSync, writeFileSync } from "node:fs";

let api;
try {
  api = await import("vhacd-js/lib/vhacd.js");
} catch {
  process.exit(3);
}
const input = JSON.parse(readFileSync(process.argv[2], "utf8"));
const decomposition = await api.ConvexMeshDecomposition.create();
const mesh = { positions: new Float64Array(input.positions), indices: new Uint32Array(input.indices) };
const hulls = decomposition.computeConvexHulls(mesh, {
  maxHulls: input.pieces,
  voxelResolution: input.resolution,
  maxVerticesPerHull: input.vertices,
  minVolumePercentError: 0.1,
});
writeFileSync(process.argv[3], JSON.stringify({ pieces: hulls.map((hull) => Array.from(hull.positions)) }));
