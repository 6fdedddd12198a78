/** Whether what is shown is of the present values, and what is said over it where it is not: of charts within their plot. */

import { createContext } from "preact";
import { useEffect, useState } from "preact/hooks";
import type { Progress } from "../wire/follow";
import type { RequestError } from "../wire/request";
import { ofBefore } from "./ErrorNote";

export interface Standing {
  readonly kind: "computing" | "refused" | "before";
  readonly words: string;
}

/** How results within stand; null where they are of the present values. */
export const StandingContext = createContext<Standing | null>(null);

export interface Facts {
  /** Whether there are results at all. */
  readonly has: boolean;
  /** Whether they are of the present values. */
  readonly isCurrent: boolean;
  readonly busy: boolean;
  /** What is computed, in a sentence. */
  readonly what?: string | undefined;
  readonly progress?: Progress | null;
  readonly error?: RequestError | null;
}

export function standingOf({ has, isCurrent, busy, what = "", progress, error }: Facts): Standing | null {
  if (has && isCurrent) return null;
  if (busy) {
    const far = progress && progress.of > 1 ? ` ${progress.done} of ${progress.of}.` : "";
    return { kind: "computing", words: `Computing${what && ` ${what}`}…${far}${has ? " What is shown is of the values before." : ""}` };
  }
  if (error) return { kind: "refused", words: [`${sentence(error.message)}.`, error.help ? `${sentence(error.help)}.` : "", has ? ofBefore(error) : ""].filter(Boolean).join(" ") };
  return has ? { kind: "before", words: "Of the values before." } : null;
}

/** A word with which a sentence may begin large: names of files and keys, and symbols, are what they are. */
const WORD = /^(a|\p{Script=Latin}{2,}([-’'][\p{Script=Latin}]+)*)[.,:;]?$/u;

/** Messages of programs begin small, or with a name or a key in backticks, and end without a stop. */
function sentence(message: string): string {
  const text = message.replaceAll("`", "").replace(/\.$/, "");
  return WORD.test(message.split(/\s/)[0] ?? "") ? text.charAt(0).toUpperCase() + text.slice(1) : text;
}

/** So long nothing is said of results that are only on their way, in milliseconds: what follows a drag shall not flicker. */
const MOMENT = 400;

/** The standing of a result, of which newer ones that come in time put off what is said. */
export function useStanding(facts: Facts, result: unknown): Standing | null {
  const standing = standingOf(facts);
  const [isLate, setLate] = useState(false);
  const waits = standing !== null && standing.kind !== "refused";
  useEffect(() => {
    setLate(false);
    if (!waits) return;
    const timer = setTimeout(() => setLate(true), MOMENT);
    return () => clearTimeout(timer);
  }, [waits, result]);
  return waits && !isLate ? null : standing;
}
