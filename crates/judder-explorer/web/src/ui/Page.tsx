/** The layout of every page: parameters beside the content. */

import type { ComponentChildren } from "preact";
import { hasValues, useApp } from "./app";
import { ParameterPanel } from "./ParameterPanel";

interface PageProps {
  readonly title: string;
  /** Keys that the page moves itself. */
  readonly hiddenKeys?: readonly string[];
  /** Pages that show no case have no parameters. */
  readonly panel?: boolean;
  readonly children: ComponentChildren;
}

export function Page({ title, hiddenKeys, panel = true, children }: PageProps) {
  const { session } = useApp();
  const keys = panel && hasValues(session);
  return (
    <div class="page-columns">
      {keys && <ParameterPanel hidden={hiddenKeys ?? []} />}
      <main class="content" id="main" tabIndex={-1} aria-label={title}>
        <h1 class="visually-hidden">{title}</h1>
        {children}
      </main>
    </div>
  );
}
