/** The small markup of labels: `_{…}` and `^{…}` lower and raise, `$…$` sets symbols in italics (`judder-report`, markup.rs). */

export interface Span {
  readonly text: string;
  /** 0 on the line, −1 lowered, 1 raised, −2 lowered twice. */
  readonly level: number;
  readonly italic: boolean;
}

const DEEPEST = 2;

/** Characters of a label that are drawn, and of one that is told beside it, at most: what is stored may be of any length. */
const LONGEST = 200;
const LONGEST_TOLD = 4000;

/** A label as it is drawn: one that is too long for any picture ends in an ellipsis. */
export function drawn(label: string): string {
  return cut(label, LONGEST);
}

/** The whole of a label of which a part is drawn, as plain text; nothing where all of it is. */
export function undrawn(label: string): string | undefined {
  return label.length > LONGEST ? plainText(cut(label, LONGEST_TOLD)) : undefined;
}

function cut(label: string, longest: number): string {
  if (label.length <= longest) return label;
  // half of a character is none
  return `${label.slice(0, longest).replace(/[\ud800-\udbff]$/, "")}…`;
}

export function spans(label: string): readonly Span[] {
  const found: Span[] = [];
  const open: number[] = [];
  let symbols = false;
  let text = "";
  const characters = [...label];
  // looked for once: a label of nothing but openings would be read again for each
  const [lastEnd, lastTurn] = [characters.lastIndexOf("}"), characters.lastIndexOf("$")];
  const flush = () => {
    if (text !== "") found.push(...set(text, open, symbols));
    text = "";
  };
  for (let index = 0; index < characters.length; index += 1) {
    const character = characters[index] as string;
    const next = characters[index + 1];
    if ((character === "_" || character === "^") && next === "{" && lastEnd > index) {
      flush();
      open.push(character === "_" ? -1 : 1);
      index += 1;
    } else if (character === "}" && open.length > 0) {
      flush();
      open.pop();
    } else if (character === "$" && open.length === 0 && (symbols || lastTurn > index)) {
      flush();
      symbols = !symbols;
    } else {
      text += character;
    }
  }
  flush();
  return found;
}

/** Splits a text between dollars into italic letters and upright digits and signs. */
function set(text: string, open: readonly number[], symbols: boolean): Span[] {
  const level = (open.at(-1) ?? 0) * Math.min(open.length, DEEPEST);
  const letters = text.normalize("NFD").replace(/\p{M}/gu, "");
  // two letters in a row below or above the line make a word, which is upright
  if (!symbols || (level !== 0 && /\p{L}{2}/u.test(letters))) return [{ text, level, italic: false }];
  const runs = text.match(/(?:[\p{Script=Latin}\p{Ll}]\p{M}*)+|(?:(?![\p{Script=Latin}\p{Ll}])[^])+/gu) ?? [];
  return runs.map((run) => ({ text: run, level, italic: /^[\p{Script=Latin}\p{Ll}]/u.test(run) }));
}

/** The label as plain text, for names that are read aloud and for headers of tables. */
export function plainText(label: string): string {
  return spans(label)
    .map((span) => (span.level > 0 && /^[−-]?\d+$/.test(span.text) ? `^${span.text}` : span.text))
    .join("");
}

/** Size of a span relative to the label, and the height of its baseline. */
export function spanSize(level: number): number {
  return 0.72 ** Math.abs(level);
}

export function spanRise(level: number): number {
  const shift = level < 0 ? -0.22 : 0.38;
  return Array.from({ length: Math.abs(level) }, (_, depth) => shift * 0.72 ** depth).reduce((sum, rise) => sum + rise, 0);
}

/** About how wide a label is, in sizes of its letters: fonts are not measured, so that pictures do not depend on them. */
export function widthOf(label: string): number {
  return spans(drawn(label)).reduce((sum, span) => {
    const marks = span.text.match(/\p{M}/gu)?.length ?? 0;
    return sum + 0.57 * spanSize(span.level) * ([...span.text].length - marks);
  }, 0);
}
