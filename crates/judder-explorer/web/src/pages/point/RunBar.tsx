/** Start, progress and end of a computation, and whether its result still belongs to the view. */

import type { ComponentChildren } from "preact";
import { useState } from "preact/hooks";
import { useView } from "../../state/store";
import { options, withFields } from "../../state/view";
import { useApp } from "../../ui/app";
import { ErrorNote, unlessSaid } from "../../ui/ErrorNote";
import { download, fileName } from "../../ui/files";
import { type Analysis, fetchCaseFile } from "../../wire/api";
import { type RequestError, asRequestError } from "../../wire/request";
import { type RunKind, withRun } from "./state";
import type { Run } from "./useRun";

interface RunBarProps {
  readonly kind: RunKind;
  /** What the button starts. */
  readonly name: string;
  readonly run: Run<unknown>;
  readonly analysis: Analysis;
  /** From 0 to 1, where the page knows it better than the progress that is told. */
  readonly share?: number | null;
  /** Fields that the address keeps once it is started, so that they do not move with the parameters. */
  readonly keep?: Readonly<Record<string, string>>;
  readonly children?: ComponentChildren;
}

export function RunBar({ kind, name, run, analysis, share, keep = {}, children }: RunBarProps) {
  const { session, store, error } = useApp();
  const view = useView(store);
  const start = () => {
    const isOn = (view.fields["run"] ?? "").split(",").includes(kind);
    // switched on, it starts by itself
    if (isOn) run.start();
    store.update((view) => withFields(withRun(view, kind, true), keep));
  };
  const cancel = () => {
    run.cancel();
    store.update((view) => withRun(view, kind, false));
  };
  const [unsaved, setUnsaved] = useState<RequestError | null>(null);
  const save = async () => {
    setUnsaved(null);
    try {
      const text = await fetchCaseFile(options(view), analysis);
      download(`${fileName(`${session.case?.name ?? "case"} ${analysis.name}`)}.toml`, text, "application/toml");
    } catch (failure) {
      setUnsaved(asRequestError(failure));
    }
  };
  const done = share ?? (run.progress && run.progress.of > 1 ? run.progress.done / run.progress.of : null);
  return (
    <>
      <div class="run-bar">
        {children}
        <button type="button" class="run-start" onClick={start}>
          {run.result || run.error ? `${name} again` : name}
        </button>
        <button type="button" onClick={cancel} disabled={!run.busy} aria-label={`Cancel: ${name}`}>
          Cancel
        </button>
        <button type="button" onClick={() => void save()} aria-label={`Case file: ${name}`}>
          Case file
        </button>
        <span class="run-state" role="status" data-run={kind} data-busy={run.busy} data-complete={run.complete && !run.isStale}>
          {run.busy && <progress aria-label={`Progress: ${name}`} max={1} {...(done === null ? {} : { value: Math.min(done, 1) })} />}
          {stateText(run, done)}
        </span>
      </div>
      <ErrorNote error={run.result ? unlessSaid(run.error ?? unsaved, error) : (run.error ?? unsaved)} />
    </>
  );
}

function stateText(run: Run<unknown>, done: number | null): string {
  if (run.busy) return done === null ? "Computing…" : `${Math.floor(100 * Math.min(done, 1))} %`;
  if (run.isStale) return "Of other values: the parameters have moved since.";
  if (run.result && !run.complete) return "Not complete.";
  return run.result ? "Of the present values." : "";
}
