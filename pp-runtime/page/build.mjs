// Builds dist/: page.js and page.css as they are embedded in every page, and the licences of what is bundled.
//
//     npm ci && npm run build
//
// Same sources and lock file, same bytes: no time stamp, no path of this computer, no source map.

import { build } from "esbuild";
import { mkdir, readFile, writeFile } from "node:fs/promises";
import { fileURLToPath } from "node:url";
import path from "node:path";

const here = path.dirname(fileURLToPath(import.meta.url));
const out = process.argv[2] ? path.resolve(process.argv[2]) : path.join(here, "dist");

await mkdir(out, { recursive: true });

const options = {
  absWorkingDir: here,
  bundle: true,
  minify: true,
  charset: "ascii",
  legalComments: "none",
  target: ["chrome100", "firefox113", "safari16.4"],
  write: false,
};

const script = await build({ ...options, entryPoints: ["src/main.ts"], format: "iife" });
const style = await build({ ...options, entryPoints: ["src/page.css"] });

const javascript = script.outputFiles[0].text.trimEnd() + "\n";
const css = style.outputFiles[0].text.trimEnd() + "\n";
// Both are put inside elements of a page: nothing in them may end that element or open a comment in it.
for (const [text, forbidden] of [[javascript, /<\/script|<!--/i], [css, /<\/style|<!--/i]]) {
  const found = forbidden.exec(text);
  if (found) throw new Error(`the bundle contains ${found[0]}, which would end its element in the page`);
}

let licences = "The page of a program contains these libraries.\n";
for (const name of ["three", "uplot"]) {
  const folder = path.join(here, "node_modules", name);
  const { version, license } = JSON.parse(await readFile(path.join(folder, "package.json"), "utf8"));
  const text = await readFile(path.join(folder, "LICENSE"), "utf8");
  licences += `\n${name} ${version} (${license})\n\n${text.replaceAll("\r\n", "\n").trim()}\n`;
}

await writeFile(path.join(out, "page.js"), javascript);
await writeFile(path.join(out, "page.css"), css);
await writeFile(path.join(out, "LICENSES.txt"), licences);
console.log(`page.js ${(javascript.length / 1e3).toFixed(0)} kB, page.css ${(css.length / 1e3).toFixed(0)} kB`);
