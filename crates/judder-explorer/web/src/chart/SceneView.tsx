/** A tree of SVG elements on the page. */

import { type JSX, h } from "preact";
import { useMemo } from "preact/hooks";
import type { Shape } from "./scene";

export function SceneView({ shapes }: { readonly shapes: readonly (Shape | string)[] }) {
  // the same elements are not compared again
  return useMemo(() => <>{shapes.map((node, index) => (typeof node === "string" ? node : element(node, index)))}</>, [shapes]);
}

function element(node: Shape, key: number): JSX.Element {
  const children = node.children.map((child, index) => (typeof child === "string" ? child : element(child, index)));
  return h(node.tag, { key, ...node.attributes } as JSX.IntrinsicElements["g"], ...children) as JSX.Element;
}
