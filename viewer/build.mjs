// SPDX-License-Identifier: BSD-3-Clause
// Bundles the viewer into one HTML file without a result: node build.mjs [FILE].
import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const file = process.argv[2] ?? join(here, "..", "build", "viewer", "report_template.html");

/** The licences of what is bundled go with it. */
async function licences() {
  const texts = [];
  for (const name of ["three", "uplot", "fflate"]) {
    const folder = join(here, "node_modules", name);
    const { version } = JSON.parse(await readFile(join(folder, "package.json"), "utf8"));
    texts.push(`${name} ${version}\n\n${(await readFile(join(folder, "LICENSE"), "utf8")).trim()}`);
  }
  return texts.join("\n\n----\n\n");
}

const result = await build({
  entryPoints: [join(here, "src", "main.ts")],
  absWorkingDir: here,
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  outdir: "out",
  write: false,
});
const text = (ending) => result.outputFiles.find((output) => output.path.endsWith(ending)).text;
const banner = `/*\nThis page contains the following libraries.\n\n${await licences()}\n*/\n`;
const script = (banner + text(".js")).replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
const template = await readFile(join(here, "template.html"), "utf8");
const page = template
  .replace("/* style */", () => text(".css"))
  .replace("/* script */", () => script);
await mkdir(dirname(file), { recursive: true });
// Written beside and renamed: a page cut short by a kill would count as built.
await writeFile(`${file}.tmp`, page);
await rename(`${file}.tmp`, file);
console.log(`${file}: ${Math.round(page.length / 1024)} kB`);
