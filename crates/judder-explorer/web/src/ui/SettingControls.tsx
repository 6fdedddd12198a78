/** Controls of the settings of an analysis, made from what is declared of them. */

import { type Setting, accepts, settingsOf, textOf } from "../state/settings";
import { useView } from "../state/store";
import { withFields } from "../state/view";
import type { RequestError } from "../wire/request";
import { useApp } from "./app";
import { Select, Switch } from "./choices";
import { blames } from "./meant";
import { TextField } from "./TextField";

interface SettingControlsProps {
  readonly kind: string;
  /** The paths of those that stand open; the others come at a click. */
  readonly first?: readonly string[];
  /** Why there is no newer result: the settings that it speaks of are marked. */
  readonly error: RequestError | null;
}

export function SettingControls({ kind, first = [], error }: SettingControlsProps) {
  const { session, store } = useApp();
  const { fields } = useView(store);
  const settings = settingsOf(session.settings, kind);
  const others = settings.filter(({ path }) => !first.includes(path));
  const control = (setting: Setting) => (
    <Control
      key={setting.path}
      setting={setting}
      text={textOf(kind, setting, fields)}
      invalid={blames(error, setting.path)}
      onChange={(text) => store.update((view) => withFields(view, { [setting.field]: text === "" ? undefined : text }))}
    />
  );
  return (
    <>
      {settings.filter(({ path }) => first.includes(path)).map(control)}
      {others.length > 0 && (
        <details class="settings" open={others.some(({ path, field }) => blames(error, path) || fields[field] !== undefined)}>
          <summary>More settings</summary>
          <div class="settings-body">{others.map(control)}</div>
        </details>
      )}
    </>
  );
}

interface ControlProps {
  readonly setting: Setting;
  readonly text: string;
  readonly invalid: boolean;
  readonly onChange: (text: string) => void;
}

function Control({ setting, text, invalid, onChange }: ControlProps) {
  const { path, form } = setting;
  const [name, title] = [path.replace(/[._]/g, " "), toldOf(setting)];
  if (form.kind === "flag") {
    return <Switch name={name} title={title} on={text === "true"} onChange={(on) => onChange(String(on))} />;
  }
  if (form.kind === "choice") {
    return (
      <label class="choice" title={title}>
        {name}{" "}
        <Select value={text} invalid={invalid} options={[...(text === "" ? [["", "—"] as const] : []), ...form.words.map(({ word, doc }) => [word, word, doc] as const)]} onChange={onChange} />
      </label>
    );
  }
  // an empty field is the case's own value again
  return <TextField name={name} title={title} value={text} invalid={invalid} accepts={(text) => text.trim() === "" || accepts(setting, text)} onChange={onChange} />;
}

/** What is said of a key, without the markup of the book. */
function toldOf({ symbol, doc, words }: Setting): string {
  const plain = (text: string) => text.replace(/\[([^\]]+)\]\([^)]*\)/g, "$1").replaceAll("`", "");
  return `${symbol && `${symbol}: `}${plain(doc).replace(/\.$/, "")} (${plain(words)})`;
}
