/** What is to be known of results, as the program says it. */

import type { Frame } from "../wire/frames";

export function Warnings({ warnings }: { readonly warnings: readonly string[] }) {
  return (
    <>
      {warnings.map((warning) => (
        <p key={warning} class="point-warning">
          {warning}
        </p>
      ))}
    </>
  );
}

/** Those of an outcome. */
export function warningsOf(outcome: Frame): readonly string[] {
  return (outcome.header["warnings"] ?? []) as readonly string[];
}
