/** What other pages in the same browser try, and what this page's own policy forbids. */

import { type Server, createServer } from "node:http";
import type { AddressInfo } from "node:net";
import { expect, test } from "./explorer";

/** A page of somebody else, on another port of this machine: for a browser another origin, but the same site. */
async function otherSite(html: string): Promise<{ server: Server; origin: string; asked: string[] }> {
  const asked: string[] = [];
  const server = createServer((request, response) => {
    asked.push(request.url ?? "");
    response.setHeader("content-type", "text/html").end(`<!doctype html><title>other</title>${html}`);
  });
  await new Promise<void>((ready) => server.listen(0, "127.0.0.1", ready));
  return { server, origin: `http://127.0.0.1:${(server.address() as AddressInfo).port}`, asked };
}

test("a page of another origin reads and computes nothing", async ({ explorer, browser }) => {
  await explorer.open("/map");
  const other = await otherSite("");
  // the same browser, with the same cookies
  const page = await explorer.page.context().newPage();
  await page.goto(other.origin);
  const tried = await page.evaluate(async (origin) => {
    const attempt = async (path: string, options: RequestInit) => {
      try {
        const answer = await fetch(origin + path, { credentials: "include", ...options });
        return `${answer.type} ${answer.status} ${(await answer.text()).length}`;
      } catch (error) {
        return `refused: ${(error as Error).name}`;
      }
    };
    const body = JSON.stringify({ set: [] });
    return [
      await attempt("/api/session", {}),
      await attempt("/api/session", { mode: "no-cors" }),
      await attempt("/api/point", { method: "POST", body, headers: { "content-type": "application/json" } }),
      await attempt("/api/point", { method: "POST", body, mode: "no-cors" }),
    ];
  }, explorer.origin);
  expect(tried.map((answer) => answer.replace(/\d+$/, ""))).toEqual(["refused: TypeError", expect.stringMatching(/refused|opaque 0/), "refused: TypeError", expect.stringMatching(/refused|opaque 0/)]);
  await page.setContent(`<iframe src="${explorer.origin}/map"></iframe>`);
  await page.waitForTimeout(500);
  const framed = page.frames().find((frame) => frame.url().startsWith(explorer.origin));
  expect(await framed?.locator("main").count().catch(() => 0) ?? 0, "it cannot be framed").toBe(0);
  await page.close();
  other.server.close();
  expect(browser.isConnected()).toBe(true);
});

test("the page runs nothing that is not part of the program, and asks nobody else", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map");
  const other = await otherSite("");
  // on a page of its own, so that the guards of this test do not mistake the attempts for the page's doing
  const attacked = await page.context().newPage();
  await attacked.goto(`${explorer.origin}/map`);
  const broken = await attacked.evaluate(async (origin) => {
    const found: string[] = [];
    document.addEventListener("securitypolicyviolation", (event) => found.push(event.effectiveDirective));
    const holder = window as unknown as { broken?: string };
    const script = document.createElement("script");
    script.textContent = "window.broken = 'inline script'";
    document.body.append(script);
    document.body.insertAdjacentHTML("beforeend", "<img src='x:' onerror=\"window.broken = 'handler'\">");
    const foreign = document.createElement("script");
    foreign.src = `${origin}/foreign.js`;
    document.body.append(foreign);
    const image = document.createElement("img");
    image.src = `${origin}/told.png`;
    document.body.append(image);
    await fetch(`${origin}/told`).catch(() => undefined);
    const form = document.createElement("form");
    form.action = `${origin}/form`;
    form.target = "_blank";
    document.body.append(form);
    form.submit();
    await new Promise((later) => setTimeout(later, 500));
    // only now: what a test runs at once is let through as a debugger's own
    try {
      new Function("window.broken = 'eval'")();
    } catch {
      found.push("eval");
    }
    return { ran: holder.broken ?? null, found: [...new Set(found)].sort() };
  }, other.origin);
  expect(broken.ran).toBeNull();
  for (const directive of ["connect-src", "eval", "form-action", "img-src", "script-src-elem"]) expect(broken.found).toContain(directive);
  expect(other.asked, "nothing was told to anybody").toEqual([]);
  await attacked.close();
  other.server.close();
});

test("the cookie is out of reach of scripts, and the token out of the address", async ({ explorer }) => {
  const { page } = explorer;
  await explorer.open("/map");
  expect(await page.evaluate(() => document.cookie)).toBe("");
  expect(page.url()).not.toContain("token");
  expect(await page.evaluate(() => document.referrer)).toBe("");
});
