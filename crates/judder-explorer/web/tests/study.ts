/** Parts of studies as tests make them, and a server that has their arrays. */

import { vi } from "vitest";
import type { StudyAnalysis, StudyVariable } from "../src/pages/structures/study";
import type { FrameArray } from "../src/wire/frames";
import { encode } from "./encode";

export const variable = (name: string, dimensions: string[], shape: number[], more: Partial<StudyVariable> = {}): StudyVariable => ({
  name, dimensions, shape, units: "1", long_name: name, attributes: {}, ...more,
});

export const analysis = (name: string, kind: string, variables: StudyVariable[], more: Partial<StudyAnalysis> = {}): StudyAnalysis => ({
  name, kind, status: "done", seconds: 1, scalars: {}, warnings: [], attributes: {}, variables, ...more,
});

export const array = (name: string, dimensions: string[], shape: number[], data: ArrayLike<number>, more: Partial<FrameArray> = {}): [string, FrameArray] => [
  name, { name, type: "f64", shape, dimensions, units: "1", longName: "", attributes: {}, data: Float64Array.from(data), texts: [], ...more },
];

/** Answers requests for rows of one-dimensional columns, and tells which were asked for. */
export function serve(columns: Readonly<Record<string, ArrayLike<number>>>): { from: number; to: number }[] {
  const asked: { from: number; to: number }[] = [];
  vi.stubGlobal("fetch", async (_path: string, { body }: { body: string }) => {
    const { variables, from, to } = JSON.parse(body) as { variables: string[]; from: number; to: number };
    asked.push({ from, to });
    const values = Float64Array.from(variables.flatMap((name) => Array.from(columns[name] ?? []).slice(from, to)));
    const rows = to - from;
    const arrays = variables.map((name, i) => ({ name, dimensions: ["row"], shape: [rows], offset: 8 * rows * i, units: "1", long_name: "", attributes: {}, type: "f64" }));
    const frames = [encode({ kind: "arrays", arrays }, new Uint8Array(values.buffer)), encode({ kind: "end", arrays: [] })];
    return new Response(new Blob(frames).stream());
  });
  return asked;
}
