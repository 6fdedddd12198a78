/** A label with its markup, as HTML. */

import { drawn, spans, undrawn } from "../chart/markup";

export function Label({ text }: { readonly text: string }) {
  const whole = undrawn(text);
  const parts = spans(drawn(text));
  const shown = (
    <>
      {parts.map((span, index) => {
        const inner = span.italic ? <i>{span.text}</i> : span.text;
        if (span.level === 0) return <span key={index}>{inner}</span>;
        return span.level < 0 ? <sub key={index}>{inner}</sub> : <sup key={index}>{inner}</sup>;
      })}
    </>
  );
  return whole === undefined ? shown : <span title={whole}>{shown}</span>;
}
