// Bundles src/report.js with plotly into dist/report.js, which is checked in: building puadem needs no node.
import { build } from "esbuild";
import { copyFile } from "node:fs/promises";

await build({
  entryPoints: ["src/report.js"],
  outfile: "dist/report.js",
  bundle: true,
  minify: true,
  format: "iife",
  target: "es2020",
  charset: "utf8",
  legalComments: "inline",
});
await copyFile("node_modules/plotly.js-basic-dist-min/LICENSE", "dist/LICENSE.plotly");
