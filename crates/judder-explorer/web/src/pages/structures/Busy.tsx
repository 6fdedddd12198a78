/** What is on its way, or why it is not. */

import { ErrorNote } from "../../ui/ErrorNote";
import type { LiveArrays } from "./useArrays";

export function Busy({ live, words }: { readonly live: Pick<LiveArrays, "error" | "busy" | "cancel">; readonly words: string }) {
  return (
    <>
      <ErrorNote error={live.error} />
      {live.busy ? (
        <p role="status">
          {words}{" "}
          <button type="button" onClick={live.cancel}>
            Cancel
          </button>
        </p>
      ) : (
        !live.error && <p role="status">Nothing has been read. Pick the analysis again.</p>
      )}
    </>
  );
}
