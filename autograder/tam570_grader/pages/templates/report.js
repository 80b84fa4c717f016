"use strict";
// Sorts the tables by their headings and filters their rows; the page is complete without it.
const key = (row, column) => {
  const cell = row.cells[column];
  return cell.dataset.value ?? cell.textContent.trim();
};

const alphabet = new Intl.Collator(undefined, { numeric: true }); // hw2 before hw10

const numeric = (rows, column) => rows.every((row) => /^(-?[\d.]+(e[-+]?\d+)?)?$/.test(key(row, column)));

function sort(button) {
  const heading = button.closest("th"), table = heading.closest("table"), body = table.tBodies[0];
  const column = heading.cellIndex, rows = [...body.rows];
  const before = heading.getAttribute("aria-sort");
  const numbers = numeric(rows, column);
  const first = numbers ? "descending" : "ascending"; // of numbers, the largest first
  const order = before === "none" ? first : before === "ascending" ? "descending" : "ascending";
  for (const other of table.tHead.rows[0].cells) if (other.hasAttribute("aria-sort")) other.setAttribute("aria-sort", "none");
  heading.setAttribute("aria-sort", order);
  const sign = order === "ascending" ? 1 : -1;
  const decorated = rows.map((row, index) => [key(row, column), index, row]);
  decorated.sort(([a, i], [b, j]) => {
    if (a === "" || b === "") return (a === "") - (b === "") || i - j; // what is missing comes last
    return sign * (numbers ? a - b : alphabet.compare(a, b)) || i - j;
  });
  body.append(...decorated.map(([, , row]) => row));
  say(`sorted by ${button.textContent.trim()}, ${order}`);
}

const say = (text) => { document.getElementById("said").textContent = text; };

const texts = new WeakMap(); // of rows, in lower case
const text = (row) => {
  if (!texts.has(row)) texts.set(row, row.textContent.toLowerCase());
  return texts.get(row);
};

function filter() {
  const words = document.getElementById("words").value.toLowerCase().split(/\s+/).filter(Boolean);
  const slug = document.getElementById("assignment").value;
  let shown = 0, all = 0;
  for (const row of document.querySelectorAll("tbody tr")) {
    const fits = (!slug || !row.dataset.slug || row.dataset.slug === slug) && words.every((word) => text(row).includes(word));
    row.hidden = !fits;
    shown += fits;
    all += 1;
  }
  for (const section of document.querySelectorAll("section")) {
    const rows = [...section.querySelectorAll("tbody tr")];
    const none = section.querySelector(".none");
    if (none) none.hidden = !rows.length || rows.some((row) => !row.hidden);
  }
  say(`${shown} of ${all} rows`);
}

for (const button of document.querySelectorAll("th button")) button.addEventListener("click", () => sort(button));
document.getElementById("words").addEventListener("input", filter);
document.getElementById("assignment").addEventListener("change", filter);
document.getElementById("filter").addEventListener("submit", (event) => event.preventDefault());
document.getElementById("filter").addEventListener("reset", () => setTimeout(filter));
document.getElementById("filter").hidden = false;
