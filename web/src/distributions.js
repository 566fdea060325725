// Radius distributions by number, over the mean grain radius.
import { element } from "./dom.js";
import { figure, layout } from "./figure.js";

const own = { pore: ["#1f5fa8", "rgba(31,95,168,0.16)"], throat: ["#168a83", "rgba(22,138,131,0.16)"] };
const others = ["#3c444d", "#7a4a21", "#4f6b3a"];
const dashes = ["5px,3px", "2px,2px", "8px,3px,2px,3px"];

/** Corners of the bars, from the ground and back to it. */
function outline({ low, high, pdf }) {
  const x = [low[0]], y = [0];
  low.forEach((left, k) => { x.push(left, high[k]); y.push(pdf[k], pdf[k]); });
  return { x: [...x, high[high.length - 1]], y: [...y, 0] };
}

function draw(runs, kind, symbol) {
  const data = runs.map((run, r) => ({ run, r })).filter(({ run }) => run[kind].low.length > 0).map(({ run, r }) => ({
    ...outline(run[kind]), name: r === 0 ? "this run" : run.label, mode: "lines", hovertemplate: "%{x:.3f}: %{y:.3f}<extra>%{fullData.name}</extra>",
    line: r === 0 ? { color: own[kind][0], width: 1.4 } : { color: others[(r - 1) % 3], width: 1.4, dash: dashes[(r - 1) % 3] },
    ...(r === 0 ? { fill: "tozeroy", fillcolor: own[kind][1] } : {}),
  }));
  const few = data.length < 2;
  return {
    data,
    layout: layout([`${symbol}/⟨<i>r</i>⟩`, { rangemode: "tozero" }], ["Probability density", { rangemode: "tozero" }],
      { showlegend: !few, legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 58, r: 10, t: few ? 10 : 34, b: 48 } }),
  };
}

export function distributionFigures(runs, number) {
  const one = (kind, title, symbol, letter, text) => figure({
    name: `${kind}-radii`, title, size: "low", draw: () => draw(runs, kind, symbol),
    caption: element("figcaption", {}, element("b", {}, `Figure ${number}${letter}. `), text),
    series: () => [["run", "bin_low", "bin_high", "pdf"], runs.flatMap((run) => run[kind].low.map((low, k) => [run.label, low, run[kind].high[k], run[kind].pdf[k]]))],
  });
  return [
    one("pore", "Pore radii", "<i>R<sub>i</sub></i>", "a", "Radii of the pore units, by number, over the mean grain radius."),
    one("throat", "Throat radii", "<i>r</i><sub>in</sub>", "b", "Radii of the circles inscribed in the throats, by number, over the mean grain radius."),
  ];
}
