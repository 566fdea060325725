// A figure: heading, switches, buttons, plot, caption.
import Plotly from "plotly.js-basic-dist-min";
import { csv, download, element } from "./dom.js";

const ink = "#1a2330";
const config = { displayModeBar: false, responsive: true };
const family = '"Inter", "Source Sans 3", "Segoe UI", "Helvetica Neue", Arial, "Liberation Sans", sans-serif';

const axis = (title, more = {}) => ({
  title: { text: title, standoff: 10 }, ticks: "outside", ticklen: 5, tickcolor: ink, showline: true, linecolor: ink, linewidth: 1,
  mirror: true, gridcolor: "#e9edf1", zeroline: false, automargin: true, hoverformat: ".4~g", ...more,
});

export function layout(x, y, more = {}) {
  const small = window.innerWidth < 700;
  return {
    font: { family, size: small ? 12 : 13, color: ink }, paper_bgcolor: "#fff", plot_bgcolor: "#fff", separators: ".\u202f",
    margin: { l: small ? 52 : 66, r: 10, t: 10, b: 48 }, xaxis: axis(...x), yaxis: axis(...y), hovermode: "closest",
    dragmode: small ? false : "zoom", hoverlabel: { bgcolor: "#fff", bordercolor: "#9aa5b1", font: { family, size: 12.5, color: ink } },
    legend: { bgcolor: "rgba(255,255,255,0.88)", borderwidth: 0, font: { size: small ? 11.5 : 12.5 }, itemwidth: 30 },
    ...more,
  };
}

/**
 * @param draw    () => ({data, layout}), called now and when a switch is turned
 * @param series  () => [header, rows] of the CSV button
 */
export function figure({ name, title, caption, size, switches = [], draw, series }) {
  const plot = element("div", { class: `plot ${size}`, role: "img", "aria-label": title });
  const redraw = () => {
    const { data, layout: look } = draw();
    return Plotly.react(plot, data, look, config);
  };
  const image = () => Plotly.downloadImage(plot, { format: "png", filename: name, scale: 3, width: plot.clientWidth, height: plot.clientHeight });
  const buttons = [
    element("button", { type: "button", title: "Save this figure as an image", on: { click: image } }, "PNG"),
    element("button", { type: "button", title: "Save the numbers of this figure", on: { click: () => download(`${name}.csv`, csv(...series())) } }, "CSV"),
  ];
  const node = element("figure", { id: name }, element("div", { class: "figure-head" }, element("h3", {}, title), switches.map((s) => s(redraw)), buttons), plot, caption);
  return { node, redraw };
}

/** Choose one of several; `choose(key)` is called before the figure is drawn again. */
export const choice = (name, options, choose) => (redraw) =>
  element("span", { class: "switch", role: "radiogroup" }, options.flatMap(([key, text], k) => [
    element("input", { type: "radio", name, id: `${name}-${key}`, ...(k === 0 ? { checked: "" } : {}), on: { change: () => { choose(key); redraw(); } } }),
    element("label", { for: `${name}-${key}` }, text),
  ]));

export const toggle = (name, text, turn) => (redraw) =>
  element("span", { class: "switch" },
    element("input", { type: "checkbox", id: name, checked: "", on: { change: (event) => { turn(event.target.checked); redraw(); } } }),
    element("label", { for: name, class: "alone" }, text));
