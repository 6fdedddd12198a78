import { defineConfig } from "vitest/config";
import { thirdParty } from "./third-party.ts";

export default defineConfig({
  base: "/",
  plugins: [thirdParty()],
  build: {
    outDir: "../page",
    emptyOutDir: true,
    target: "es2022",
    sourcemap: false,
    // three.js is one file, and comes only to who looks at shapes
    chunkSizeWarningLimit: 600,
    // the content security policy allows neither inline scripts nor data URLs of scripts and fonts
    assetsInlineLimit: 0,
    modulePreload: { polyfill: false },
    rolldownOptions: {
      output: {
        codeSplitting: { groups: [{ name: "three", test: /node_modules[\\/]three[\\/]/ }] },
      },
    },
  },
  server: {
    fs: { allow: ["../.."] },
  },
  test: { include: ["tests/**/*.test.ts", "tests/**/*.test.tsx"] },
});
