// One fluid and grains that move each other: consolidation or seepage in time, and the pressure in the layers.
import { element, number } from "./dom.js";
import { figure, layout } from "./figure.js";

const blue = "#1f5fa8", red = "#d1561b", teal = "#168a83", ink = "#1a2330";
const shades = ["#0b2e55", "#1f5fa8", "#2f86b5", "#168a83", "#5f9a3c", "#b2952a", "#d1561b", "#a03624", "#7a4a80", "#5a6470", "#9aa3ad"];
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 12, t: 42, b: 48 } };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
const line = (x, y, name, color, dash = "solid") => ({ x, y, name, mode: "lines", line: { color, width: 1.8, dash }, hovertemplate: "%{x:.4~g}, %{y:.4~g}<extra>%{fullData.name}</extra>" });

function degrees(stage, count) {
  const draw = () => ({
    data: [line(stage.time_factor, stage.degree, "settlement", blue), line(stage.time_factor, stage.degree_pressure, "pressure", teal), line(stage.time_factor, stage.degree_terzaghi, "Terzaghi", ink, "6px,3px")],
    layout: layout(["Time factor <i>T</i><sub>v</sub>", { rangemode: "tozero" }], ["Degree of consolidation <i>U</i>", { range: [1.05, -0.02] }], above),
  });
  const r = stage.reference;
  return figure({ name: `degree-${stage.name}`, title: "Consolidation", size: "low", draw,
    series: () => [["time_factor", "degree_settlement", "degree_pressure", "degree_terzaghi"], stage.time_factor.map((t, k) => [t, stage.degree[k], stage.degree_pressure[k], stage.degree_terzaghi[k]])],
    caption: caption(count, "a", `Stiffness ${number(r.stiffness / 1e6, 4)} MPa and permeability ${number(r.permeability, 4)} m² of the packing were measured before; nothing is fitted.`) });
}

function seepage(stage, count) {
  const draw = () => ({
    data: [line(stage.gradient, stage.lower, "on the lower wall", blue), line(stage.gradient, stage.upper, "on the upper wall", red)],
    layout: layout(["Hydraulic gradient <i>i</i>", {}], ["Stress of the grains (Pa)", { rangemode: "tozero" }], above),
  });
  return figure({ name: `seepage-${stage.name}`, title: "Seepage", size: "low", draw,
    series: () => [["gradient", "stress_lower_Pa", "stress_upper_Pa"], stage.gradient.map((g, k) => [g, stage.lower[k], stage.upper[k]])],
    caption: caption(count, "a", "Stress of the grains on the two walls against the gradient that drives the fluid.") });
}

function settlement(stage, count) {
  const draw = () => ({
    data: [line(stage.time, stage.settlement.map((s) => 1e3 * s), "settlement", blue)],
    layout: layout(["Time (s)", { rangemode: "tozero" }], ["Settlement (mm)", {}], { showlegend: false }),
  });
  return figure({ name: `settlement-${stage.name}`, title: "Settlement", size: "low", draw,
    series: () => [["time_s", "settlement_m"], stage.time.map((t, k) => [t, stage.settlement[k]])],
    caption: caption(count, stage.gradient.some((g) => g !== 0) ? "c" : "a", `Shortening of the box along ${stage.axis}.`) });
}

function profiles(stage, count) {
  const label = (p) => (p.time_factor === null ? `${number(p.time, 3)} s` : number(p.time_factor, 2));
  const draw = () => ({
    data: stage.profiles.flatMap((p, k) => [
      { x: p.pressure, y: p.place.map((z) => 1e3 * z), name: label(p), mode: "markers", marker: { color: shades[k % shades.length], size: 6 }, hovertemplate: "%{x:.4~g} Pa at %{y:.4~g} mm<extra>%{fullData.name}</extra>" },
      ...(stage.reference ? [{ x: p.theory, y: p.place.map((z) => 1e3 * z), showlegend: false, mode: "lines", line: { color: shades[k % shades.length], width: 1.2 }, hoverinfo: "skip" }] : []),
    ]),
    layout: layout(["Piezometric pressure (Pa)", {}], [`Place <i>${stage.axis}</i> (mm)`, {}], { legend: { ...layout([""], [""]).legend, title: { text: stage.reference ? "<i>T</i><sub>v</sub>" : "time" } } }),
  });
  return figure({ name: `profiles-${stage.name}`, title: "Pressure profiles", size: "low", draw,
    series: () => [["time_s", "place_m", "pressure_Pa", "terzaghi_Pa"], stage.profiles.flatMap((p) => p.place.map((z, k) => [p.time, z, p.pressure[k], p.theory[k]]))],
    caption: caption(count, "b", "Mean pressure of the pores of each layer", stage.reference ? "; lines: Terzaghi." : ".") });
}

/** Figures of one stage. */
export function saturatedFigures(stage, count) {
  if (stage.reference) return [degrees(stage, count), profiles(stage, count)];
  if (stage.gradient.some((g) => g !== 0)) return [seepage(stage, count), profiles(stage, count), settlement(stage, count)];
  return [settlement(stage, count), profiles(stage, count)];
}
