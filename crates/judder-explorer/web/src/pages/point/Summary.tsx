/** What an outcome tells of itself: its numbers, its checks and its warnings. */

import { Value } from "../../ui/Value";
import { Warnings } from "../../ui/Warnings";
import type { Frame } from "../../wire/frames";
import { type Check, entryAt, outcomeOf } from "../../wire/outcome";

/** A number in the summary, by its path in it. */
export interface Entry {
  readonly path: string;
  readonly name: string;
  readonly unit?: string;
}

export function Summary({ outcome, prefix, entries }: { readonly outcome: Frame; readonly prefix: string; readonly entries: readonly Entry[] }) {
  const { scalars, checks, warnings } = outcomeOf(outcome);
  return (
    <>
      <dl class="values summary">
        {entries.map(({ path, name, unit }) => (
          <Value key={path} name={name} dataKey={`${prefix}.${path}`} value={textOf(entryAt(scalars, path))} {...(unit ? { unit } : {})} />
        ))}
      </dl>
      {checks.map((check) => (
        <p key={check.name} class={check.passed ? "check" : "point-warning"} title={check.compared}>
          {check.passed ? "✓" : "✗"} {check.name}: {cameOut(check)}, limit {String(check.limit)}
        </p>
      ))}
      <Warnings warnings={warnings} />
    </>
  );
}

/** What came out of a check; one that compared nothing has no figure. */
function cameOut({ figure, numbers }: Check): string | number {
  if (numbers === 0) return "compared nothing";
  return typeof figure === "number" ? Number(figure.toPrecision(3)) : "no number";
}

function textOf(value: unknown): string | number | null {
  if (value === null || value === undefined) return null;
  if (typeof value === "boolean") return value ? "yes" : "no";
  if (Array.isArray(value)) return value.map(String).join(", ");
  return typeof value === "number" ? value : String(value);
}
