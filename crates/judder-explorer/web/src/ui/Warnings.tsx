/** What is to be known of results, as the program says it. */

export function Warnings({ warnings, of }: { readonly warnings: readonly string[]; readonly of?: string }) {
  if (warnings.length === 0) return null;
  return (
    <ul class="warnings" aria-label={of ? `Warnings of ${of}` : "Warnings"}>
      {warnings.map((warning) => (
        <li key={warning}>{warning}</li>
      ))}
    </ul>
  );
}
