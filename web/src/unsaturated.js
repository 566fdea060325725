// Two fluids and grains that move each other: retention, strain, effective stress and forces against capillary pressure.
import { element, number } from "./dom.js";
import { figure, layout } from "./figure.js";

const colours = ["#1f5fa8", "#168a83", "#d1561b", "#7a4a80"], ink = "#1a2330", grey = "#8a939d";
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 12, t: 42, b: 48 } };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
const hover = "%{x:.4~g}, %{y:.4~g}<extra>%{fullData.name}</extra>";
const curve = (x, y, name, color, more = {}) => ({ x, y, name, mode: "lines+markers", line: { color, width: 1.8 }, marker: { color, size: 5 }, hovertemplate: hover, ...more });
const plain = (x, y, name, color, dash) => ({ x, y, name, mode: "lines", line: { color, width: 1.2, dash }, hoverinfo: "skip" });
const star = "Capillary pressure <i>p</i><sub>c</sub>⟨<i>r</i>⟩/γ";
const colour = (k) => colours[k % colours.length];
const rows = (stage, ...keys) => [["branch", ...keys], stage.branches.flatMap((b) => b.pc_star.map((_, k) => [b.name, ...keys.map((key) => b[key][k])]))];

function regimes(stage) {
  const drainage = stage.branches.find((b) => b.regimes);
  if (!drainage) return { shapes: [], text: "" };
  const { air_entry: entry, pendular } = drainage.regimes;
  const shapes = [entry, pendular].map((x) => ({ type: "line", x0: x, x1: x, yref: "paper", y0: 0, y1: 1, line: { color: grey, width: 1, dash: "4px,3px" } }));
  return { shapes, text: ` Dashed: the steepest tangent of the first drainage meets full saturation at ${number(entry, 3)} and its last saturation at ${number(pendular, 3)}.` };
}

function retention(stage, count) {
  const { shapes, text } = regimes(stage);
  return figure({ name: `unsaturated-retention-${stage.name}`, title: "Retention", size: "low",
    draw: () => ({ data: stage.branches.map((b, k) => curve(b.pc_star, b.saturation, b.name, colour(k))),
      layout: layout([star, { rangemode: "tozero" }], ["Saturation <i>S</i><sub>r</sub>", { range: [-0.02, 1.04] }], { ...above, shapes }) }),
    series: () => rows(stage, "pc", "pc_star", "saturation"), caption: caption(count, "a", `Equilibria of grains and fluids.${text}`) });
}

function strain(stage, count) {
  return figure({ name: `unsaturated-strain-${stage.name}`, title: "Strain", size: "low",
    draw: () => ({ data: stage.branches.map((b, k) => curve(b.pc_star, b.strain, b.name, colour(k))),
      layout: layout([star, { rangemode: "tozero" }], [`Strain along ${stage.axis}`, { exponentformat: "power" }], { ...above, shapes: regimes(stage).shapes }) }),
    series: () => rows(stage, "pc_star", "strain", "volume_strain"), caption: caption(count, "b", "Shortening is positive; from rest at the first pressure.") });
}

function bishop(stage, count) {
  const fits = stage.branches.filter((b) => b.fit);
  const lines = fits.map((b) => { const k = stage.branches.indexOf(b); return plain([0, 1], [b.fit.offset, b.fit.offset + b.fit.slope], `fit, ${b.name}`, colour(k), "2px,3px"); });
  const text = fits.map((b) => `${b.name}: χ = ${number(b.fit.offset, 3)} + ${number(b.fit.slope, 3)} S within ${number(b.fit.residual, 2)}, from χ = S ${number(b.fit.from_saturation, 2)}`).join("; ");
  return figure({ name: `unsaturated-chi-${stage.name}`, title: "Bishop's coefficient", size: "low",
    draw: () => ({ data: [...stage.branches.flatMap((b, k) => [
        curve(b.saturation, b.chi_contact, b.name, colour(k), { mode: "markers" }),
        curve(b.saturation, b.chi_fluid, `${b.name}, fluids`, colour(k), { mode: "markers", showlegend: false, marker: { symbol: "circle-open", size: 8, color: colour(k) } })]),
      ...lines.map((l) => ({ ...l, showlegend: false })), plain([0, 1], [0, 1], "χ = S", ink, "6px,3px")],
      layout: layout(["Saturation <i>S</i><sub>r</sub>", { range: [-0.02, 1.04] }], ["χ", { range: [-0.02, 1.15] }], above) }),
    series: () => rows(stage, "saturation", "chi_contact", "chi_fluid"),
    caption: caption(count, "c", "Filled: from the stress of the contacts; open: from the forces of the fluids.", text ? ` Straight lines (root mean square of what is left): ${text}.` : "") });
}

function forces(stage, count) {
  return figure({ name: `unsaturated-forces-${stage.name}`, title: "Contact forces", size: "low",
    draw: () => ({ data: stage.branches.map((b, k) => curve(b.pc_star, b.force_ratio, b.name, colour(k))),
      layout: layout([star, { rangemode: "tozero" }], ["Mean normal force over the first", {}], { ...above, shapes: regimes(stage).shapes }) }),
    series: () => rows(stage, "pc_star", "force_ratio", "capillary_force", "pressure_force", "tension_force"),
    caption: caption(count, "d", "Mean normal force of the contacts between grains over that at the first pressure.") });
}

function anisotropy(stage, count) {
  return figure({ name: `unsaturated-anisotropy-${stage.name}`, title: "Anisotropy", size: "low",
    draw: () => ({ data: stage.branches.flatMap((b, k) => [curve(b.pc_star, b.capillary_anisotropy, `fluids, ${b.name}`, colour(k)),
      curve(b.pc_star, b.contact_anisotropy, `contacts, ${b.name}`, colour(k), { line: { color: colour(k), width: 1.4, dash: "3px,3px" }, marker: { symbol: "circle-open", size: 6, color: colour(k) } })]),
      layout: layout([star, { rangemode: "tozero" }], ["Anisotropy", { rangemode: "tozero" }], { ...above, shapes: regimes(stage).shapes }) }),
    series: () => rows(stage, "pc_star", "capillary_anisotropy", "contact_anisotropy"),
    caption: caption(count, "e", "Of the forces of the fluids on grains (filled) and of the contact normals (open).") });
}

function spreads(stage, count) {
  const centres = (density) => density.map((_, k) => (k + 0.5) * stage.width);
  const cut = (density) => density.slice(0, Math.ceil(6 / stage.width)).map((d) => (d > 0 ? d : null));
  return figure({ name: `unsaturated-spreads-${stage.name}`, title: "Probability of force magnitudes", size: "low",
    draw: () => ({ data: stage.spreads.flatMap((s, k) => [
      curve(centres(cut(s.contact)), cut(s.contact), `contacts, S = ${number(s.saturation, 2)}`, colour(k), { mode: "lines" }),
      curve(centres(cut(s.capillary)), cut(s.capillary), `fluids, S = ${number(s.saturation, 2)}`, colour(k), { line: { color: colour(k), width: 1.4, dash: "3px,3px" }, mode: "lines" })]),
      layout: layout(["Force over its mean", { rangemode: "tozero" }], ["Probability density", { type: "log", exponentformat: "power" }], above) }),
    series: () => [["saturation", "force_over_mean", "contacts", "fluids"], stage.spreads.flatMap((s) => {
      const n = Math.max(s.contact.length, s.capillary.length);
      return Array.from({ length: n }, (_, k) => [s.saturation, (k + 0.5) * stage.width, s.contact[k] ?? 0, s.capillary[k] ?? 0]);
    })],
    caption: caption(count, "f", "Normal forces of contacts (solid) and forces of the fluids on grains (dashed), each over its mean.") });
}

/** Figures of one stage. */
export const unsaturatedFigures = (stage, count) => [retention, strain, bishop, forces, anisotropy, spreads].map((draw) => draw(stage, count));
