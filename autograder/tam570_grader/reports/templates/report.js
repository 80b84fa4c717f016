"use strict";
// Sorts the tables by their headings, filters their rows, shows a page of them at a time and links scores and names to
// the feedback; without it the page has all its rows, and no links in them.
const PAGE = 100; // rows
const say = (text) => { document.getElementById("said").textContent = text; };
const make = (name, text) => Object.assign(document.createElement(name), { textContent: text });

const key = (row, column) => {
  const cell = row.cells[column];
  return cell.dataset.value ?? cell.textContent.trim();
};

const alphabet = new Intl.Collator(undefined, { numeric: true }); // hw2 before hw10

const numeric = (rows, column) => rows.every((row) => /^(-?[\d.]+(e[-+]?\d+)?)?$/.test(key(row, column)));

const texts = new WeakMap(); // of rows, in lower case
const text = (row) => {
  if (!texts.has(row)) texts.set(row, row.textContent.toLowerCase());
  return texts.get(row);
};

const feedback = (student, slug, shown) => {
  const link = make("a", shown);
  link.href = `feedback/${encodeURIComponent(student)}/${slug}.html`;
  return link;
};

// A table: all its rows in their order, those that fit the filter, and where its page begins.
class Table {
  constructor(table) {
    this.body = table.tBodies[0];
    this.head = [...table.tHead.rows[0].cells];
    this.none = table.closest("section").querySelector(".none");
    this.rows = [...this.body.rows];
    this.fitting = this.rows;
    this.start = 0;
    this.linked = new WeakSet();
    this.makePager(table.closest(".wide"));
    for (const button of table.querySelectorAll("th button")) button.addEventListener("click", () => this.sort(button));
  }

  makePager(place) {
    this.pager = make("p", "");
    this.pager.className = "pager";
    const [back, on] = [make("button", "Previous"), make("button", "Next")];
    this.place = make("span", "");
    this.pager.append(back, this.place, on);
    this.buttons = { back, on };
    for (const [button, step] of [[back, -PAGE], [on, PAGE]]) {
      button.type = "button";
      button.addEventListener("click", () => { this.show(this.start + step); place.scrollTop = 0; });
    }
    place.after(this.pager);
  }

  show(start, count = PAGE) {
    this.start = start;
    const page = this.fitting.slice(start, start + count), all = this.fitting.length;
    for (const row of page) this.link(row);
    this.body.replaceChildren(...page);
    this.pager.hidden = all <= count;
    this.place.textContent = `rows ${start + 1} to ${start + page.length} of ${all}`;
    this.buttons.back.disabled = start === 0;
    this.buttons.on.disabled = start + count >= all;
    if (this.none) this.none.hidden = !this.rows.length || all > 0;
  }

  link(row) {
    if (this.linked.has(row)) return;
    this.linked.add(row);
    for (const names of row.querySelectorAll(".who")) {
      names.closest("details").addEventListener("toggle", () => {
        const links = names.textContent.split(",\n").flatMap((name) => [feedback(name, row.dataset.slug, name), ", "]);
        names.replaceChildren(...links.slice(0, -1));
      }, { once: true });
    }
    for (const [column, heading] of this.head.entries()) {
      const cell = row.cells[column];
      if (heading.dataset.slug && cell.textContent) {
        cell.replaceChildren(feedback(row.cells[0].textContent, heading.dataset.slug, cell.textContent));
      }
    }
  }

  filter(fits) {
    this.fitting = this.rows.filter(fits);
    this.show(0);
  }

  sort(button) {
    const heading = button.closest("th"), column = heading.cellIndex, before = heading.getAttribute("aria-sort");
    const numbers = numeric(this.rows, column);
    const first = numbers ? "descending" : "ascending"; // of numbers, the largest first
    const order = before === "none" ? first : before === "ascending" ? "descending" : "ascending";
    for (const other of this.head) if (other.hasAttribute("aria-sort")) other.setAttribute("aria-sort", "none");
    heading.setAttribute("aria-sort", order);
    const sign = order === "ascending" ? 1 : -1;
    const decorated = this.rows.map((row, index) => [key(row, column), index, row]);
    decorated.sort(([a, i], [b, j]) => {
      if (a === "" || b === "") return (a === "") - (b === "") || i - j; // what is missing comes last
      return sign * (numbers ? a - b : alphabet.compare(a, b)) || i - j;
    });
    const fitting = new Set(this.fitting);
    this.rows = decorated.map(([, , row]) => row);
    this.filter((row) => fitting.has(row));
    say(`sorted by ${button.textContent.trim()}, ${order}`);
  }
}

const tables = [...document.querySelectorAll("table")].map((table) => new Table(table));

function filter() {
  const words = document.getElementById("words").value.toLowerCase().split(/\s+/).filter(Boolean);
  const slug = document.getElementById("assignment").value;
  for (const table of tables) {
    table.filter((row) => {
      const fits = !slug || !row.dataset.slug || row.dataset.slug === slug;
      return fits && words.every((word) => text(row).includes(word));
    });
  }
  const count = (kind) => tables.reduce((sum, table) => sum + table[kind].length, 0);
  say(`${count("fitting")} of ${count("rows")} rows`);
}

for (const table of tables) table.show(0);
window.addEventListener("beforeprint", () => tables.forEach((table) => table.show(0, table.rows.length)));
window.addEventListener("afterprint", () => tables.forEach((table) => table.show(0)));
document.getElementById("words").addEventListener("input", filter);
document.getElementById("assignment").addEventListener("change", filter);
document.getElementById("filter").addEventListener("submit", (event) => event.preventDefault());
document.getElementById("filter").addEventListener("reset", () => setTimeout(filter));
document.getElementById("filter").hidden = false;
