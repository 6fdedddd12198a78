/** Errors where they belong: what is wrong, where, and what would be right. */

import { Fragment } from "preact";
import { useContext } from "preact/hooks";
import { type RequestError, allOf, isPassing } from "../wire/request";
import { AppContext } from "./app";
import { meant } from "./meant";

/** The error, unless the parameters already say the same: one mistake is told once. */
export function unlessSaid(error: RequestError | null, said: RequestError | null): RequestError | null {
  return error && said && error.message === said.message ? null : error;
}

/** What is said of results that stay beside an error. */
export function ofBefore(error: RequestError): string {
  if (error.status === 0) return "Of the values before: the server does not answer.";
  if (isPassing(error)) return "Of the values before: there is no answer for the present ones.";
  return "Of the values before: the present ones are refused.";
}

export function ErrorNote({ error }: { readonly error: RequestError | null }) {
  return (
    <div role="alert" class={error ? "error-note" : "visually-hidden"}>
      {allOf(error).map((one, index) => (
        <Fragment key={index}>
          <p>{one.message}</p>
          <ErrorPlace error={one} />
          {one.help && <p class="error-help">{one.help}</p>}
        </Fragment>
      ))}
    </div>
  );
}

function ErrorPlace({ error }: { readonly error: RequestError }) {
  const app = useContext(AppContext);
  // before there is a session, errors are of the case file as it was given
  const place = meant(error, app ? (app.session.case?.text ?? "") : null);
  if (!place) return null;
  return (
    <p class="error-place">
      {"line" in place ? `${place.source}, line ${place.line}` : place.field}: <code>{place.text}</code>
    </p>
  );
}
