/** A label with its markup, as HTML. */

import { spans } from "../chart/markup";

export function Label({ text }: { readonly text: string }) {
  return (
    <>
      {spans(text).map((span, index) => {
        const inner = span.italic ? <i>{span.text}</i> : span.text;
        if (span.level === 0) return <span key={index}>{inner}</span>;
        return span.level < 0 ? <sub key={index}>{inner}</sub> : <sup key={index}>{inner}</sup>;
      })}
    </>
  );
}
