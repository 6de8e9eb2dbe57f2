// SPDX-License-Identifier: Apache-2.0
import * as THREE from "three";
import uPlot from "uplot";

document.body.append(new uPlot({ width: 1, height: 1, series: [] }, [[]], document.body).root);
new THREE.WebGLRenderer();
