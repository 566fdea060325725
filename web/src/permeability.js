// One fluid driven through the box: pressure of its pores against place, and what it says.
import { element, label, number, table } from "./dom.js";
import { figure, layout } from "./figure.js";

function profileFigure(stage, count, letter) {
  const { place, pressure, linear } = stage.profile;
  const line = stage.inlet_is_upper ? [0, stage.drop] : [stage.drop, 0];
  const draw = () => ({
    data: [
      { x: [0, 1], y: [0, 1].map((end) => line[end] / stage.drop), name: "straight line", mode: "lines", line: { color: "#d1561b", width: 1.6, dash: "7px,3px" }, hoverinfo: "skip" },
      { x: place.map((z) => z / stage.length), y: pressure.map((p) => p / stage.drop), name: "pores of a layer", mode: "markers", marker: { color: "#1f5fa8", size: 7.5 }, cliponaxis: false,
        customdata: place.map((z, k) => [number(z * 1e3), number(pressure[k]), number(linear[k])]), hovertemplate: `${stage.axis} = %{customdata[0]} mm<br>p = %{customdata[1]} Pa, straight %{customdata[2]} Pa<extra></extra>` },
    ],
    layout: layout([`Place <i>${stage.axis}</i> over the length of the box`, { range: [-0.02, 1.02], dtick: 0.2, tickformat: ".1f" }], ["Pressure over the drop", { rangemode: "tozero", tickformat: ".1f" }],
      { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.01, xanchor: "left", yanchor: "bottom" }, margin: { l: 62, r: 12, t: 32, b: 48 } }),
  });
  return figure({ name: `pressure-${stage.name}`, title: "Pressure through the box", size: "low", draw,
    series: () => [["place_m", "pressure_Pa", "linear_Pa"], place.map((z, k) => [z, pressure[k], linear[k]])],
    caption: element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), `Mean pressure of the pores of each layer; single pores are off the straight line by ${number(100 * stage.linear_error, 2)} % of the drop (root mean square).`) });
}

/** [title, node, figures], or nothing. */
export function permeabilitySection(stages, count) {
  const figures = stages.map((stage, k) => profileFigure(stage, count, stages.length > 1 ? "abcdefgh"[k] : ""));
  const nodes = stages.map((stage, k) => element("div", { class: "pair" }, figures[k].node,
    table(stages.length > 1 ? stage.name : "", [{}, {}], stage.rows.map(([what, value]) => [label(what), value]), "facts")));
  return { figures, nodes };
}
