// Two fluids and grains that move each other: retention, strain, effective stress and forces against capillary pressure.
import { element, number } from "./dom.js";
import { figure, layout } from "./figure.js";
import { collapseFigures } from "./collapse.js";
import { swellingFigures } from "./swelling.js";
import { air, arrows, grain, paint, swatch, water } from "./section.js";

const colours = ["#1f5fa8", "#168a83", "#d1561b", "#7a4a80"], ink = "#1a2330", grey = "#8a939d";
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 12, t: 42, b: 48 } };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
const hover = "%{x:.4~g}, %{y:.4~g}<extra>%{fullData.name}</extra>";
const curve = (x, y, name, color, more = {}) => ({ x, y, name, mode: "lines+markers", line: { color, width: 1.8 }, marker: { color, size: 5 }, hovertemplate: hover, ...more });
const plain = (x, y, name, color, dash) => ({ x, y, name, mode: "lines", line: { color, width: 1.2, dash }, hoverinfo: "skip" });
const star = "Capillary pressure <i>p</i><sub>c</sub>⟨<i>r</i>⟩/γ";
// From dry the path spans decades; no capillary pressure at all is then off the axis.
const pressureAxis = (stage) => [star, Math.max(...stage.branches.flatMap((b) => b.pc_star)) > 20 ? { type: "log", exponentformat: "power" } : { rangemode: "tozero" }];
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
      layout: layout(pressureAxis(stage), ["Saturation <i>S</i><sub>r</sub>", { range: [-0.02, 1.04] }], { ...above, shapes }) }),
    series: () => rows(stage, "pc", "pc_star", "saturation"), caption: caption(count, "a", `Equilibria of grains and fluids.${text}`) });
}

function strain(stage, count) {
  return figure({ name: `unsaturated-strain-${stage.name}`, title: "Strain", size: "low",
    draw: () => ({ data: stage.branches.map((b, k) => curve(b.pc_star, b.strain, b.name, colour(k))),
      layout: layout(pressureAxis(stage), [`Strain along ${stage.axis}`, { exponentformat: "power" }], { ...above, shapes: regimes(stage).shapes }) }),
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
      layout: layout(pressureAxis(stage), ["Mean normal force over the first", {}], { ...above, shapes: regimes(stage).shapes }) }),
    series: () => rows(stage, "pc_star", "force_ratio", "capillary_force", "pressure_force", "tension_force"),
    caption: caption(count, "d", "Mean normal force of the contacts between grains over that at the first pressure.") });
}

function anisotropy(stage, count) {
  return figure({ name: `unsaturated-anisotropy-${stage.name}`, title: "Anisotropy", size: "low",
    draw: () => ({ data: stage.branches.flatMap((b, k) => [curve(b.pc_star, b.capillary_anisotropy, `fluids, ${b.name}`, colour(k)),
      curve(b.pc_star, b.contact_anisotropy, `contacts, ${b.name}`, colour(k), { line: { color: colour(k), width: 1.4, dash: "3px,3px" }, marker: { symbol: "circle-open", size: 6, color: colour(k) } })]),
      layout: layout(pressureAxis(stage), ["Anisotropy", { rangemode: "tozero" }], { ...above, shapes: regimes(stage).shapes }) }),
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

function pictures(stage, count) {
  const longest = Math.max(...stage.pictures.flatMap((p) => p.force_across.map((f, k) => Math.hypot(f, p.force_up[k]))));
  const drawn = stage.pictures.map((p) => {
    const canvas = element("canvas", { role: "img", "aria-label": `saturation and forces at S = ${number(p.saturation, 3)}` });
    paint(canvas, p, p.picture);
    arrows(canvas, p, p.force_across, p.force_up, longest);
    return element("div", {}, canvas, element("div", { class: "note" }, `S = ${number(p.saturation, 3)}, p`, element("sub", {}, "c"), `* = ${number(p.pc_star, 3)}`));
  });
  const { columns, rows, pixel, axis } = stage.pictures[0];
  return element("figure", { id: `unsaturated-section-${stage.name}` },
    element("div", { class: "figure-head" }, element("h3", {}, "Section"), swatch(air, "air"), swatch(water, "water"), swatch(grain, "grain")),
    element("div", { class: "pictures", style: `--columns: ${Math.min(drawn.length, 6)}` }, drawn),
    caption(count, "", `Saturation of the pores in the plane through the middle of the box, across ${axis}, ${number(columns * pixel * 1e3, 3)} mm × ${number(rows * pixel * 1e3, 3)} mm; arrows: force of the fluids on each grain it cuts, the longest ${number(longest * 1e6, 3)} µN.`));
}

function deviators(stage, strained, count) {
  return figure({ name: `unsaturated-deviator-${stage.name}`, title: "Deviator", size: "low",
    draw: () => ({ data: [plain(strained.strain, strained.deviator, "q", colours[0], "solid")],
      layout: layout(["Strain along z", {}], ["<i>q</i> of the contacts (Pa)", {}], { showlegend: false }) }),
    series: () => [["strain", "q_Pa", "p_Pa", "saturation"], strained.strain.map((e, k) => [e, strained.deviator[k], strained.contact_mean[k], strained.saturation[k]])],
    caption: caption(count, "a", `Under p`, element("sub", {}, "c"), ` = ${number(strained.pc[0], 4)} Pa; saturation ${number(strained.saturation[0], 3)} at first, ${number(strained.saturation.at(-1), 3)} at last.`) });
}

function volumes(stage, strained, count) {
  return figure({ name: `unsaturated-volume-${stage.name}`, title: "Volume", size: "low",
    draw: () => ({ data: [plain(strained.strain, strained.volume_strain, "volume", colours[1], "solid")],
      layout: layout(["Strain along z", {}], ["Volumetric strain, shrinking positive", {}], { showlegend: false }) }),
    series: () => [["strain", "volume_strain"], strained.strain.map((e, k) => [e, strained.volume_strain[k]])],
    caption: caption(count, "b", "Of the box, since the straining began.") });
}

function strainedAnisotropy(stage, strained, count) {
  return figure({ name: `unsaturated-strained-anisotropy-${stage.name}`, title: "Anisotropy while strained", size: "low",
    draw: () => ({ data: [plain(strained.strain, strained.capillary_anisotropy, "forces of the fluids", colours[0], "solid"), plain(strained.strain, strained.contact_anisotropy, "contact normals", colours[2], "solid")],
      layout: layout(["Strain along z", {}], ["Anisotropy", { rangemode: "tozero" }], above) }),
    series: () => [["strain", "capillary_anisotropy", "contact_anisotropy"], strained.strain.map((e, k) => [e, strained.capillary_anisotropy[k], strained.contact_anisotropy[k]])],
    caption: caption(count, "c", "Of the forces of the fluids on grains and of the contact normals.") });
}

/** Sections {pictures, figures} of one stage: the path of pressures and, where there is one, the straining after it. */
export function unsaturatedSections(stage, count) {
  const path = { ...stage, branches: stage.branches.filter((b) => b.name !== "strain") };
  const strained = stage.branches.find((b) => b.name === "strain");
  const sections = [];
  const pressures = path.branches.flatMap((b) => b.pc);
  if (pressures.some((p) => p !== pressures[0])) sections.push([retention, strain, bishop, forces, anisotropy, spreads].map((draw) => draw(path, count)));
  if (path.branches.some((b) => b.bridges.some((n) => n > 0))) sections.push(collapseFigures(path, count + sections.length));
  if (stage.swelling) sections.push(swellingFigures(stage, count + sections.length));
  if (strained) sections.push([deviators, volumes, strainedAnisotropy].map((draw) => draw(stage, strained, count + sections.length)));
  return { pictures: stage.pictures.length > 0 ? pictures(stage, count + sections.length) : null, figures: sections.flat(), used: sections.length + (stage.pictures.length > 0 ? 1 : 0) };
}
