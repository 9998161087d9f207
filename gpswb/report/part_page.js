// SPDX-License-Identifier: LGPL-2.1-or-later
// The tables and legends of one part's report.
"use strict";

const report = JSON.parse(document.getElementById("data").textContent);
const result = report.result;
const by = (id) => document.getElementById(id);
const regionOf = new Map(result.regions.map((region) => [region.id, region]));
const CLASSES = report.classes;
let views = null;
let palette = "wheel";
let chosen = null; // id of the region selected

const classColour = (name) => report.palettes[palette][name] ?? report.none;
const intrinsic = (region) => Object.entries(region.intrinsic)
  .map(([name, value]) => `${name.replace(/_deg$/, "").replaceAll("_", " ")} ${number(value, 6)}${name.endsWith("_deg") ? "°" : ""}`).join(", ");
const situation = (region) => Object.entries(region.situation).map(([name, value]) => `${name} ${list(value)}`).join(" ");

function tiles() {
  const check = result.validation, mesh = result.mesh;
  const entries = [
    [result.initial_region_count, "initial regions"],
    [result.regions.length, "refined regions"],
    [result.sharp_edge_regions, "sharp-edge regions"],
    [mesh.triangles.toLocaleString("en"), `triangles, density ${mesh.density}`],
  ];
  if (check) entries.push(
    [percent(check.area_accuracy), "area accuracy"],
    [`${check.right_faces}/${check.judged_faces}`, `faces right, ${percent(check.face_accuracy)}`],
    [percent(check.region_f1), `region F1, ${check.found} of ${check.features} features`],
  );
  by("figures").replaceChildren(...entries.map(([value, name]) => {
    const tile = make("div", null, { class: "tile" });
    tile.append(make("b", value), make("span", name));
    return tile;
  }));
}

// Fig. 8: six colours round the wheel, complementary ones opposite; complex in the middle.
const WHEEL = ["planar", "revolute", "cylindrical", "spherical", "prismatic", "helical"];

function wheel() {
  const svg = by("colour-wheel");
  const point = (radius, angle) => [radius * Math.sin(angle), -radius * Math.cos(angle)].map((x) => x.toFixed(1));
  const parts = [];
  const count = (name) => result.regions.filter((region) => region.class === name).length;
  WHEEL.forEach((name, i) => {
    const [a, b, middle] = [i - 0.5, i + 0.5, i].map((x) => (x * Math.PI) / 3);
    const path = `M${point(36, a)} L${point(84, a)} A84 84 0 0 1 ${point(84, b)} L${point(36, b)} A36 36 0 0 0 ${point(36, a)} Z`;
    parts.push(draw("path", { class: "sector", d: path, fill: rgb(classColour(name)) }));
    const [x, y] = point(93, middle), side = Math.sin(middle);
    const anchor = Math.abs(side) < 0.1 ? "middle" : side > 0 ? "start" : "end";
    const lower = Math.cos(middle) < -0.5 ? 10 : Math.cos(middle) > 0.5 ? -2 : 4;
    parts.push(draw("text", { x, y: Number(y) + lower, "text-anchor": anchor }, `${name} ${count(name)}`));
  });
  parts.push(draw("circle", { r: 31, fill: rgb(classColour("complex")) }));
  parts.push(draw("text", { y: -1, "text-anchor": "middle", style: "fill:#fff;font-size:10.5px" }, "complex"));
  parts.push(draw("text", { y: 12, "text-anchor": "middle", style: "fill:#fff;font-size:10.5px" }, String(count("complex"))));
  svg.replaceChildren(...parts);
}

function legends() {
  wheel();
  const area = result.regions.reduce((sum, region) => sum + region.area, 0) || 1;
  const rows = CLASSES.map((name) => {
    const mine = result.regions.filter((region) => region.class === name);
    const faces = result.faces.filter((face) => face.class === name).length;
    return { name, regions: mine.length, faces, share: mine.reduce((sum, region) => sum + region.area, 0) / area };
  });
  const columns = [
    ["class", (row) => swatched(row.name, classColour(row.name))],
    ["regions", (row) => row.regions, true],
    ["area", (row) => percent(row.share), true],
  ];
  if (result.faces.length) columns.splice(2, 0, ["faces", (row) => row.faces, true]);
  table(by("classes"), columns, rows);
  by("sharp-edges").replaceChildren(swatched("sharp edges, drawn as lines", report.sharp_edge));
  by("shape-types").replaceChildren(...report.shape_types.map((type) => {
    const item = make("li");
    item.append(swatched(`${type.name} ${percent(type.share)}`, type.colour));
    return item;
  }));
}

function ranking(region, why) {
  by("ranking-title").textContent = `Ranking of log-likelihoods: region ${region.id}${why}`;
  const facts = [
    region.class + (region.surface ? ` (${region.surface})` : ""), intrinsic(region), situation(region),
    `${number(region.area)} mm², ${region.triangles} triangles`, `residual ${number(region.residual, 3)} mm`,
    region.margin === null ? "" : `margin ${number(region.margin, 3)}`,
    region.undecided.length ? `undecided between ${region.undecided.join(", ")}` : "",
    region.faces.length ? region.faces.join(" ") : "",
  ];
  by("ranking-facts").textContent = facts.filter(Boolean).join(" · ");
  const known = Object.entries(region.log_likelihood).filter(([, value]) => value !== null);
  const rows = known.sort((a, b) => b[1] - a[1]).map(([name, value]) => ({ name, value }));
  const [best, worst] = rows.length ? [rows[0].value, rows[rows.length - 1].value] : [0, 0];
  for (const name of CLASSES) if (!rows.some((row) => row.name === name)) rows.push({ name, value: null });
  table(by("ranking-table"), [
    ["invariance class", (row) => {
      const cell = swatched(row.name, classColour(row.name));
      if (row.name === region.class) cell.append(make("b", "  ← recognised"));
      return cell;
    }],
    ["log L", (row) => (row.value === null ? "not evaluated" : row.value.toFixed(1)), true],
    ["below the best", (row) => (row.value === null ? "" : number(best - row.value, 4)), true],
    ["", (row) => {
      const share = row.value === null ? 0 : best === worst ? 1 : 0.04 + 0.96 * (row.value - worst) / (best - worst);
      return make("span", null, { class: "bar", style: `width:${(100 * share).toFixed(1)}%;background:${rgb(classColour(row.name))}` });
    }],
  ], rows);
  for (const line of by("ranking-table").tBodies[0].rows) {
    line.cells[3].className = "bars";
    if (line.cells[1].textContent === "not evaluated") line.cells[3].replaceChildren();
  }
}

function choose(id) {
  chosen = id === chosen ? null : id;
  feature = null;
  for (const line of document.querySelectorAll("tr.pick")) line.classList.toggle("chosen", chosen !== null && line.dataset.region === String(chosen));
  if (chosen !== null && regionOf.has(chosen)) ranking(regionOf.get(chosen), "");
  by("wrong").checked = false;
  views?.select(chosen === null ? null : (facet) => views.mesh.region[facet] === chosen);
}

function regions() {
  by("regions-title").textContent = `Regions (${result.regions.length})`;
  table(by("regions"), [
    ["region", (r) => r.id, true, (r) => r.id],
    ["class", (r) => swatched(r.class, classColour(r.class)), false, (r) => r.class],
    ["surface", (r) => r.surface, false, (r) => r.surface],
    ["area mm²", (r) => number(r.area, 6), true, (r) => r.area],
    ["intrinsic", intrinsic, false, intrinsic],
    ["situation feature", situation],
    ["residual mm", (r) => number(r.residual, 3), true, (r) => r.residual ?? Infinity],
    ["margin", (r) => number(r.margin, 3), true, (r) => r.margin ?? Infinity],
    ["undecided", (r) => r.undecided.join(", "), false, (r) => r.undecided.join(", ")],
    ["triangles", (r) => r.triangles, true, (r) => r.triangles],
    ["initial", (r) => r.initial_regions, true, (r) => r.initial_regions],
    ["faces", (r) => r.faces.join(" "), false, (r) => r.faces.length],
  ], [...result.regions], (region) => choose(region.id), (region) => region.id, (region) => region.id === chosen);
}

function validation() {
  const check = result.validation;
  by("validation").hidden = by("wrong-label").hidden = !check;
  if (!check) return;
  const across = [...CLASSES, "none"];
  const rows = CLASSES.map((name) => ({ name, counts: check.confusion[name] }));
  table(by("confusion"), [
    ["true", (row) => swatched(row.name, classColour(row.name))],
    ...across.map((name) => [name, (row) => row.counts[name], true]),
  ], rows);
  rows.forEach((row, i) => {
    const total = Object.values(row.counts).reduce((a, b) => a + b, 0);
    across.forEach((name, k) => {
      const cell = by("confusion").tBodies[0].rows[i].cells[k + 1], share = total ? row.counts[name] / total : 0;
      if (!row.counts[name]) cell.classList.add("zero");
      else cell.style.background = `rgba(var(${name === row.name ? "--good-bg" : "--bad-bg"}), ${(0.12 + 0.5 * share).toFixed(2)})`;
    });
  });
  const wrong = check.failures.filter((f) => f.wrong_class), apart = check.failures.length - wrong.length;
  by("wrong-title").textContent = `Faces that disagree with CAD (${wrong.length} of ${result.faces.length})`;
  const text = (key) => (f) => f[key] ?? "–";
  const share = new Map(result.faces.map((face) => [face.name, face.share]));
  table(by("disagree"), [
    ["face", text("face"), false, (f) => Number(f.face.replace(/\D/g, ""))],
    ["CAD", (f) => (f.true_class ? swatched(f.true_class, classColour(f.true_class)) : "–"), false, text("true_class")],
    ["recognised", (f) => (f.class ? swatched(f.class, classColour(f.class)) : "–"), false, text("class")],
    ["surface", text("surface"), false, text("surface")],
    ["share", (f) => percent(share.get(f.face)), true, (f) => share.get(f.face)],
    ["triangles", text("triangles"), true, (f) => f.triangles],
    ["kind", text("kind"), false, text("kind")],
    ["region", text("region"), true, (f) => f.region ?? -1],
  ], wrong, (f) => { if (f.region !== null) choose(f.region); }, (f) => f.region, (f) => f.region !== null && f.region === chosen);
  by("disagree").hidden = !wrong.length;
  by("wrong-note").textContent = [
    wrong.length ? "" : "Every face has the class of its CAD surface.",
    apart ? `Right class, but no region matches the feature at IoU 0.9: ${apart}.` : "",
  ].join(" ");
}

function about() {
  const { source, settings, mesh } = result;
  by("title").textContent = source.path.split(/[\\/]/).pop();
  by("subtitle").textContent = "Partition in ISO GPS invariance classes (ISO 18183, ISO 17450-1)";
  document.title = `${by("title").textContent}: partition report`;
  const facts = {
    file: source.path, "SHA-256": source.sha256, unit: source.unit, density: mesh.density, mesher: mesh.mesher,
    mesh: `${mesh.vertices.toLocaleString("en")} vertices, ${mesh.triangles.toLocaleString("en")} triangles`,
    mode: settings.mode, method: settings.method, "noise σ": `${number(settings.sigma, 3)} mm`, program: report.program,
  };
  by("about").replaceChildren(...Object.entries(facts).flatMap(([name, value]) => [make("dt", name), make("dd", value)]));
  by("notes").replaceChildren(...result.notes.map((note) => make("li", note)));
  const times = Object.entries(result.timings_s), most = Math.max(...times.map(([, s]) => s), 1e-9);
  table(by("timings"), [
    ["stage", ([name]) => name],
    ["s", ([, seconds]) => seconds.toFixed(3), true],
    ["", ([, seconds]) => make("span", null, { class: "bar", style: `width:${(100 * seconds / most).toFixed(1)}%;background:var(--accent)` })],
  ], [...times, ["all", times.reduce((sum, [, s]) => sum + s, 0)]]);
  by("timings").tBodies[0].rows[times.length].cells[2].replaceChildren();
}

// Colours that tell many regions apart: hues by the golden angle, three lightnesses.
function randomColour(i) {
  const hue = (i * 137.508) % 360, light = [0.56, 0.7, 0.44][i % 3];
  const f = (n) => {
    const k = (n + hue / 30) % 12;
    return Math.round(255 * (light - 0.62 * Math.min(light, 1 - light) * Math.max(-1, Math.min(k - 3, 9 - k, 1))));
  };
  return [f(0), f(8), f(4)];
}

// Views whose facets are labelled by something of another name.
const LABELS = { class: "region", points: "region" };

function paintViews() {
  if (!views) return;
  const paint = (view, colourOf) => {
    const cache = new Map(), label = views.mesh[LABELS[view] ?? view], data = new Uint8Array(views.facets * 3);
    label.forEach((value, facet) => {
      if (!cache.has(value)) cache.set(value, colourOf(value));
      data.set(cache.get(value), 3 * facet);
    });
    views.paint(view, data);
  };
  const ofType = (type) => report.shape_types[type + 4]?.colour ?? report.none;
  paint("shape", ofType);
  if (report.measured) {
    paint("unvoted", ofType);
    paint("points", () => report.none);
  }
  paint("initial", (id) => (id < 0 ? report.none : randomColour(id)));
  paint("refined", (id) => (id < 0 ? report.none : randomColour(id)));
  paint("class", (id) => (regionOf.has(id) ? classColour(regionOf.get(id).class) : report.none));
}

async function start3d() {
  const packed = report.mesh, mesh = { edges: {} };
  for (const name of Object.keys(packed)) if (packed[name].data !== undefined) mesh[name] = await unpack(packed[name]);
  mesh.refined = mesh.region;
  for (const name of Object.keys(packed.edges)) mesh.edges[name] = await unpack(packed.edges[name]);
  views = new Views(by("gl"), panels(), mesh, packed.size);
  views.sharpColour = report.sharp_edge.map((x) => x / 255);
  views.onpick = (id) => { if (id >= 0) choose(id); else if (chosen !== null) choose(chosen); };
  paintViews();
  for (const button of document.querySelectorAll("[data-look]")) button.onclick = () => views.look(button.dataset.look);
  by("edges").onchange = (e) => { views.showEdges = e.target.checked; views.ask(); };
  by("wrong").onchange = (e) => {
    const bad = new Set(result.faces.flatMap((face, i) => (face.true_class && face.class !== face.true_class ? [i] : [])));
    views.select(e.target.checked ? (facet) => bad.has(mesh.face[facet]) : null);
  };
  views.draw();
}

// What was measured has no CAD faces, and two views more, as the paper's Fig. 17 has.
function panels() {
  const all = [...document.querySelectorAll(".panel")];
  return report.measured ? all : all.filter((panel) => !panel.hidden);
}

function start() {
  by("views").classList.toggle("six", report.measured);
  about();
  tiles();
  legends();
  regions();
  validation();
  gps();
  const largest = result.regions.reduce((a, b) => (a && a.area >= b.area ? a : b), null);
  if (largest) ranking(largest, " (the largest)");
  const titles = { points: result.mesh.vertices, initial: result.initial_region_count, refined: result.regions.length };
  for (const [i, panel] of panels().entries()) {
    const heading = panel.querySelector("h2"), n = titles[panel.dataset.view];
    if (report.measured && panel.dataset.view === "shape") heading.append(" after voting");
    panel.hidden = false;
    heading.prepend(`${"abcdef"[i]}) `);
    if (n !== undefined) heading.append(` (${n.toLocaleString("en")})`);
    panel.setAttribute("aria-label", `3-D view: ${heading.textContent}`);
  }
  by("clear").onclick = () => { chosen = null; choose(null); };
  by("palette").onchange = (e) => {
    palette = e.target.value;
    legends();
    regions();
    validation();
    gps();
    if (chosen !== null || largest) ranking(regionOf.get(chosen ?? largest.id), chosen === null ? " (the largest)" : "");
    paintViews();
  };
  const asked = /^#region=(\d+)$/.exec(location.hash);
  start3d()
    .catch((error) => { by("fault").textContent = error.message; by("fault").hidden = false; })
    .finally(() => {
      if (asked) choose(Number(asked[1]));
      document.documentElement.dataset.ready = views ? "3d" : "tables";
    });
}

start();
