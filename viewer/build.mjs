// SPDX-License-Identifier: Apache-2.0
//
// node build.mjs OUTPUT: makes of the page's sources what a browser loads, in the folder OUTPUT: index.html, app.js,
// app.css, and licenses.txt with the licences of the packages inside. Nothing in them refers to another host.
import { build } from "esbuild";
import { copyFile, mkdir, readFile, writeFile } from "node:fs/promises";
import { createRequire } from "node:module";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const sources = dirname(fileURLToPath(import.meta.url));
const output = process.argv[2];
const bundled = ["three", "uplot"];

/** Folder of an installed package. Not every package exports its package.json, so its path is walked back to. */
function folderOf(name) {
  const entry = createRequire(import.meta.url).resolve(name);
  const inside = join("node_modules", name);
  return entry.slice(0, entry.lastIndexOf(inside) + inside.length);
}

async function licenceOf(name) {
  const folder = folderOf(name);
  const { version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
  return `${name} ${version}\n\n${await readFile(join(folder, "LICENSE"), "utf8")}`;
}

await mkdir(output, { recursive: true });
await build({
  entryPoints: { app: join(sources, "src/main.ts") },
  outdir: output,
  bundle: true,
  minify: true,
  target: "es2020",
  legalComments: "none",
  logLevel: "warning",
});
await build({
  entryPoints: { app: join(sources, "style.css") },
  outdir: output,
  bundle: true,
  minify: true,
  logLevel: "warning",
});
const licences = await Promise.all(bundled.map(licenceOf));
const preface = "The page of tegotae's live view contains these packages.\n";
await writeFile(join(output, "licenses.txt"), [preface, ...licences].join(`\n${"-".repeat(80)}\n\n`));
await copyFile(join(sources, "index.html"), join(output, "index.html"));
