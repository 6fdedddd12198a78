/**
 * Stands in for `judder explore` while pages are built: `node tests/fake-server.mjs FOLDER [PORT]` serves a built page with the content
 * security policy of the real server, and invented answers. Nothing in it is physics.
 */
import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

const [folder = "../page", port = "8137"] = process.argv.slice(2);
const POLICY =
  "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' blob: data:; connect-src 'self'; font-src 'self'; media-src 'self' blob:; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";
const TYPES = { ".html": "text/html", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".woff2": "font/woff2", ".txt": "text/plain" };

const key = (path, symbol, group, unit, from, to, scale, value) => ({
  path, section: path.split(".")[0], symbol, group, unit, doc: `what ${path} is`, range: "positive",
  slider: { from, to, scale }, label: group ?? `${symbol} (${unit})`, label_si: `${symbol} (${unit})`, value,
});
const KEYS = [
  key("substrate.rubbery_modulus", "E0", null, "Pa", 1e4, 1e8, "log", 1e6),
  key("substrate.retardation_time", "τ", null, "s", 1e-6, 10, "log", 0.01),
  key("contact.shear_strength", "τ0", "τ0/E0*", "Pa", 1e-4, 1, "log", 0.01),
  key("oscillator.damping_x", "ξ_x", "ξ_x", "1", 0, 0.2, "linear", 0.01),
  key("oscillator.frequency_ratio", "Ω", "Ω", "1", 0.1, 10, "log", 1),
  key("operation.velocity", "v_d", "v_d τ/R", "m/s", 1e-8, 1e2, "log", 1e-4),
  key("operation.normal_load", "F_n", "F_n/(E0* R²)", "N", 1e-9, 1e-2, "log", 1e-6),
];
const SESSION = {
  version: "0.1.0", title: "An invented case", case: { name: "invented", model: "oscillator", text: "" },
  keys: KEYS, laws: ["oscillator-paper", "bem"], law: "oscillator-paper",
  map: { x: { key: "operation.velocity", from: 1e-8, to: 1e2, scale: "log" }, y: { key: "contact.shear_strength", from: 1e-4, to: 1, scale: "log" } },
  analyses: [], study: null,
};

function valuesOf(set) {
  const given = new Map(set.map((option) => [option.slice(0, option.indexOf("=")), option.slice(option.indexOf("=") + 1)]));
  return KEYS.map((entry) => {
    const text = given.get(entry.path);
    const number = text === undefined ? entry.value : Number.parseFloat(text);
    if (!Number.isFinite(number)) throw new Error(`\`${entry.path}\` is no number: ${text}`);
    const hasUnit = text !== undefined && /[a-z]$/i.test(text);
    const si = entry.group === null || hasUnit;
    return { path: entry.path, form: si ? "si" : "group", number, si: entry.group === null ? number : entry.unit === "1" ? null : number * (hasUnit ? 1 : 10), group: entry.group === null ? null : number / (hasUnit ? 10 : 1) };
  });
}

function frame(header, arrays = []) {
  let offset = 0;
  const entries = arrays.map(([name, data, shape, dimensions = []]) => {
    const entry = { name, type: data instanceof Uint8Array ? "u8" : "f64", shape, dimensions, offset, units: "1", long_name: name, attributes: {} };
    offset += Math.ceil(data.byteLength / 8) * 8;
    return entry;
  });
  let text = Buffer.from(JSON.stringify({ ...header, arrays: entries }));
  text = Buffer.concat([text, Buffer.alloc((8 - (text.length % 8)) % 8, " ")]);
  const payload = Buffer.alloc(offset);
  arrays.forEach(([, data], i) => Buffer.from(data.buffer, data.byteOffset, data.byteLength).copy(payload, entries[i].offset));
  const lengths = Buffer.alloc(8);
  lengths.writeUInt32LE(text.length, 0);
  lengths.writeUInt32LE(payload.length, 4);
  return Buffer.concat([lengths, text, payload]);
}

const spread = ({ from, to, scale }, count) => {
  const [a, b] = [Number.parseFloat(from), Number.parseFloat(to)];
  return Float64Array.from({ length: count }, (_, i) => (scale === "log" ? a * (b / a) ** (i / (count - 1)) : a + ((b - a) * i) / (count - 1)));
};
const ridge = (x, damping) => 0.01 + 0.05 * Math.exp(-((Math.log10(x) + 3) ** 2)) + damping;
const classAt = (x, y, damping) => (y > 10 * ridge(x, damping) ? (x > 1e-2 ? 3 : 1) : y > ridge(x, damping) ? (x > 1 ? 4 : 2) : 0);

function mapFrame(stage, analysis, damping, count) {
  const [x, y] = [spread(analysis.x, count), spread(analysis.y, count)];
  const classes = new Uint8Array(count * count);
  y.forEach((yValue, row) => x.forEach((xValue, column) => (classes[row * count + column] = classAt(xValue, yValue, damping))));
  return frame({ kind: "map", stage, seconds: 0.01, unresolved: 0 }, [["x", x, [count]], ["y", y, [count]], ["classes", classes, [count, count]]]);
}

const wait = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

async function map(body, response) {
  const damping = valuesOf(body.set).find((value) => value.path === "oscillator.damping_x").number;
  await wait(15);
  response.write(mapFrame("coarse", body.analysis, damping, 33));
  await wait(120);
  response.write(mapFrame("exact", body.analysis, damping, body.analysis.x.points));
  for (const name of body.boundaries ?? []) {
    const x = spread(body.analysis.x, 300);
    const factor = { full: 1, conservative: 1.4, decoupled: 0.7 }[name];
    response.write(frame({ kind: "boundary", name }, [["x", x, [300]], ["y", x.map((value) => factor * ridge(value, damping)), [300]], ["frequency", x, [300]]]));
  }
  response.end(frame({ kind: "end", seconds: 0.2 }));
}

function point(body) {
  const values = new Map(valuesOf(body.set).map((value) => [value.path, value.number]));
  const growth = values.get("contact.shear_strength") - ridge(values.get("operation.velocity"), values.get("oscillator.damping_x"));
  const pairs = [[0.25, 0.5], [-0.125, 0]];
  return {
    point: {
      groups: {}, equilibrium: { x: 0.48035585957917853, y: 0.16024773108741366, indentation: 0.000042732728289976974 },
      contact: { force: 5.194504735792959e-7, area: 0.00007977973698240479, viscoelastic_friction: 0.002860285088426742 },
      eigenvalues: [[growth, 1.4188220067193695], [growth, -1.4188220067193695], [-0.2, 2.3], [-0.2, -2.3]], growth_rate: growth,
      verdict: growth > 0 ? "unstable" : "stable", mechanism: growth > 0 ? "flutter" : null, equivalent_damping: -0.07,
      equivalent_damping_error: 0, growth_rate_within_law: [growth, growth], marginal_within_law: false,
      critical_shear_strength_within_law: [], critical_load_within_law: [],
      critical_shear_strength: [0.0159], critical_load: [], growth_shares: { damping: pairs, stiffness: pairs }, warnings: [],
    },
    modes: [], dimensional: { growth_rate_per_s: 40 * growth, frequency_hz: 9.03, indentation_m: 4.2e-7, x_m: 1e-6, y_m: 4e-7, force_n: 1e-4, area_m2: 8e-9 },
  };
}

function analysis(body, response) {
  const x = spread(body.analysis.sweep, body.analysis.sweep.points);
  const name = body.analysis.sweep.key.split(".").at(-1);
  const full = x.map((value) => ridge(value, 0.01));
  response.write(frame({ kind: "progress", done: 1, of: 2 }));
  response.write(frame({ kind: "outcome", name: body.analysis.name, scalars: {}, checks: [], warnings: [], attributes: {} }, [
    [name, x, [x.length], [name]], ["full", full, [x.length, 1], [name, "full_root"]], ["conservative", full.map((value) => 1.4 * value), [x.length, 1], [name, "conservative_root"]],
  ]));
  response.end(frame({ kind: "end" }));
}

async function answer(path, body, response) {
  const json = (value) => response.setHeader("Content-Type", "application/json").end(JSON.stringify(value));
  if (path === "/api/session") return json(SESSION);
  if (path === "/api/case") return json({ values: valuesOf(body.set), scales: {} });
  if (path === "/api/point") return json(point(body));
  if (path === "/api/export") return response.end(`# invented\n${body.set.join("\n")}\n${JSON.stringify(body.analysis)}\n`);
  response.setHeader("Content-Type", "application/x-judder-frames");
  if (path === "/api/map") return map(body, response);
  return analysis(body, response);
}

createServer(async (request, response) => {
  const path = new URL(request.url, "http://localhost").pathname;
  response.setHeader("Content-Security-Policy", POLICY);
  try {
    if (path.startsWith("/api/")) {
      let text = "";
      for await (const chunk of request) text += chunk;
      return await answer(path, text ? JSON.parse(text) : null, response);
    }
    const file = extname(path) ? normalize(path) : "/index.html";
    response.setHeader("Content-Type", TYPES[extname(file)] ?? "application/octet-stream");
    response.end(await readFile(join(folder, file)));
  } catch (error) {
    const status = path.startsWith("/api/") ? 422 : 404;
    response.writeHead(status, { "Content-Type": "application/json" });
    response.end(JSON.stringify({ error: { message: error.message, place: null, help: "Give a number, or a number with a unit." } }));
  }
}).listen(Number(port), "127.0.0.1");
