// Swelling grains: their size, what it does to the packing, and what grains carry, in time.
import { element, number } from "./dom.js";
import { figure, layout } from "./figure.js";

const blue = "#1f5fa8", green = "#168a83", orange = "#d1561b", violet = "#7a4a80";
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 56, t: 42, b: 48 } };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
const line = (x, y, name, color, more = {}) => ({ x, y, name, mode: "lines", line: { color, width: 1.8 }, hovertemplate: "%{x:.4~g}, %{y:.5~g}<extra>%{fullData.name}</extra>", ...more });
const band = (x, low, high, name, color) => [line(x, low, name, color, { line: { width: 0 }, showlegend: false, hoverinfo: "skip" }),
  line(x, high, name, color, { line: { width: 0 }, fill: "tonexty", fillcolor: `${color}33`, hoverinfo: "skip" })];
const milli = (values) => values.map((v) => v * 1e3);
const table = (s, keys) => [keys, s.time.map((_, k) => keys.map((key) => s[key][k]))];

function radii(stage, s, count) {
  const t = milli(s.time);
  return figure({ name: `swelling-radius-${stage.name}`, title: "Swelling grains", size: "low",
    draw: () => ({ data: [...band(t, milli(s.radius_least), milli(s.radius_most), "least to most", blue), line(t, milli(s.radius_mean), "mean radius", blue),
      line(t, s.wetted, "wetted share", orange, { yaxis: "y2", line: { color: orange, width: 1.4, dash: "4px,3px" } })],
      layout: layout(["Time (ms)", { rangemode: "tozero" }], ["Radius (mm)", {}], { ...above, yaxis2: { overlaying: "y", side: "right", range: [0, 1.05], title: { text: "Wetted share" }, showgrid: false } }) }),
    series: () => table(s, ["time", "radius_mean", "radius_least", "radius_most", "wetted", "grown", "from_pores", "from_reservoirs"]),
    caption: caption(count, "a", `Mean radius and its bounds; share of the surface that is wetted. Water taken up: ${number(s.grown.at(-1), 4)} m³.`) });
}

function packing(stage, s, count) {
  const t = milli(s.time);
  return figure({ name: `swelling-porosity-${stage.name}`, title: "Porosity and saturation", size: "low",
    draw: () => ({ data: [line(t, s.porosity, "porosity", green), line(t, s.saturation, "saturation", blue, { yaxis: "y2", line: { color: blue, width: 1.4, dash: "4px,3px" } })],
      layout: layout(["Time (ms)", { rangemode: "tozero" }], ["Porosity", {}], { ...above, yaxis2: { overlaying: "y", side: "right", range: [0, 1.05], title: { text: "Saturation" }, showgrid: false } }) }),
    series: () => table(s, ["time", "porosity", "saturation"]), caption: caption(count, "b", "Of the box.") });
}

function deviator(stage, s, count) {
  const t = milli(s.time), low = s.q_mean.map((q, k) => Math.max(0, q - s.q_deviation[k])), high = s.q_mean.map((q, k) => q + s.q_deviation[k]);
  return figure({ name: `swelling-deviator-${stage.name}`, title: "Deviatoric stress of the grains", size: "low",
    draw: () => ({ data: [...band(t, low, high, "standard deviation", violet), line(t, s.q_mean, "mean", violet)],
      layout: layout(["Time (ms)", { rangemode: "tozero" }], ["<i>q</i> of a grain (Pa)", { rangemode: "tozero" }], above) }),
    series: () => table(s, ["time", "q_mean", "q_deviation"]), caption: caption(count, "c", "Of each grain on its power cell.") });
}

function stressPath(stage, s, count) {
  return figure({ name: `swelling-path-${stage.name}`, title: "Stress path", size: "low",
    draw: () => ({ data: [line(s.p, s.q, "contacts", orange, { mode: "lines+markers", marker: { color: orange, size: 4 } })],
      layout: layout(["<i>p</i> of the contacts (Pa)", {}], ["<i>q</i> of the contacts (Pa)", {}], { showlegend: false }) }),
    series: () => table(s, ["time", "p", "q"]), caption: caption(count, "d", "Mean and deviatoric stress of all contacts.") });
}

/** Figures of a stage in which grains swell. */
export function swellingFigures(stage, count) {
  return [radii, packing, deviator, stressPath].map((draw) => draw(stage, stage.swelling, count));
}
