// @vitest-environment happy-dom
import { render } from "preact";
import { act } from "preact/test-utils";
import { afterEach, beforeEach, describe, expect, it } from "vitest";
import { bodyGrey, lineStyle } from "../src/chart/palette";
import { bodyCsv, bodyOf, bodySpec, projected, swingOf } from "../src/pages/structures/body";
import { completeness } from "../src/pages/structures/Completeness";
import { ContactTable } from "../src/pages/structures/ContactTable";
import { contactSums, readContacts } from "../src/pages/structures/contacts";
import { GrowthPanel } from "../src/pages/structures/GrowthPanel";
import { interfaceSpecs } from "../src/pages/structures/interfaces";
import { markLayers, marksOf } from "../src/pages/structures/marks";
import { ModeTable } from "../src/pages/structures/ModeTable";
import { ShapeView, enlarged } from "../src/pages/structures/ShapeView";
import { sized } from "../src/pages/structures/words";
import { analysis, array } from "./study";

let host: HTMLElement;
beforeEach(() => {
  host = document.body.appendChild(document.createElement("div"));
});
afterEach(() => {
  render(null, host);
  host.remove();
});
const shown = (key: string) => host.querySelector(`[data-key="${key}"]`);

/** Contact points of two contacts: a line of three, whose last is open, and a surface of four. */
function contacts(pressure?: number[]) {
  const words = array("contact", ["contact_point"], [7], [], { type: "text", texts: ["sole", "sole", "sole", "lid", "lid", "lid", "lid"] });
  const point = (name: string, values: number[]) => array(name, ["contact_point"], [7], values);
  return readContacts(
    new Map([
      words,
      point("x", [0, 1, 2, 0, 1, 0, 1]), point("y", [0, 0, 0, 5, 5, 5, 5]), point("z", [0, 0, 0, 0, 0, 2, 2]),
      point("gap", [0, 0, 1e-6, 0, 0, 0, 0]), point("normal_force", [30, 10, 0, 1, 2, 3, 4]), point("pressure", pressure ?? [3e6, 1e6, 0, 1e5, 2e5, 3e5, 4e5]),
    ]),
  );
}

describe("contact points", () => {
  it("are told by their pressure, or by their force where one has no area", () => {
    expect(contacts()).toMatchObject({ name: "Pressure", unit: "Pa", range: [0, 3e6] });
    expect(contacts([3e6, 1e6, 0, 1e5, 2e5, 3e5, Number.NaN])).toMatchObject({ name: "Normal force", unit: "N", range: [0, 30] });
    expect(contacts().open).toEqual([false, false, true, false, false, false, false]);
  });

  it("are drawn along their line, open ones hollow, or over their surface", () => {
    const [pressure, gap] = interfaceSpecs(contacts(), "sole");
    expect([pressure?.x.label, pressure?.y.label, gap?.y.label]).toEqual(["Place $x$ (m)", "Pressure (Pa)", "Gap $g$ (m)"]);
    expect(pressure?.layers).toMatchObject([{ label: "closed", x: [0, 1], y: [3e6, 1e6] }, { label: "open", hollow: true, x: [2], y: [0] }]);
    const over = interfaceSpecs(contacts(), "lid");
    expect(over.map(({ x, y, equal }) => [x.label, y.label, equal])).toEqual([["Place $x$ (m)", "Place $z$ (m)", true]]);
    expect(over[0]?.layers[0]).toMatchObject({ label: "Pressure 0 … 0.6 MPa", x: [0, 1, 0, 1], y: [0, 0, 2, 2] });
  });

  it("go along with the node on which they lie, as far as there is one", () => {
    const body = bodyOf(Float64Array.of(0, 0, 0, 1, 0, 0, 3, 4, 0), [0, 1]);
    const marks = marksOf(body, contacts());
    const swing = swingOf(body, Float64Array.of(0, 0, 0, 0.5, 0.25, 0, 0, 0, 0), false);
    const places = marks.placesAt(swing, 0, 2);
    expect([...places].slice(0, 9)).toEqual([0, 0, 0, 2, 0.5, 0, 2, 0, 0]);
    expect([...marks.shares].slice(0, 3)).toEqual([1, 1 / 3, 0]);
  });

  it("are exported over grey bodies with their names", () => {
    const body = bodyOf(Float64Array.of(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0), [0, 1, 2, 3], { names: ["disc", "disc", "pad", "pad"] });
    const swing = swingOf(body, new Float64Array(12), false);
    const look = { azimuth: 0, elevation: 0 };
    const marks = marksOf(body, contacts());
    const over = markLayers(marks, projected(marks.placesAt(swing, 0, 0), look, body.centre));
    const layers = bodySpec("map", body, swing, look, 0, 0, over).layers;
    expect(layers.map((layer) => layer.label)).toEqual([
      "at rest", "disc", "pad", "Pressure 0 … 0.6 MPa", "0.6 … 1.2 MPa", "1.2 … 1.8 MPa", "1.8 … 2.4 MPa", "2.4 … 3 MPa", "open",
    ]);
    expect(bodyCsv(body, swing, "m").split("\n").slice(0, 2)).toEqual(["body,point,x (m),y (m),z (m),Re u_x (m),Im u_x (m),Re u_y (m),Im u_y (m),Re u_z (m),Im u_z (m)", "disc,1,0,0,0,0,0,0,0,0,0"]);
  });

  it("are counted and summed contact by contact", () => {
    const sums = { normal_force: 40, tangential_force: [3, 4, 0], points: 3, closed: 2, open: 1, pressure_max: null };
    const own = analysis("steady", "steady-sliding", [], { scalars: { contacts: { sole: sums } } });
    expect(contactSums(own)).toEqual([{ name: "sole", points: 3, closed: 2, open: 1, normalForce: 40, frictionForce: 5, pressure: null }]);
    act(() => render(<ContactTable analysis="steady" contacts={contactSums(own)} />, host));
    expect(shown("steady.contacts.sole.closed")?.textContent).toBe("2");
    expect(shown("steady.contacts.sole.pressure_max")?.textContent).toBe("—");
  });
});

describe("the modes of an assembly", () => {
  const growing = [{ mode: 2, growth: { "material damping": -4, "lining: falling friction": 10 }, parents: [{ frequency_hz: 900, share: 0.75 }] }];
  const own = (scalars: Record<string, unknown>) => analysis("modes", "eigen", [], { scalars, attributes: { region: { re: [-10, 10], im: [0, 200 * Math.PI] } } });

  it("say what makes them grow and of which they are made", () => {
    act(() => render(<GrowthPanel analysis={own({ growing })} mode={2} />, host));
    expect(shown("modes.growing.0.growth.lining: falling friction")?.textContent).toBe("10");
    expect(shown("modes.growing.0.parents.0.frequency_hz")?.textContent).toBe("900");
    expect(shown("modes.growing.0.parents.0.share")?.textContent).toBe("75");
    act(() => render(<GrowthPanel analysis={own({ growing })} mode={1} />, host));
    expect(host.textContent).toBe("");
  });

  it("are called complete only where that is proven", () => {
    expect(completeness(own({ complete: true }))).toBe("Complete: it is proven that the searched region, 0 to 100 Hz with growth rates from −10 to 10 1/s, holds no other eigenvalue.");
    expect(completeness(own({ complete: false }))).toMatch(/^Not proven complete: .* may hold eigenvalues that are not listed\.$/);
    expect(completeness(own({}))).toBeNull();
  });

  it("have their damping ratios where these are stored", () => {
    const table = (dampingRatio?: number) => <ModeTable title="" modes={[{ frequency: 1, growth: 2, dampingRatio }]} picked={0} onPick={() => {}} dataKey="modes" />;
    act(() => render(table(-0.25), host));
    expect(shown("modes.damping_ratio.0")?.textContent).toBe("-0.25");
    act(() => render(table(), host));
    expect(host.textContent).not.toContain("Damping ratio");
  });
});

describe("bodies of an assembly", () => {
  it("have greys of their own in both themes", () => {
    for (const theme of ["light", "dark"] as const) {
      const greys = [0, 1, 2].map((k) => bodyGrey(k, 3, theme)[0]);
      expect(new Set(greys).size).toBe(3);
      expect(lineStyle({ body: 1, of: 3 }, theme).dash).toBe("solid");
    }
  });

  it("have no picture where all of them are one place", () => {
    const body = bodyOf(Float64Array.of(0, 0, 0, 0, 0, 0), []);
    act(() => render(<ShapeView title="t" body={body} swing={swingOf(body, new Float64Array(6), false)} motion={null} unit="m" />, host));
    expect(host.textContent).toContain("there is no picture");
  });

  it("say by how much their displacements are enlarged, in a unit that is easily read", () => {
    expect(enlarged(323, 8.38e-5, "m")).toBe("Displacements are drawn 323 times as large as they are; the largest is 83.8 µm.");
    expect(enlarged(0, 0, "m")).toBe("Nothing is displaced.");
    expect([sized("Pa", [0, 4.957e6]).text(4.957e6), sized("Pa", [0, 4.957e6]).unit, sized("1", [0, 1]).unit]).toEqual(["4.96", "MPa", ""]);
  });
});
