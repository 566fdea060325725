// What contacts, liquid bridges and fluids carry as a packing is wetted or dries, and what becomes of it.
import { element, number } from "./dom.js";
import { figure, layout } from "./figure.js";

const blue = "#1f5fa8", green = "#168a83", orange = "#d1561b", violet = "#7a4a80";
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 84, t: 42, b: 48 } };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
const saturation = ["Saturation <i>S</i><sub>r</sub>", { range: [-0.02, 1.04] }];
const dashes = ["solid", "5px,3px", "2px,3px", "8px,3px,2px,3px"];
const line = (x, y, name, color, more = {}) => ({ x, y, name, mode: "lines+markers", line: { color, width: 1.8 }, marker: { color, size: 5 }, hovertemplate: "%{x:.4~g}, %{y:.4~g}<extra>%{fullData.name}</extra>", ...more });
const named = (stage, b, name) => (stage.branches.length > 1 ? `${name}, ${b.name}` : name);
const table = (stage, keys) => [["branch", ...keys], stage.branches.flatMap((b) => b.saturation.map((_, k) => [b.name, ...keys.map((key) => b[key][k])]))];

/** Shares of the stress that grow far apart are drawn beside each other: what contacts carry has its own axis. */
function stresses(stage, count) {
  return figure({ name: `collapse-stress-${stage.name}`, title: "Who carries the stress", size: "low",
    draw: () => ({ data: stage.branches.flatMap((b, k) => [
      line(b.saturation, b.stress_bridges, named(stage, b, "bridges"), orange, { line: { color: orange, width: 1.8, dash: dashes[k] } }),
      line(b.saturation, b.stress_fluids, named(stage, b, "fluids"), blue, { line: { color: blue, width: 1.8, dash: dashes[k] } }),
      line(b.saturation, b.contact_mean, named(stage, b, "contacts"), green, { yaxis: "y2", line: { color: green, width: 1.4, dash: dashes[k] } })]),
      layout: layout(saturation, ["Stress of bridges, fluids (Pa)", {}], { ...above, yaxis2: { overlaying: "y", side: "right", title: { text: "Contacts (Pa)" }, showgrid: false } }) }),
    series: () => table(stage, ["pc", "saturation", "contact_mean", "stress_bridges", "stress_fluids"]),
    caption: caption(count, "a", "Mean of the three axes, compression positive; the three add up to what the walls hold.") });
}

function volumes(stage, count) {
  const last = stage.branches.at(-1);
  return figure({ name: `collapse-volume-${stage.name}`, title: "Volume", size: "low",
    draw: () => ({ data: stage.branches.map((b, k) => line(b.saturation, b.volume_strain, b.name, violet, { line: { color: violet, width: 1.8, dash: dashes[k] } })),
      layout: layout(saturation, ["Volumetric strain, shrinking positive", { exponentformat: "power" }], { ...above, showlegend: stage.branches.length > 1 }) }),
    series: () => table(stage, ["pc", "saturation", "volume_strain", "porosity"]),
    caption: caption(count, "b", `Of the box, since rest at the first pressure. Porosity ${number(stage.branches[0].porosity[0], 4)} at first, ${number(last.porosity.at(-1), 4)} at last.`) });
}

function bridges(stage, count) {
  return figure({ name: `collapse-bridges-${stage.name}`, title: "Liquid bridges", size: "low",
    draw: () => ({ data: stage.branches.flatMap((b, k) => [
      line(b.saturation, b.bridges, named(stage, b, "number"), orange, { line: { color: orange, width: 1.8, dash: dashes[k] } }),
      line(b.saturation, b.bridge_force.map((f, n) => (b.bridges[n] > 0 ? f * 1e6 : null)), named(stage, b, "mean force"), green, { yaxis: "y2", line: { color: green, width: 1.4, dash: dashes[k] } })]),
      layout: layout(saturation, ["Bridges", { rangemode: "tozero" }], { ...above, yaxis2: { overlaying: "y", side: "right", rangemode: "tozero", title: { text: "Mean attraction (µN)" }, showgrid: false } }) }),
    series: () => table(stage, ["pc", "saturation", "bridges", "bridge_force", "bridge_saturation"]),
    caption: caption(count, "c", "Between grains, and grains and walls; pores that fill take in those around them.") });
}

/** Figures of a stage in which liquid bridges stand between dry pores. */
export function collapseFigures(stage, count) {
  return [stresses, volumes, bridges].map((draw) => draw(stage, count));
}
