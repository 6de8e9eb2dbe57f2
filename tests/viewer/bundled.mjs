// SPDX-License-Identifier: Apache-2.0
import { build } from "esbuild";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const sources = join(dirname(fileURLToPath(import.meta.url)), "../../viewer/src");

/** What a module of the page exports, by its path below viewer/src, to be tested without a browser. */
export async function bundled(path) {
  const result = await build({
    entryPoints: [join(sources, path)],
    bundle: true,
    format: "esm",
    write: false,
    logLevel: "error",
  });
  return import(`data:text/javascript;base64,${Buffer.from(result.outputFiles[0].contents).toString("base64")}`);
}
