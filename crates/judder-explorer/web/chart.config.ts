import { defineConfig } from "vitest/config";
import { licencesAtTheHead } from "./third-party.ts";

/** The interactive chart alone, as one script that reports carry. */
export default defineConfig({
  plugins: [licencesAtTheHead()],
  publicDir: false,
  define: { "process.env.NODE_ENV": '"production"' },
  build: {
    outDir: "../../judder-report/assets/chart",
    emptyOutDir: true,
    target: "es2022",
    sourcemap: false,
    lib: { entry: "src/report/main.tsx", formats: ["iife"], name: "judderChart", fileName: () => "chart.js", cssFileName: "chart" },
  },
});
