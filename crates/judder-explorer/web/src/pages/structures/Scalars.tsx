/** The scalars of an analysis. */

import { Digits } from "../../ui/Digits";
import { rounded } from "../../ui/readable";
import type { StudyAnalysis } from "./study";

type Cell = string | number | boolean | null;

/** Names with their dots, and values; lists of tables are numbered from 0, as in the document. */
export function flat(value: unknown, path = ""): readonly (readonly [string, Cell])[] {
  if (Array.isArray(value)) {
    if (value.every(isCell)) return [[path, value.map((cell) => (typeof cell === "number" ? rounded(cell) : String(cell))).join(", ")]];
    return value.flatMap((item, index) => flat(item, `${path}.${index}`));
  }
  if (typeof value === "object" && value !== null) {
    return Object.entries(value).flatMap(([name, item]) => flat(item, path === "" ? name : `${path}.${name}`));
  }
  return isCell(value) ? [[path, value]] : [];
}

function isCell(value: unknown): value is Cell {
  return value === null || ["string", "number", "boolean"].includes(typeof value);
}

/** More of them would hide what matters. */
const SHOWN = 200;

interface ScalarsProps {
  readonly analysis: StudyAnalysis;
  /** Names of first order that are shown elsewhere. */
  readonly without?: readonly string[];
  readonly open?: boolean;
}

export function Scalars({ analysis, without = [], open = false }: ScalarsProps) {
  const kept = Object.fromEntries(Object.entries(analysis.scalars).filter(([name]) => !without.includes(name)));
  const rows = flat(kept);
  if (rows.length === 0) return null;
  return (
    <details class="scalars" open={open}>
      <summary>All numbers of {analysis.name}</summary>
      <table class="study-table">
        <thead>
          <tr>
            <th scope="col">Name</th>
            <th scope="col">Value</th>
          </tr>
        </thead>
        <tbody>
          {rows.slice(0, SHOWN).map(([name, value]) => (
            <tr key={name}>
              <th scope="row">{name}</th>
              <td>{typeof value === "number" || value === null ? <Digits dataKey={`${analysis.name}.${name}`} value={value} /> : String(value)}</td>
            </tr>
          ))}
        </tbody>
      </table>
      {rows.length > SHOWN && <p>{rows.length - SHOWN} more are in summary.json.</p>}
    </details>
  );
}
