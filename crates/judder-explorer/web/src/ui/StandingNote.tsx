/** What is to be known of results of values before, where they are numbers. */

import type { Standing } from "./standing";

interface StandingNoteProps {
  readonly standing: Standing | null;
  /** Whether it is read aloud: once a page. */
  readonly spoken?: boolean;
}

export function StandingNote({ standing, spoken = false }: StandingNoteProps) {
  return (
    <p class="standing" data-standing={standing?.kind} {...(spoken ? { role: "status" } : { "aria-hidden": "true" })}>
      {standing?.words}
    </p>
  );
}
