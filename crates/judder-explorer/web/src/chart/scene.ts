/** A picture as a tree of SVG elements: the page draws it, an export writes it, so both are the same. */

export interface Shape {
  readonly tag: string;
  readonly attributes: Readonly<Record<string, string | number>>;
  readonly children: readonly (Shape | string)[];
}

export function shape(tag: string, attributes: Shape["attributes"], ...children: readonly (Shape | string)[]): Shape {
  return { tag, attributes, children };
}

/** Coordinates to hundredths of a pixel: more digits only make files long. */
export function round(value: number): number {
  return Math.round(value * 100) / 100;
}

const ENTITIES: Record<string, string> = { "&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;" };

function escape(text: string): string {
  // XML has no control characters, not even escaped ones
  return text.replace(/[\u0000-\u0008\u000b\u000c\u000e-\u001f]/g, "").replace(/[&<>"]/g, (sign) => ENTITIES[sign] as string);
}

/** The tree as markup. */
export function markupOf(node: Shape | string): string {
  if (typeof node === "string") return escape(node);
  const attributes = Object.entries(node.attributes).map(([name, value]) => ` ${name}="${escape(String(value))}"`);
  const head = `<${node.tag}${attributes.join("")}`;
  return node.children.length === 0 ? `${head}/>` : `${head}>${node.children.map(markupOf).join("")}</${node.tag}>`;
}
