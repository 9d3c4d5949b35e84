// A point of a picture says what it is: the nearest to the pointer or the finger.
const tip = document.body.appendChild(document.createElement("div"));
tip.id = "tip";
tip.hidden = true;
const reach = 28;  // CSS pixels
let shown = null;
function show(point, x, y) {
  if (shown) shown.classList.remove("is-shown");
  shown = point;
  tip.hidden = !point;
  if (!point) return;
  point.classList.add("is-shown");
  tip.textContent = point.dataset.text;
  const left = Math.min(x + 14, document.documentElement.clientWidth - tip.offsetWidth - 8);
  tip.style.left = Math.max(8, left) + scrollX + "px";
  tip.style.top = y + 18 + scrollY + "px";
}
for (const svg of document.querySelectorAll("figure svg")) {
  const points = [...svg.querySelectorAll(".point")];
  if (!points.length) continue;
  for (const point of points) {  // in place of the browser's own, slower tip
    point.dataset.text = point.querySelector("title").textContent;
    point.querySelector("title").remove();
  }
  const find = (event) => {
    let nearest = null, least = reach;
    for (const point of points) {
      const box = point.getBoundingClientRect();
      const away = Math.hypot(box.x + box.width / 2 - event.clientX, box.y + box.height / 2 - event.clientY);
      if (away < least) [nearest, least] = [point, away];
    }
    show(nearest, event.clientX, event.clientY);
  };
  svg.addEventListener("pointermove", find);
  svg.addEventListener("pointerdown", find);
  svg.addEventListener("pointerleave", (event) => event.pointerType === "mouse" && show(null));
}

// A table is sorted by the column whose head is pressed; a number counts as one.
function value(row, column) {
  const cell = row.cells[column];
  if (!cell) return "";
  const text = cell.dataset.value ?? cell.textContent;
  const number = parseFloat(text);
  return Number.isNaN(number) ? text : number;
}
function compare(a, b) {
  if (typeof a === "number" && typeof b === "number") return a - b;
  if (typeof a !== typeof b) return typeof a === "number" ? -1 : 1;
  return a.localeCompare(b);
}
for (const table of document.querySelectorAll("table.sortable")) {
  const heads = [...table.tHead.rows[0].cells];
  heads.forEach((head, column) => {
    const button = document.createElement("button");
    button.type = "button";
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const direction = head.getAttribute("aria-sort") === "ascending" ? -1 : 1;
      heads.forEach((other) => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
      const rows = [...table.tBodies[0].rows];
      rows.sort((a, b) => direction * compare(value(a, column), value(b, column)));
      table.tBodies[0].append(...rows);
    });
  });
}

// What to choose: the answers are the report's, one for each stop, part, rate and stiffness.
const choices = JSON.parse(document.getElementById("choices").textContent);
const form = document.querySelector("form.choose");
function fill(name, texts, selected) {
  texts.forEach((text, i) => form.elements[name].add(new Option(text, i, i === selected, i === selected)));
}
const names = {1000: "1 kHz", 2000: "2 kHz", 5000: "5 kHz", 10000: "10 kHz", 20000: "20 kHz", 50000: "50 kHz"};
fill("part", choices.parts.map(([target, part]) => `${part} (${target})`), 2);
fill("rate", choices.rates.map((rate) => names[rate] ?? rate + " Hz"), choices.rates.indexOf(10000));
fill("stiffness", choices.stiffnesses.map((k) => {
  const text = k.toExponential().replace("e+", "e");
  const note = {"3.2e4": "the paper's", "1e10": "like steel"}[text];
  return note ? `${text} (${note})` : text;
}), 3);
function answer() {
  const of = (name) => Number(form.elements[name].value);
  const {parts, rates, stiffnesses, answers, index} = choices;
  const at = ((of("stop") * parts.length + of("part")) * rates.length + of("rate")) * stiffnesses.length + of("stiffness");
  const [law, stepper, format, instructions, time, share, error, flash, ram, stack] = answers[index[at]];
  const rows = stepper === undefined ? [["Answer", law]] : [
    ["Law", law], ["Stepper", stepper], ["Format", format],
    ["Largest step seen", `${instructions} instructions, about ${time} µs: ${share} % of the period`],
    ["Restitution", `right within ${error.replace("below ", "")}`],
    ...(flash ? [["Memory", `${flash} bytes of flash, ${ram} of RAM, ${stack} of stack`]] : [])];
  const list = form.querySelector("dl");
  list.replaceChildren(...rows.flatMap(([name, text]) => {
    const term = document.createElement("dt"), description = document.createElement("dd");
    term.textContent = name;
    description.textContent = text;
    return [term, description];
  }));
  form.querySelector("code").textContent =
    stepper === undefined ? "" : `impact::Absorber<Rig, impact::${law}, impact::${stepper}, impact::Sine, impact::${format}>`;
}
form.addEventListener("change", answer);
form.addEventListener("submit", (event) => event.preventDefault());
answer();
