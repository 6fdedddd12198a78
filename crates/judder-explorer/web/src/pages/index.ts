/** The pages, each loaded when it is first shown. */

import type { JSX } from "preact";
import type { Page } from "../state/view";

export const pageOf: Record<Page, () => Promise<() => JSX.Element>> = {
  map: () => import("./map/MapPage").then((page) => page.MapPage),
  point: () => import("./point/PointPage").then((page) => page.PointPage),
  contact: () => import("./contact/ContactPage").then((page) => page.ContactPage),
  structures: () => import("./structures/StructuresPage").then((page) => page.StructuresPage),
};
