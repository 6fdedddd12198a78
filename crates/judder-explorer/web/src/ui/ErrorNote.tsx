/** An error where it belongs: what is wrong, where, and what would be right. */

import type { RequestError } from "../wire/request";

/** The source of an option: it stands in its own field, and its line tells nothing. */
const OPTION = "--set";

/** The error, unless the parameters already say the same: one mistake is told once. */
export function unlessSaid(error: RequestError | null, said: RequestError | null): RequestError | null {
  return error && said && error.message === said.message ? null : error;
}

/** What is said of results that stay beside an error. */
export const OF_BEFORE = "Of the values before: the present ones are refused.";

export function ErrorNote({ error }: { readonly error: RequestError | null }) {
  return (
    <div role="alert" class={error ? "error-note" : "visually-hidden"}>
      {error && (
        <>
          <p>{error.message}</p>
          {error.place && error.place.source !== OPTION && (
            <p class="error-place">
              {error.place.source}, line {error.place.line}: <code>{error.place.text}</code>
            </p>
          )}
          {error.help && <p class="error-help">{error.help}</p>}
        </>
      )}
    </div>
  );
}
