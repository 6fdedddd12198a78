/** A server of its own for each test, and a page that is held to its promises: no error on the console, no request to elsewhere. */

import { type Page, type Route, expect, test as base } from "@playwright/test";
import { type ChildProcess, execFileSync, spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";

/** The program that is tested. */
export const JUDDER = process.env["JUDDER"] ?? resolve("../../../../target/debug/judder");
/** The root of the project. */
export const ROOT = resolve("../../../..");

export interface Explorer {
  readonly page: Page;
  readonly origin: string;
  /** A folder of the test's own. */
  readonly folder: string;
  /** Opens a view and waits until it has something to show. */
  open(view: string): Promise<void>;
}

interface Fixtures {
  /** What is explored: arguments of `judder explore`. */
  subject: string[];
  explorer: Explorer;
}

export const test = base.extend<Fixtures>({
  subject: [[], { option: true }],
  explorer: async ({ page, subject }, use) => {
    const folder = mkdtempSync(join(tmpdir(), "judder-page-"));
    const server = spawn(JUDDER, ["explore", "--json", "--no-browser", ...subject], { cwd: folder, stdio: ["ignore", "pipe", "inherit"] });
    const address = await addressOf(server);
    const origin = new URL(address).origin;
    const faults: string[] = [];
    page.on("console", (message) => {
      if (["error", "warning"].includes(message.type()) && !isOfTheBrowser(message.text())) faults.push(message.text());
    });
    page.on("pageerror", (error) => faults.push(`${error.message}\n${error.stack ?? ""}`));
    page.on("request", (request) => {
      if (!request.url().startsWith(`${origin}/`) && !/^(blob|data):/.test(request.url())) faults.push(`a request to ${request.url()}`);
    });
    await page.goto(address);
    await page.waitForURL((url) => url.pathname !== "/enter");
    const open = async (view: string) => {
      await page.goto(origin + view);
      await expect(page.locator("main.content")).toBeVisible();
    };
    await use({ page, origin, folder, open });
    await page.close();
    server.kill("SIGINT");
    const code = await new Promise((ended) => server.once("exit", ended));
    rmSync(folder, { recursive: true });
    expect(faults, "nothing on the console, nothing from elsewhere").toEqual([]);
    expect(code, "Ctrl-C ends it well").toBe(0);
  },
});

/** A study folder that `judder run` has made, and the results of its summary. */
export interface Study {
  readonly folder: string;
  readonly results: unknown;
}

/** Runs a case, or some of its analyses. */
function run(name: string, ...only: readonly string[]): Study {
  const folder = join(mkdtempSync(join(tmpdir(), "judder-study-")), name);
  execFileSync(JUDDER, ["run", join(ROOT, `cases/${name}.toml`), "-o", folder, "-q", ...only.flatMap((analysis) => ["--only", analysis])]);
  return { folder, results: (JSON.parse(readFileSync(join(folder, "summary.json"), "utf8")) as { results: unknown }).results };
}

interface Studies {
  readonly sliding: Study;
  readonly edge: Study;
  readonly block: Study;
  readonly disc: Study;
  readonly brake: Study;
  readonly damper: Study;
  readonly belt: Study;
}

/** Tests of studies: two sliding cases, of which one has a spectrogram, a structure, an assembly, and three whose cycles are sought; each is run once a worker. */
export const studies = test.extend<object, Studies>({
  sliding: [async ({}, use) => use(run("sliding/falling-friction")), { scope: "worker", timeout: 240_000 }],
  edge: [async ({}, use) => use(run("sliding/curved-edge")), { scope: "worker", timeout: 240_000 }],
  block: [async ({}, use) => use(run("benchmarks/block")), { scope: "worker", timeout: 240_000 }],
  disc: [async ({}, use) => use(run("assembly/pad-on-turning-disc")), { scope: "worker", timeout: 240_000 }],
  brake: [async ({}, use) => use(run("assembly/lumped-brake", "cycle", "damping")), { scope: "worker", timeout: 240_000 }],
  damper: [async ({}, use) => use(run("assembly/friction-damper")), { scope: "worker", timeout: 240_000 }],
  belt: [async ({}, use) => use(run("assembly/mass-on-falling-belt")), { scope: "worker", timeout: 240_000 }],
});

/** The browser notes refused requests, which the page shows to its user, and what its software renderer does slowly. */
function isOfTheBrowser(text: string): boolean {
  return /the server responded with a status of 4\d\d|GPU stall due to ReadPixels/.test(text);
}

async function addressOf(server: ChildProcess): Promise<string> {
  let text = "";
  for await (const part of server.stdout as NodeJS.ReadableStream) {
    text += String(part);
    if (text.includes("}")) break;
  }
  return (JSON.parse(text) as { address: string }).address;
}

/** What a command of judder prints as a document. */
export function judder(folder: string, ...args: string[]): Record<string, unknown> {
  return JSON.parse(execFileSync(JUDDER, [...args, "--json", "-q"], { cwd: folder, encoding: "utf8", maxBuffer: 1 << 28 })) as Record<string, unknown>;
}

/** The value at a path of a document, such as `dimensional.frequency_hz`. */
export function at(document: unknown, path: string): unknown {
  return path.split(".").reduce((value, step) => (value as Record<string, unknown> | undefined)?.[step], document);
}

/** A downloaded file's text. */
export async function downloaded(page: Page, click: () => Promise<void>): Promise<{ name: string; path: string }> {
  const [download] = await Promise.all([page.waitForEvent("download"), click()]);
  return { name: download.suggestedFilename(), path: await download.path() };
}

export { expect };

/** Holds back what the server is asked to compute until it is let go: what is shown until then is of the values before. */
export async function held(page: Page): Promise<() => Promise<void>> {
  let release = () => {};
  const released = new Promise<void>((resolve) => (release = resolve));
  const hold = async (route: Route) => {
    await released;
    await route.continue().catch(() => {}); // a request that was given up meanwhile
  };
  await page.route("**/api/**", hold);
  return async () => {
    release();
    await page.unroute("**/api/**", hold);
  };
}
