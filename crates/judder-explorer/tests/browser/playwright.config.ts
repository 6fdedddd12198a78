import { defineConfig } from "@playwright/test";

/** One browser, Debian's own, and one server a test: nothing is shared, so nothing depends on the order. */
export default defineConfig({
  testDir: ".",
  workers: 2,
  fullyParallel: true,
  timeout: 120_000,
  expect: { timeout: 30_000 },
  forbidOnly: true,
  reporter: [["list"]],
  use: {
    viewport: { width: 1440, height: 900 },
    launchOptions: {
      executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
      // the tests of a build run as any user, in any container
      args: ["--no-sandbox", "--disable-dev-shm-usage", "--autoplay-policy=no-user-gesture-required"],
    },
  },
});
