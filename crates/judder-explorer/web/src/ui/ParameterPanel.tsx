/** Every key of the case, by section. */

import { useEffect, useMemo, useState } from "preact/hooks";
import { useView } from "../state/store";
import { withOption } from "../state/view";
import type { Choice } from "../wire/api";
import type { RequestError } from "../wire/request";
import { useApp } from "./app";
import { Select } from "./choices";
import { ErrorNote } from "./ErrorNote";
import { byKey } from "./meant";
import { keyName } from "./numbers";
import { ParameterRow } from "./ParameterRow";

/** Windows with room for the panel beside the content. */
const roomy = globalThis.matchMedia("(min-width: 1000px)");

interface PanelProps {
  /** Keys that the page moves itself (the axes of a map). */
  readonly hidden?: readonly string[];
}

export function ParameterPanel({ hidden = [] }: PanelProps) {
  const { session, store, values, base, error } = useApp();
  const view = useView(store);
  const [open, setOpen] = useState(() => roomy.matches);
  useEffect(() => {
    const follow = () => setOpen(roomy.matches);
    roomy.addEventListener("change", follow);
    return () => roomy.removeEventListener("change", follow);
  }, []);
  const keys = session.keys.filter((key) => key.settable !== false && !hidden.includes(key.path));
  const choices = session.choices ?? [];
  const sections = [...new Set([...keys, ...choices].map((key) => key.section))];
  const paths = [...keys, ...choices].map((key) => key.path);
  const { blamed, others } = useMemo(() => byKey(error, paths, view.set), [error, paths.join(), view.set]);
  const refused = [...blamed.keys()].map((path) => keyName({ path }));
  const count = Object.keys(view.set).length;
  return (
    <aside class={`panel${open ? "" : " panel-closed"}`} aria-label="Parameters">
      <div class="panel-head">
        <h2>
          <button type="button" aria-expanded={open} aria-controls="parameters" onClick={() => setOpen(!open)}>
            Parameters
          </button>
        </h2>
        {error && <span class="panel-refused">{refused.length > 0 ? `${refused.join(", ")} ${refused.length > 1 ? "are" : "is"} refused` : "refused"}</span>}
        {open && (
          <button type="button" disabled={count === 0} onClick={() => store.update((view) => ({ ...view, set: {} }))}>
            Reset all
          </button>
        )}
      </div>
      <div id="parameters" hidden={!open}>
        {others.map((one, index) => (
          <ErrorNote key={index} error={one} />
        ))}
        {sections.map((section) => (
          <details key={section} open class="panel-section">
            <summary>
              {section}
              {[...keys, ...choices].some((key) => key.section === section && blamed.has(key.path)) && <span class="panel-refused"> refused</span>}
            </summary>
            {choices
              .filter((choice) => choice.section === section)
              .map((choice) => (
                <WordChoice key={choice.path} choice={choice} error={blamed.get(choice.path) ?? null} />
              ))}
            {keys
              .filter((key) => key.section === section)
              .map((key) => (
                <ParameterRow
                  key={key.path}
                  parameter={key}
                  value={values?.values.find((value) => value.path === key.path)}
                  base={base?.values.find((value) => value.path === key.path)}
                  error={blamed.get(key.path) ?? null}
                  set={view.set[key.path]}
                />
              ))}
          </details>
        ))}
      </div>
    </aside>
  );
}

/** A key that takes one of a few words. */
export function WordChoice({ choice: { path, doc, words, value }, error = null }: { readonly choice: Choice; readonly error?: RequestError | null }) {
  const { store } = useApp();
  const view = useView(store);
  const choose = (word: string) => store.update((view) => withOption(view, path, word === "" ? undefined : word));
  return (
    <>
      <label class="panel-choice" title={doc}>
        {path.replace(/[._]/g, " ")}
        <Select value={view.set[path] ?? ""} invalid={error !== null} options={[["", `the case's: ${value}`], ...words.map((word) => [word, word] as const)]} onChange={choose} />
      </label>
      {error && <ErrorNote error={error} />}
    </>
  );
}
