// What moving grains make of the pore space: sizes of pores and throats, porosities of pore units and of blocks of the box.
import { element, number } from "./dom.js";
import { figure, layout } from "./figure.js";
import { arrows, ramp } from "./section.js";

const colours = ["#d1561b", "#6b7480", "#1f5fa8"], ink = "#1a2330";
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 12, t: 42, b: 48 } };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
/** The driest row has the first colour, the wettest the last. */
function colour(rows, k) {
  const drier = rows.filter((row, j) => row.saturation < rows[k].saturation || (row.saturation === rows[k].saturation && j < k)).length;
  return drier === rows.length - 1 ? colours[2] : colours[drier];
}
const name = (row) => `S = ${row.saturation.toFixed(2)}`;
const sign = (value, digits) => (value > 0 ? "+" : "") + number(value, digits);

/** Corners of the bars, from the ground and back to it. */
function outline({ first, per_unit: perUnit, density }) {
  const x = [first / perUnit], y = [0];
  density.forEach((d, k) => { x.push((first + k) / perUnit, (first + k + 1) / perUnit); y.push(d, d); });
  return { x: [...x, x[x.length - 1]], y: [...y, 0] };
}

/** The mixture's density over the range of the bars. */
function mixture({ first, per_unit: perUnit, density, parts }) {
  const points = 201, low = first / perUnit, high = (first + density.length) / perUnit;
  const x = Array.from({ length: points }, (_, k) => low + ((high - low) * k) / (points - 1));
  const normal = (v, p) => (p.weight / (p.deviation * Math.sqrt(2 * Math.PI))) * Math.exp(-0.5 * ((v - p.mean) / p.deviation) ** 2);
  return { x, y: x.map((v) => parts.reduce((sum, p) => sum + normal(v, p), 0)) };
}

const inWords = (q) => q.parts.map((p) => `${p.mean.toFixed(2)} ± ${p.deviation.toFixed(2)}${q.parts.length > 1 ? ` (${p.weight.toFixed(2)})` : ""}`).join(", ");

function sizes(stage, key, title, symbol, letter, text, count) {
  const rows = stage.pore_space.rows;
  return figure({ name: `pore-space-${key}-${stage.name}`, title, size: "low",
    draw: () => ({ data: rows.flatMap((row, k) => {
      const q = row[key], c = colour(rows, k);
      const bars = { ...outline(q), name: name(row), mode: "lines", line: { color: `${c}66`, width: 1 }, fill: "tozeroy", fillcolor: `${c}14`, showlegend: false, hoverinfo: "skip" };
      const fit = { ...mixture(q), name: name(row), mode: "lines", line: { color: c, width: 2 }, hovertemplate: "%{x:.3f}: %{y:.3f}<extra>%{fullData.name}</extra>" };
      return q.parts.every((p) => p.deviation > 0) ? [bars, fit] : [{ ...bars, showlegend: true }];
    }), layout: layout([symbol, {}], ["Probability density", { rangemode: "tozero" }], above) }),
    series: () => [["row", "saturation", "low", "high", "density"], rows.flatMap((row) => row[key].density.map((d, k) =>
      [row.row, row.saturation, (row[key].first + k) / row[key].per_unit, (row[key].first + k + 1) / row[key].per_unit, d]))],
    caption: caption(count, letter, `${text} Bars: by number; lines: mixtures of normal distributions, mean ± deviation (weight). `,
      rows.map((row) => `${name(row)}: ${inWords(row[key])}`).join("; "), ".") });
}

function locals(stage, count) {
  const { rows, blocks, counts } = stage.pore_space, later = rows.slice(1);
  const of = (row) => blocks[row.row];
  const words = later.map((row) => {
    const { wet, dry, correlation } = of(row);
    const parts = [wet !== null ? `${sign(wet, 2)} where wet` : "", dry !== null ? `${sign(dry, 2)} where dry` : "", correlation !== null ? `rank correlation ${number(correlation, 2)}` : ""];
    return `${name(row)}: ${parts.filter(Boolean).join(", ")}`;
  });
  return figure({ name: `pore-space-local-${stage.name}`, title: "Local change of porosity", size: "low",
    draw: () => ({ data: later.map((row, k) => ({ x: of(row).saturation, y: of(row).porosity_change, name: name(row), mode: "markers",
      marker: { color: colour(rows, k + 1), size: 6, opacity: 0.75, symbol: k === 0 && later.length > 1 ? "circle" : "diamond" }, hovertemplate: "S %{x:.3f}, %{y:+.4f}<extra>%{fullData.name}</extra>" })),
      layout: layout(["Local saturation", { range: [-0.03, 1.03] }], ["Change of local porosity", { zeroline: true, zerolinecolor: ink, zerolinewidth: 1, rangemode: "tozero", exponentformat: "power" }], above) }),
    series: () => [["row", "saturation", "local_saturation", "porosity_change"], later.flatMap((row) => of(row).saturation.map((s, k) => [row.row, row.saturation, s, of(row).porosity_change[k]]))],
    caption: caption(count, "d", `In ${counts.join(" × ")} blocks of the box, since the first row (${name(rows[0])}); wet: above one half. `, words.join("; "), ".") });
}

/** The change of each block that the plane cuts, layer by layer; the mean of two layers where it lies between them. */
function cutBlocks(picture, { counts, blocks }) {
  const axis = "xyz".indexOf(picture.axis), across = (axis + 1) % 3, up = (axis + 2) % 3, n = counts[axis];
  const layers = n % 2 === 1 ? [(n - 1) / 2] : [n / 2 - 1, n / 2];
  const at = (i, j, k) => {
    const block = [];
    block[across] = i, block[up] = j, block[axis] = k;
    return blocks[picture.row].porosity_change[(block[2] * counts[1] + block[1]) * counts[0] + block[0]];
  };
  return { wide: counts[across], high: counts[up], change: (i, j) => layers.reduce((sum, k) => sum + at(i, j, k), 0) / layers.length };
}

const [denser, even, looser] = [[31, 95, 168], [247, 247, 245], [209, 86, 27]];
const shade = (share) => ramp(denser, even, looser, 0.5 * (1 + share));

function drawMap(picture, space, most, longest) {
  const canvas = element("canvas", { role: "img", "aria-label": `change of porosity at S = ${number(picture.saturation, 3)}` });
  const fine = 3, { columns, rows, pixel } = picture, cut = cutBlocks(picture, space);
  canvas.width = fine * columns;
  canvas.height = fine * rows;
  const context = canvas.getContext("2d");
  context.scale(fine, fine);
  for (let i = 0; i < cut.wide; ++i)
    for (let j = 0; j < cut.high; ++j) {
      context.fillStyle = `rgb(${shade(cut.change(i, j) / most)})`;
      context.fillRect((i * columns) / cut.wide, rows - ((j + 1) * rows) / cut.high, columns / cut.wide + 0.3, rows / cut.high + 0.3);
    }
  context.fillStyle = "rgba(255,255,255,0.4)";
  context.strokeStyle = "rgba(26,35,48,0.3)";
  context.lineWidth = 0.5;
  picture.across.forEach((x, k) => {
    context.beginPath();
    context.arc(x / pixel, rows - picture.up[k] / pixel, picture.radius[k] / pixel, 0, 2 * Math.PI);
    context.fill();
    context.stroke();
  });
  arrows(canvas, picture, picture.moved_across, picture.moved_up, longest);
  return canvas;
}

function maps(stage, count) {
  const shown = stage.pictures.filter((p) => p.row > 0), space = stage.pore_space;
  if (shown.length === 0) return null;
  // A tenth of the width: all but few go less far. Grains that nothing holds would rule the scale.
  const ways = shown.flatMap((p) => p.moved_across.map((d, k) => Math.hypot(d, p.moved_up[k]))).sort((a, b) => a - b);
  const far = ways[Math.floor(0.95 * (ways.length - 1))];
  const most = Math.max(...shown.flatMap((p) => { const cut = cutBlocks(p, space); return Array.from({ length: cut.wide * cut.high }, (_, k) => Math.abs(cut.change(k % cut.wide, Math.floor(k / cut.wide)))); }));
  if (!(far > 0 && most > 0)) return null;
  const drawn = shown.map((p) => element("div", {}, drawMap(p, space, most, (20 / 14) * far),
    element("div", { class: "note" }, `S = ${number(p.saturation, 3)}, p`, element("sub", {}, "c"), `* = ${number(p.pc_star, 3)}`)));
  const scale = element("span", { class: "key" }, `−${number(most, 2)} `, element("i", { class: "ramp", style: `background: linear-gradient(to right, rgb(${denser}), rgb(${even}), rgb(${looser}))` }), ` +${number(most, 2)}`);
  return element("figure", { id: `pore-space-map-${stage.name}`, class: "apart" },
    element("div", { class: "figure-head" }, element("h3", {}, "Change of porosity and displacements"), scale),
    element("div", { class: "pictures", style: `--columns: ${Math.max(3, drawn.length)}` }, drawn),
    caption(count, "", `Change of porosity of the blocks in the plane through the middle of the box, across ${stage.pictures[0].axis}, since the first row (${name(space.rows[0])}): blue denser, orange looser. Arrows: displacements of the grains it cuts since then; a tenth of the width is ${number(far * 1e6, 3)} µm.`));
}

/** Section {figures, maps} of one stage. */
export function poreSpaceSection(stage, count) {
  const space = stage.pore_space;
  const figures = [
    sizes(stage, "pore_radius", "Pore radii", "<i>R<sub>i</sub></i>/⟨<i>r</i>⟩", "a", "Pore units over the mean grain radius.", count),
    sizes(stage, "throat_radius", "Throat radii", "<i>r</i><sub>in</sub>/⟨<i>r</i>⟩", "b", "Circles inscribed in the throats, over the mean grain radius.", count),
    sizes(stage, "porosity", "Porosity of pore units", "Porosity", "c", "Void of each pore unit over the volume of its cells.", count)];
  if (space.rows.length === 1 || space.counts.every((n) => n === 1)) return { figures, maps: null };
  return { figures: [...figures, locals(stage, count)], maps: maps(stage, count + 1) };
}
