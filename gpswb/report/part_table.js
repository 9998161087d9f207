// SPDX-License-Identifier: LGPL-2.1-or-later
// Elements, numbers and sortable tables. Text from data goes in by textContent only.
"use strict";

function make(tag, text, attributes = {}) {
  const node = document.createElement(tag);
  if (text !== null && text !== undefined) node.textContent = text;
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  return node;
}

function draw(tag, attributes, text) {
  const node = document.createElementNS("http://www.w3.org/2000/svg", tag);
  for (const [name, value] of Object.entries(attributes)) node.setAttribute(name, value);
  if (text) node.textContent = text;
  return node;
}

const rgb = (colour) => `rgb(${colour.join(",")})`;
const number = (x, digits = 4) => (x === null || x === undefined ? "–" : Number(x.toPrecision(digits)).toString());
const percent = (x) => (x === null || x === undefined ? "–" : x >= 1 ? "100 %" : `${(Math.floor(x * 1e4) / 100).toFixed(2)} %`);

function list(xs) { // rounding errors beside large components are shown as 0
  const most = Math.max(...xs.map(Math.abs));
  return `(${xs.map((x) => (Math.abs(x) < Math.max(1e-9 * most, 1e-7) ? "0" : number(x, 5))).join(", ")})`;
}

function swatched(name, colour) {
  const cell = make("span", null, { class: "named" });
  cell.append(make("span", null, { class: "swatch", style: `background:${rgb(colour)}` }), name);
  return cell;
}

// columns: [heading, row -> string | Node | number, numeric?, row -> sort key]
// onpick(row) is called for a row that is clicked; isChosen(row) marks one.
function table(node, columns, rows, onpick, name, isChosen) {
  node.querySelectorAll("thead,tbody").forEach((part) => part.remove());
  const head = node.createTHead().insertRow(), body = node.createTBody();
  let order = null, up = true;
  const fill = () => {
    body.replaceChildren(...rows.map((row) => {
      const line = make("tr");
      columns.forEach(([, value, numeric], i) => {
        const shown = value(row), cell = make(i ? "td" : "th", null, i ? {} : { scope: "row" });
        cell.append(shown instanceof Node ? shown : String(shown ?? ""));
        if (numeric) cell.className = "n";
        line.append(cell);
      });
      if (onpick) {
        Object.assign(line, { className: "pick", tabIndex: 0, onclick: () => onpick(row) });
        line.onkeydown = (e) => { if (e.key === "Enter" || e.key === " ") { e.preventDefault(); onpick(row); } };
        if (name) {
          line.dataset.region = name(row);
          line.classList.toggle("chosen", isChosen(row));
        }
      }
      return line;
    }));
  };
  columns.forEach(([heading, , numeric, key], i) => {
    const cell = make("th", key ? null : heading, { scope: "col" });
    if (numeric) cell.className = "n";
    if (key) {
      const button = make("button", heading, { type: "button" });
      button.onclick = () => {
        up = order === i ? !up : !numeric;
        order = i;
        rows.sort((a, b) => {
          const [x, y] = [key(a), key(b)];
          return (x < y ? -1 : x > y ? 1 : 0) * (up ? 1 : -1);
        });
        for (const other of head.cells) other.removeAttribute("aria-sort");
        cell.setAttribute("aria-sort", up ? "ascending" : "descending");
        fill();
      };
      cell.append(button);
    }
    head.append(cell);
  });
  fill();
}
