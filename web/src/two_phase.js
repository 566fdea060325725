// Two fluids that move: pictures of the pattern, saturation and volumes in time, box counts, a Haines jump.
import { element, number } from "./dom.js";
import { choice, figure, layout } from "./figure.js";
import { air, grain, paint, swatch, water } from "./section.js";

const blue = "#1f5fa8", red = "#d1561b", teal = "#168a83", ink = "#1a2330";
const log = { type: "log", tickvals: [0.01, 0.02, 0.05, 0.1, 0.2, 0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500, 1000, 2000, 5000, 10000] };
const caption = (count, letter, ...text) => element("figcaption", {}, element("b", {}, `Figure ${count}${letter}. `), ...text);
const above = { legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 66, r: 12, t: 42, b: 48 } };

/** A time in the unit that suits the largest of them. */
function timeScale(times) {
  const last = Math.max(...times, 0);
  return last >= 1 ? [1, "s"] : last >= 1e-3 ? [1e3, "ms"] : [1e6, "µs"];
}

function patterns(flow, count) {
  const [scale, unit] = timeScale(flow.time);
  const pictures = flow.snapshots.map((snapshot) => {
    const canvas = element("canvas", { role: "img", "aria-label": `saturation at S = ${number(snapshot.saturation, 3)}` });
    paint(canvas, flow.section, snapshot.picture);
    return element("div", {}, canvas, element("div", { class: "note" }, `S = ${number(snapshot.saturation, 3)}, t = ${number(snapshot.time * scale, 3)} ${unit}`));
  });
  const { columns, rows, planes, pixel, axis } = flow.section;
  const view = planes > 1 ? `Saturation seen through the bed along ${axis}: the mean of the void over each point` : `Saturation of the pores in the plane through the middle of the box, across ${axis}; void is shown in the colour of the pore it is nearest to`;
  return element("figure", { id: "patterns" }, element("div", { class: "figure-head" }, element("h3", {}, "Pattern"), swatch(air, "air"), swatch(water, "water"), swatch(grain, "grain")),
    element("div", { class: "pictures", style: `--columns: ${pictures.length === 4 || pictures.length > 6 ? 4 : 3}` }, pictures),
    caption(count, "a", `${view}. ${number(columns * pixel * 1e3, 3)} mm × ${number(rows * pixel * 1e3, 3)} mm.`));
}

function curve(flow, count) {
  const [scale, unit] = timeScale(flow.time);
  let shown = "saturation";
  const time = flow.time.map((t) => t * scale);
  const line = (y, name, color, dash = "solid") => ({ x: time, y, name, mode: "lines", line: { color, width: 1.7, dash }, hovertemplate: `%{x:.4~g} ${unit}: %{y:.4~g}<extra>%{fullData.name}</extra>` });
  const views = {
    saturation: () => ({ data: [line(flow.saturation, "saturation", blue)], y: ["Saturation <i>S</i>", { rangemode: "tozero" }] }),
    volumes: () => ({ data: [line(flow.wetting_out, "water out", blue), line(flow.nonwetting_in, "air in", red), line(flow.wetting_in, "water in", blue, "6px,3px"), line(flow.nonwetting_out, "air out", red, "6px,3px")], y: ["Volume / void", {}] }),
    area: () => ({ data: [line(flow.area, "area", teal)], y: ["Meniscus area / box volume (1/mm)", { rangemode: "tozero" }] }),
    euler: () => ({ data: [line(flow.euler_wetting, "water", blue), line(flow.euler_nonwetting, "air", red)], y: ["Euler number", {}] }),
  };
  const draw = () => {
    const { data, y } = views[shown]();
    return { data, layout: layout([`Time (${unit})`, {}], y, data.length > 1 ? above : { showlegend: false }) };
  };
  const keys = ["time", "saturation", "pc", "wetting_in", "wetting_out", "nonwetting_in", "nonwetting_out", "area", "euler_wetting", "euler_nonwetting"];
  return figure({ name: "flow-history", title: "In time", size: "low", draw, series: () => [keys, flow.time.map((_, k) => keys.map((key) => flow[key][k]))],
    switches: [choice("flow", [["saturation", "S"], ["volumes", "volumes"], ["area", "menisci"], ["euler", "Euler"]], (key) => { shown = key; })],
    caption: caption(count, "b", "Saturation, volumes that crossed the borders, area of the menisci in the pores, and Euler numbers (parts less loops) of both fluids.") });
}

function pressure(flow, count, letter) {
  return figure({ name: "flow-pressure", title: "Capillary pressure", size: "low", series: () => [["saturation", "pc_Pa"], flow.saturation.map((s, k) => [s, flow.pc[k]])],
    draw: () => ({ data: [{ x: flow.saturation, y: flow.pc.map((p) => p / 1e3), mode: "lines", line: { color: ink, width: 1.6 }, hovertemplate: "S = %{x:.4~g}: %{y:.4~g} kPa<extra></extra>" }],
      layout: layout(["Saturation <i>S</i>", {}], ["Pressure difference (kPa)", {}], { showlegend: false }) }),
    caption: caption(count, letter, "Difference of the pressures of air and water at their reservoirs.") });
}

function boxes(flow, count, letter) {
  const colours = [blue, red];
  return figure({ name: "box-counting", title: "Box counting", size: "low", series: () => [["region", "box_m", "boxes"], flow.boxes.flatMap((b) => b.size.map((size, k) => [b.name, size, b.boxes[k]]))],
    draw: () => ({ data: flow.boxes.flatMap((b, k) => {
      const middle = Math.floor(b.size.length / 2), fit = b.size.map((s) => b.boxes[middle] * (s / b.size[middle]) ** -b.dimension);
      const x = b.size.map((s) => s * 1e3);
      return [{ x, y: b.boxes, name: `${b.name}: D = ${number(b.dimension, 3)}`, mode: "markers", marker: { color: colours[k % 2], size: 8 }, hovertemplate: "%{x:.3~g} mm: %{y}<extra></extra>" },
        { x, y: fit, mode: "lines", line: { color: colours[k % 2], width: 1 }, showlegend: false, hoverinfo: "skip" }];
    }), layout: layout(["Side of the boxes (mm)", log], ["Boxes", log], above) }),
    caption: caption(count, letter, "Boxes that hold part of the invaded region, seen across the bed, at breakthrough or else at the end; D is minus the slope of the line.") });
}

function jump(flow, count, letter) {
  const { invaded, retracting, time } = flow.jump;
  const [scale, unit] = timeScale(time.map((t) => t - time[0]));
  const x = time.map((t) => (t - time[0]) * scale);
  const line = (y, name, color, dash) => ({ x, y: y.map((p) => (p === null ? null : p / 1e3)), name, mode: "lines", line: { color, width: 1.7, dash }, hovertemplate: `%{x:.4~g} ${unit}: %{y:.4~g} kPa<extra>%{fullData.name}</extra>` });
  return figure({ name: "haines-jump", title: "A Haines jump", size: "low", series: () => [["time_s", "pc_invaded_Pa", "pc_retracting_Pa"], time.map((t, k) => [t, invaded[k], retracting[k]])],
    draw: () => ({ data: [line(invaded, "invaded pore", red, "solid"), line(retracting, "pore the air came from", blue, "6px,3px")], layout: layout([`Time since the invasion (${unit})`, {}], ["Capillary pressure (kPa)", {}], above) }),
    caption: caption(count, letter, "Capillary pressure of the pore that is invaded and of the one whose meniscus draws back for it.") });
}

/** {pictures, figures} of a run's two-phase flow; figures are numbered `count`. */
export function flowSection(flow, count) {
  const figures = [curve(flow, count)];
  const next = () => "abcdef"[figures.length + 1];
  if (Math.max(...flow.pc) - Math.min(...flow.pc) > 1e-9 * Math.max(...flow.pc.map(Math.abs))) figures.push(pressure(flow, count, next()));
  if (flow.boxes.length > 0) figures.push(boxes(flow, count, next()));
  if (flow.jump) figures.push(jump(flow, count, next()));
  return { pictures: flow.snapshots.length > 0 ? patterns(flow, count) : null, figures };
}
