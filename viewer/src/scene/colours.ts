// SPDX-License-Identifier: Apache-2.0
// Colours of what is drawn over the bodies. They stand out from light and from dark ones; style.css and the plots use
// the same for x, y, z, force and torque.

export const colours = {
  background: "#1b212b",
  grid: "#46505f",
  held: "#4cc3ff",
  proxy: "#f08a3c",
  bodies: "#b98f60",
  plane: "#3f8cff",
  point: "#8b95a3",
  activePoint: "#ff9f1c",
  sticking: "#2fd07a",
  slipping: "#ff4f8b",
  force: "#ff4d4f",
  torque: "#a875ff",
  rubber: "#f4f6fa",
  x: "#ff6b6b",
  y: "#5fd068",
  z: "#6ea8ff",
} as const;
