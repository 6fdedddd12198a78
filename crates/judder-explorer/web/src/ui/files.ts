/** Files that the page hands out, and the case file of the view. */

import { useEffect, useRef } from "preact/hooks";

/** The case file of a view. */
export interface CaseFile {
  /** Without its ending; left out, that of the case. */
  readonly name?: string;
  readonly text: Promise<string>;
}

let caseFile: (() => CaseFile) | undefined;

/** The page's own case file, for the export menu; without it the menu gives the case with the view's options. */
export function useCaseFile(make: () => CaseFile): void {
  const newest = useRef(make);
  useEffect(() => {
    newest.current = make;
  });
  useEffect(() => {
    const own = () => newest.current();
    caseFile = own;
    return () => {
      if (caseFile === own) caseFile = undefined;
    };
  }, []);
}

export function currentCaseFile(): CaseFile | undefined {
  return caseFile?.();
}

/** Saves a file through the browser. */
export function download(name: string, content: Blob | string, type: string): void {
  const blob = content instanceof Blob ? content : new Blob([content], { type });
  const link = document.createElement("a");
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  // the browser reads the address after the click
  setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}

/** A title as the name of a file. */
export function fileName(title: string): string {
  const plain = title.normalize("NFKD").replace(/[^\p{L}\p{N}]+/gu, "-");
  return plain.replace(/^-+|-+$/g, "").toLowerCase().slice(0, 60) || "judder";
}
