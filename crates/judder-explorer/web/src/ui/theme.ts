/** Light, dark, or what the system asks for. */

import { useEffect, useState } from "preact/hooks";
import type { Theme } from "../chart/palette";

export type Choice = "auto" | Theme;
export const CHOICES: readonly Choice[] = ["auto", "light", "dark"];

const KEPT = "judder-theme";
const listeners = new Set<() => void>();
const system = globalThis.matchMedia?.("(prefers-color-scheme: dark)");
let choice: Choice = CHOICES.find((one) => one === globalThis.localStorage?.getItem(KEPT)) ?? "auto";

system?.addEventListener("change", apply);

export function themeChoice(): Choice {
  return choice;
}

export function chooseTheme(next: Choice): void {
  choice = next;
  globalThis.localStorage?.setItem(KEPT, next);
  apply();
}

function theme(): Theme {
  if (choice !== "auto") return choice;
  return system?.matches ? "dark" : "light";
}

function apply(): void {
  document.documentElement.dataset["theme"] = theme();
  for (const listener of listeners) listener();
}

/** Before the first picture. */
export function startTheme(): void {
  apply();
}

export function useTheme(): Theme {
  const [now, setNow] = useState<Theme>(theme());
  useEffect(() => {
    const listener = () => setNow(theme());
    listeners.add(listener);
    listener();
    return () => void listeners.delete(listener);
  }, []);
  return now;
}
