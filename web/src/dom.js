// Small helpers that build the page. Text always enters as text, never as markup.

export function element(name, options = {}, ...children) {
  const node = document.createElement(name);
  for (const [key, value] of Object.entries(options)) {
    if (key === "class") node.className = value;
    else if (key === "on") for (const [type, action] of Object.entries(value)) node.addEventListener(type, action);
    else node.setAttribute(key, value);
  }
  node.append(...children.flat(Infinity).filter((child) => child !== null && child !== undefined));
  return node;
}

/** "p_c at S_r" with its indices lowered; for our own labels, not for a user's words. */
export function label(text) {
  const parts = document.createDocumentFragment();
  text.split(/(\b[A-Za-zα]_[a-z]{1,2}(?![A-Za-z]))/).forEach((part, k) => {
    if (k % 2 === 0) return parts.append(part);
    const [symbol, index] = part.split("_");
    parts.append(element("var", {}, symbol), element("sub", {}, index));
  });
  return parts;
}

const narrow = "\u202f";
const superscripts = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** A number as a person reads it: 0.3402, 12 345, 2.1 × 10⁻¹⁴, or a dash where there is none. */
export function number(value, digits = 4) {
  if (value === null || value === undefined || !Number.isFinite(value)) return "–";
  if (value === 0) return "0";
  const size = Math.abs(value);
  if (size < 1e-3 || size >= 1e7) {
    const [mantissa, exponent] = value.toExponential(Math.min(digits - 1, 2)).split("e");
    const power = String(Number(exponent)).replace(/./g, (c) => superscripts[c]);
    return `${mantissa.replace("-", "−")}${narrow}×${narrow}10${power}`;
  }
  const decimals = Math.max(0, digits - 1 - Math.floor(Math.log10(size)));
  const [whole, rest] = size.toFixed(decimals).split(".");
  const grouped = whole.length > 4 ? whole.replace(/\B(?=(\d{3})+$)/g, narrow) : whole;
  return (value < 0 ? "−" : "") + grouped + (rest ? `.${rest}` : "");
}

/** columns: {head, number?: true}; each cell is a text, a node, or {text, class}. */
export function table(caption, columns, rows, name = "") {
  const cell = (content, column) => {
    const options = { class: column.number ? "number" : "" };
    if (content && typeof content === "object" && !(content instanceof Node)) {
      options.class += ` ${content.class}`;
      content = content.text;
    }
    return element("td", options, content);
  };
  const head = columns.some((column) => column.head)
    ? element("thead", {}, element("tr", {}, columns.map((c) => element("th", { scope: "col", class: c.number ? "number" : "" }, c.head))))
    : null;
  return element("div", { class: "scroll" },
    element("table", { class: name }, caption ? element("caption", {}, caption) : null, head,
      element("tbody", {}, rows.map((row) => element("tr", {}, row.map((content, k) => cell(content, columns[k])))))));
}

export function download(name, text, type = "text/csv") {
  const link = element("a", { href: URL.createObjectURL(new Blob([text], { type })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** Rows as CSV; fields with a comma or a quote are quoted. */
export function csv(header, rows) {
  const field = (value) => (/[",\n]/.test(String(value)) ? `"${String(value).replaceAll('"', '""')}"` : String(value ?? ""));
  return [header, ...rows].map((row) => row.map(field).join(",")).join("\n") + "\n";
}
