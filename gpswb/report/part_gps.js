// SPDX-License-Identifier: LGPL-2.1-or-later
// GPS features, datum systems and specifications, where the report holds them.
"use strict";

const SIGNS = { diameter: "Ø", "spherical diameter": "SØ", width: "width ", "cone angle": "angle " };
let feature = null; // the feature selected

// Symbols of ISO 1101 in a box of 16 × 16: few fonts have them all.
const SYMBOLS = {
  straightness: "M1 8H15", flatness: "M5 4H15L11 12H1Z", roundness: "M8 3a5 5 0 0 1 0 10a5 5 0 0 1 0-10",
  cylindricity: "M8 4.5a3.5 3.5 0 0 1 0 7a3.5 3.5 0 0 1 0-7M2 14L7 2M9 14L14 2",
  "line profile": "M2 12A6 6 0 0 1 14 12", "surface profile": "M2 12A6 6 0 0 1 14 12Z",
  parallelism: "M3 14L8 2M8 14L13 2", perpendicularity: "M8 2V13M2 13H14", angularity: "M14 4L2 13H15",
  position: "M8 3.5a4.5 4.5 0 0 1 0 9a4.5 4.5 0 0 1 0-9M8 1V15M1 8H15",
  concentricity: "M8 2a6 6 0 0 1 0 12a6 6 0 0 1 0-12M8 5a3 3 0 0 1 0 6a3 3 0 0 1 0-6",
  coaxiality: "M8 2a6 6 0 0 1 0 12a6 6 0 0 1 0-12M8 5a3 3 0 0 1 0 6a3 3 0 0 1 0-6",
  symmetry: "M1 8H15M4 4.5H12M4 11.5H12", "circular run-out": "M3 14L12 3M7 4.5L12 3L11.5 8",
  "total run-out": "M2 12L8 4M9 12L15 4M2 12H9M4.5 5L8 4L7.5 8M11.5 5L15 4L14.5 8",
};

function withSymbol(characteristic, text) {
  const cell = make("span", null, { class: "indication" });
  const icon = draw("svg", { viewBox: "0 0 16 16", class: "symbol", role: "img", "aria-label": characteristic });
  icon.append(draw("path", { d: SYMBOLS[characteristic] }));
  cell.append(icon, ` ${text}`);
  return cell;
}

function sizeText(f) {
  if (!f.size) return "";
  const count = f.intrinsic.count ? `${f.intrinsic.count} × ` : "";
  return `${count}${SIGNS[f.size.kind]}${number(f.size.value, 6)}${f.size.kind === "cone angle" ? "°" : ""}`;
}

const spaced = (datums) => (datums ? ` | ${datums.replaceAll("|", " | ")}` : "");
const indication = (row) => withSymbol(row.characteristic, `${row.prefix}${row.value}${spaced(row.datums)}`);
const mark = (f) => (f ? `feature ${f.id}` : null);
const named = (doc, ids) => ids.map((id) => doc.features[id].name).join(", ");

function chooseFeature(doc, f) {
  feature = feature === f ? null : f;
  chosen = null;
  by("wrong").checked = false;
  for (const line of document.querySelectorAll("tr.pick")) line.classList.toggle("chosen", line.dataset.region === mark(feature));
  const regions = new Set(f.regions);
  views?.select(feature === null ? null : (facet) => regions.has(views.mesh.region[facet]));
  permitted(doc, f);
}

function permitted(doc, f) {
  by("permitted-title").textContent = `Permitted specifications: ${f.name}`;
  by("permitted-note").textContent = `${[f.class, sizeText(f), f.derived].filter(Boolean).join(", ")}. Values are yours to give: "?" stands for them.`;
  table(by("permitted"), [
    ["characteristic", (row) => withSymbol(row.characteristic, row.characteristic)],
    ["status", (row) => make("span", row.status, { class: row.status.replaceAll(" ", "-") })],
    ["indication", (row) => (row.status === "not allowed" ? "" : indication(row))],
    ["datum", (row) => row.datum],
    ["modifiers", (row) => row.modifiers.join(" ") + (row.combination ? ` ${row.combination}` : "")],
    ["tolerance zone", (row) => (row.status === "not allowed" ? "" : row.zone)],
    ["why", (row) => row.reason],
  ], doc.permitted[f.id]);
}

function features(doc) {
  const letters = new Map();
  for (const datum of doc.datum_system?.datums ?? []) for (const id of datum.features) letters.set(id, datum.letter);
  const bodies = new Set(doc.features.map((f) => f.body)).size > 1;
  const best = (f) => doc.permitted[f.id].find((row) => row.status === "recommended");
  by("features-title").textContent = `GPS features (${doc.features.length})`;
  const columns = [
    ["feature", (f) => f.name, false, (f) => f.id],
    ["class", (f) => swatched(f.class === null ? "none" : f.class + (f.sure ? "" : " ?"), classColour(f.class)), false, (f) => f.class ?? "~"],
    ["size", sizeText, true, (f) => f.size?.value ?? -1],
    ["side", (f) => (f.material === "neither" ? "" : f.material), false, (f) => f.material],
    ["derived feature", (f) => f.derived, false, (f) => f.derived],
    ["situation feature", situation],
    ["intrinsic", (f) => intrinsic(f) + (f.arrangement ? `, ${f.arrangement}` : "")],
    ["area mm²", (f) => number(f.area, 6), true, (f) => f.area],
    ["datum", (f) => letters.get(f.id) ?? "", false, (f) => letters.get(f.id) ?? "~"],
    ["recommended", (f) => (best(f) ? indication(best(f)) : ""), false, (f) => best(f)?.characteristic ?? "~"],
    ["made of", (f) => named(doc, f.members) || f.faces.join(" ")],
  ];
  if (bodies) columns.splice(1, 0, ["body", (f) => f.body + 1, true, (f) => f.body]);
  table(by("features"), columns, [...doc.features], (f) => chooseFeature(doc, f), mark, (f) => f === feature);
}

function systems(doc) {
  const found = doc.datums_given ? [["Datum system", doc.datum_system]] : [];
  doc.suggestions.forEach((system, i) => found.push([i ? "Runner-up" : "Suggested datum system", system]));
  by("systems").replaceChildren(...found.flatMap(([title, system]) => {
    const lines = make("ul");
    lines.append(...system.explanation.split("\n").map((line) => make("li", line)));
    return [make("h3", `${title} ${system.notation.replaceAll("|", " | ")}`), lines];
  }));
  if (!found.length) by("systems").replaceChildren(make("p", "No feature can serve as a datum."));
}

function given(doc) {
  table(by("specified"), [
    ["feature", (row) => doc.features[row.feature].name],
    ["indication", (row) => (SYMBOLS[row.characteristic] ? withSymbol(row.characteristic, row.indication.replace(/^\S+ /, "")) : row.indication)],
    ["remark", (row) => row.remark],
  ], doc.specified);
  by("specified-card").hidden = !doc.specified.length;
  table(by("review"), [
    ["datum or tolerance", (row) => {
      const words = row.subject.replace(/^\S /, ""); // the symbol is drawn
      const name = Object.keys(SYMBOLS).find((key) => words.startsWith(key));
      return name ? withSymbol(name, words) : row.subject;
    }],
    ["on", (row) => row.features.join(", ")],
    ["class", (row) => (row.class ? swatched(row.class, classColour(row.class)) : "")],
    ["remark", (row) => row.text],
  ], doc.review);
  by("review-card").hidden = !doc.review.length;
}

function gps() {
  const doc = report.features;
  for (const node of document.querySelectorAll("[data-gps]")) node.hidden = !doc;
  if (!doc) return;
  features(doc);
  systems(doc);
  given(doc);
  const first = feature ?? doc.features[0];
  by("permitted-card").hidden = !first;
  if (first) permitted(doc, first);
}
