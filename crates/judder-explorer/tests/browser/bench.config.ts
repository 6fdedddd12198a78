import base from "./playwright.config.ts";

/** Times are taken with nothing beside them. */
export default { ...base, testMatch: "*.bench.ts", workers: 1, fullyParallel: false, reporter: [["line"]] };
