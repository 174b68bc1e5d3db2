// SPDX-License-Identifier: BSD-3-Clause
// Bundles the pages of crumple report, --serve and crumple compare, each into one HTML file without a result: node build.mjs [FOLDER].
import { mkdir, readFile, rename, writeFile } from "node:fs/promises";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { build } from "esbuild";

const here = dirname(fileURLToPath(import.meta.url));
const folder = process.argv[2] ?? join(here, "..", "build", "viewer");
const pages = [
  { entry: "main.ts", template: "template.html", name: "report_template.html", libraries: ["three", "uplot", "fflate"] },
  { entry: "live/main.ts", template: "live_template.html", name: "live_template.html", libraries: [] },
  { entry: "compare/main.ts", template: "compare_template.html", name: "compare_template.html", libraries: ["uplot"] },
];

/** The licences of what is bundled go with it. */
async function licences(libraries) {
  const texts = [];
  for (const name of libraries) {
    const library = join(here, "node_modules", name);
    const { version } = JSON.parse(await readFile(join(library, "package.json"), "utf8"));
    texts.push(`${name} ${version}\n\n${(await readFile(join(library, "LICENSE"), "utf8")).trim()}`);
  }
  return texts.join("\n\n----\n\n");
}

async function buildPage({ entry, template, name, libraries }) {
  const result = await build({
    entryPoints: [join(here, "src", entry)],
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
  const banner = libraries.length === 0 ? "" : `/*\nThis page contains the following libraries.\n\n${await licences(libraries)}\n*/\n`;
  const script = (banner + text(".js")).replace(/<\/script/gi, "<\\/script").replace(/<!--/g, "<\\!--");
  const page = (await readFile(join(here, template), "utf8"))
    .replace("/* style */", () => text(".css"))
    .replace("/* script */", () => script);
  const file = join(folder, name);
  await mkdir(dirname(file), { recursive: true });
  // Written beside and renamed: a page cut short by a kill would count as built.
  await writeFile(`${file}.tmp`, page);
  await rename(`${file}.tmp`, file);
  console.log(`${file}: ${Math.round(page.length / 1024)} kB`);
}

for (const page of pages) await buildPage(page);
