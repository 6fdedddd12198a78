/** A link to another view of this page, which keeps the page. */

import type { ComponentChildren } from "preact";
import { type View, writeView } from "../state/view";
import { useApp } from "./app";

interface LinkProps {
  readonly to: View;
  readonly current?: boolean;
  readonly class?: string;
  readonly children: ComponentChildren;
}

export function Link({ to, current, children, ...rest }: LinkProps) {
  const { store } = useApp();
  const onClick = (event: MouseEvent) => {
    // other buttons and keys open tabs and windows
    if (event.button !== 0 || event.ctrlKey || event.metaKey || event.shiftKey || event.altKey) return;
    event.preventDefault();
    store.update(() => to);
  };
  return (
    <a href={writeView(to)} onClick={onClick} {...(current ? { "aria-current": "page" as const } : {})} {...rest}>
      {children}
    </a>
  );
}
