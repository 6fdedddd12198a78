/** Keeps the licence texts of what is bundled: writes THIRD-PARTY.txt beside the page. */

import { existsSync, readFileSync, readdirSync } from "node:fs";
import { dirname, join } from "node:path";
import type { Plugin } from "vite";

const FONT_LICENCE = "../../judder-report/assets/fonts/OFL.txt";

/** The folder of the package that a module belongs to, or undefined for our own modules. */
function packageFolder(module: string): string | undefined {
  const path = module.replace(/^\0/, "").replace(/\?.*$/, "");
  if (!path.includes("/node_modules/")) return undefined;
  let folder = dirname(path);
  while (folder.includes("/node_modules/")) {
    const file = join(folder, "package.json");
    if (existsSync(file) && "version" in JSON.parse(readFileSync(file, "utf8"))) return folder;
    folder = dirname(folder);
  }
  return undefined;
}

/** The name, version, licence and licence texts of a package. */
function notice(folder: string): string {
  const about = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
  const files = readdirSync(folder).filter((name) => /^(licen[cs]e|notice|copying)/i.test(name)).sort();
  if (files.length === 0) throw new Error(`${about.name} is bundled but has no licence file`);
  const texts = files.map((name) => readFileSync(join(folder, name), "utf8").replace(/\r\n/g, "\n").trim());
  return `${about.name} ${about.version} (${about.license})\n\n${texts.join("\n\n")}`;
}

/** The notices of all packages that have modules in these chunks. */
function notices(chunks: readonly { type: string; moduleIds?: readonly string[] }[]): string[] {
  const folders = new Set<string>();
  for (const module of chunks.flatMap((chunk) => chunk.moduleIds ?? [])) {
    const folder = packageFolder(module);
    if (folder) folders.add(folder);
  }
  return [...folders].map(notice).sort();
}

/** Writes the licences into a comment at the head of each script, which travels alone. */
export function licencesAtTheHead(): Plugin {
  return {
    name: "licences-at-the-head",
    apply: "build",
    enforce: "post",
    generateBundle: {
      order: "post",
      handler(_options, bundle) {
        for (const chunk of Object.values(bundle)) {
          if (chunk.type !== "chunk") continue;
          const head = "The interactive chart of judder. It contains the following works of others, under these licences.";
          chunk.code = `/*!\n${[head, ...notices([chunk])].join("\n\n")}\n*/\n${chunk.code}`;
        }
      },
    },
  };
}

export function thirdParty(): Plugin {
  return {
    name: "third-party",
    apply: "build",
    generateBundle(_options, bundle) {
      const fonts = `Noto Sans, Noto Sans Math (subsets)\n\n${readFileSync(FONT_LICENCE, "utf8").trim()}`;
      const rule = `\n\n${"=".repeat(80)}\n\n`;
      const head = "This page contains the following works of others, under these licences.";
      this.emitFile({
        type: "asset",
        fileName: "THIRD-PARTY.txt",
        source: `${[head, ...notices(Object.values(bundle)), fonts].join(rule)}\n`,
      });
    },
  };
}
