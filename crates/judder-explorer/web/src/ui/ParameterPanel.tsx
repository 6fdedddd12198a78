/** Every key of the case, by section. */

import { useEffect, useState } from "preact/hooks";
import { useView } from "../state/store";
import { withOption } from "../state/view";
import type { Key } from "../wire/api";
import { useApp } from "./app";
import { ErrorNote } from "./ErrorNote";
import { blamedKey } from "./meant";
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
  const sections = [...new Set(keys.map((key) => key.section))];
  const told = error ? blamedKey(error, [...keys.map((key) => key.path), LAW], view.set) : undefined;
  const blamed = keys.find((key) => key.path === told);
  const count = Object.keys(view.set).length;
  return (
    <aside class={`panel${open ? "" : " panel-closed"}`} aria-label="Parameters">
      <div class="panel-head">
        <h2>
          <button type="button" aria-expanded={open} aria-controls="parameters" onClick={() => setOpen(!open)}>
            Parameters
          </button>
        </h2>
        {error && <span class="panel-refused">{blamed ? `${nameOf(blamed)} is refused` : "refused"}</span>}
        {open && (
          <button type="button" disabled={count === 0} onClick={() => store.update((view) => ({ ...view, set: {} }))}>
            Reset all
          </button>
        )}
      </div>
      <div id="parameters" hidden={!open}>
        {error && !blamed && <ErrorNote error={error} />}
        {sections.map((section) => (
          <details key={section} open class="panel-section">
            <summary>
              {section}
              {blamed?.section === section && <span class="panel-refused"> refused</span>}
            </summary>
            {section === "contact" && session.laws.length > 1 && <LawChoice laws={session.laws} invalid={told === LAW} />}
            {keys
              .filter((key) => key.section === section)
              .map((key) => (
                <ParameterRow
                  key={key.path}
                  parameter={key}
                  value={values?.values.find((value) => value.path === key.path)}
                  base={base?.values.find((value) => value.path === key.path)}
                  error={blamed === key ? error : null}
                  set={view.set[key.path]}
                />
              ))}
          </details>
        ))}
      </div>
    </aside>
  );
}

function nameOf(key: Key): string {
  return (key.path.split(".").at(-1) ?? key.path).replaceAll("_", " ");
}

const LAW = "contact.law";

/** The law of the case, as its key is set. */
export function LawChoice({ laws, invalid = false }: { readonly laws: readonly string[]; readonly invalid?: boolean }) {
  const { session, store } = useApp();
  const view = useView(store);
  const choose = (event: Event) => {
    const law = (event.currentTarget as HTMLSelectElement).value;
    store.update((view) => withOption(view, LAW, law === "" ? undefined : law));
  };
  return (
    <label class="panel-choice">
      contact law
      <select value={view.set[LAW] ?? ""} aria-invalid={invalid} onChange={choose}>
        <option value="">{session.law ? `the case's: ${session.law}` : "the case's"}</option>
        {laws.map((law) => (
          <option key={law} value={law}>
            {law}
          </option>
        ))}
      </select>
    </label>
  );
}

/** Keys with words instead of numbers, which have no slider but may stand in an address. */
export const WORD_KEYS: readonly string[] = [LAW, "contact.friction_load", "indenter.shape"];
