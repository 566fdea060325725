// The retention loop: equilibria, van Genuchten curves, other runs; and the tables that go with it.
import { element, number, table } from "./dom.js";
import { choice, figure, layout, toggle } from "./figure.js";

// Colours that stay apart for colour-blind readers and in grey print; other runs are grey, then brown.
const own = { drainage: ["#1f5fa8", "#168a83", "#5a4fb0"], imbibition: ["#d1561b", "#b8860b", "#a63a6a"] };
const others = [["#2f363e", "#8c96a1", "#5c6670"], ["#7a4a21", "#c29a72", "#9a6c40"], ["#44602f", "#9ab07f", "#6b8652"]];
const symbols = { drainage: ["circle", "diamond", "square"], imbibition: ["circle-open", "diamond-open", "square-open"] };
const otherSymbols = ["triangle-up", "triangle-down", "pentagon"];

const words = (name) => (/^(drainage|imbibition)-\d+$/.test(name) ? name.replace(/^d/, "D").replace(/^i/, "I").replace("-", "\u00a0") : name);

export function look(run, r, branch) {
  const kind = branch.drainage ? "drainage" : "imbibition";
  const turn = Math.max(0, (Number(branch.name.split("-").pop()) || 1) - 1);
  if (r === 0) return { colour: own[kind][turn % 3], symbol: symbols[kind][turn % 3], width: 1.6 };
  const symbol = otherSymbols[(r - 1) % 3] + (branch.drainage ? "" : "-open");
  return { colour: others[(r - 1) % 3][branch.drainage ? (turn === 0 ? 0 : 2) : 1], symbol, width: 1.1 };
}

const title = (run, r, branch) => (r === 0 ? words(branch.name) : `${run.label}: ${words(branch.name)}`);

function traces(runs, unit, fits) {
  const legend = [];
  const list = [];
  [...runs.keys()].reverse().forEach((r) => {  // this run last: on top of the others
    const run = runs[r];
    const entries = [];
    const scale = unit === "star" ? run.star_per_Pa : 1;
    if (scale === null) return;
    run.branches.forEach((branch) => {
      const { colour, symbol, width } = look(run, r, branch);
      const name = title(run, r, branch);
      const measured = branch.name === "data";
      const star = run.star_per_Pa;
      // The entry in the legend, with both line and symbol.
      entries.push({ x: [null], y: [null], name, legendgroup: name, mode: measured ? "markers" : "lines+markers", line: { color: colour, width: width + 0.2, dash: branch.drainage ? "solid" : "7px,3px" },
        marker: { color: colour, symbol, size: 7, line: { color: colour, width: 1.5 } } });
      list.push({
        x: branch.saturation, y: branch.pc.map((p) => p * scale), name, legendgroup: name, showlegend: false, cliponaxis: false,
        mode: measured || fits && branch.fit ? "markers" : "lines+markers", line: { color: colour, width },
        marker: { color: colour, symbol, size: r === 0 ? 7.5 : 6.5, line: { color: colour, width: 1.5 } },
        customdata: branch.pc.map((p, k) => [number(p), star === null ? "–" : number(p * star), number(branch.saturation[k]), number(branch.trapped_nonwetting[k], 3), number(branch.trapped_wetting[k], 3)]),
        hovertemplate: "S = %{customdata[2]}<br><i>p</i><sub>c</sub> = %{customdata[0]} Pa, <i>p</i><sub>c</sub>⟨<i>r</i>⟩/γ = %{customdata[1]}<br>trapped: non-wetting %{customdata[3]}, wetting %{customdata[4]}<extra>%{fullData.name}</extra>",
      });
      if (fits && branch.fit)
        list.push({
          x: branch.fit.saturation, y: branch.fit.pc.map((p) => p * scale), name, legendgroup: name, showlegend: false, hoverinfo: "skip",
          mode: "lines", line: { color: colour, width: width + 0.2, dash: branch.drainage ? "solid" : "7px,3px" },
        });
    });
    legend.unshift(...entries);
  });
  return [...legend, ...list];
}

export function retentionFigure(runs, number) {
  let unit = "Pa";
  let fits = true;
  const labels = { Pa: "Capillary pressure <i>p</i><sub>c</sub> (Pa)", star: "Scaled capillary pressure <i>p</i><sub>c</sub>⟨<i>r</i>⟩/γ" };
  const draw = () => {
    const small = window.innerWidth < 700;
    const data = traces(runs, unit, fits);
    const entries = data.filter((trace) => trace.showlegend !== false).length;
    const above = !small && entries > 3;  // more would cover a plateau
    const look = small ? { height: 390 + 22 * entries } : {};  // a narrow figure has its legend below
    return {
      data,
      layout: layout(["Saturation <i>S</i> of the wetting fluid", { range: [-0.02, 1.02], dtick: small ? 0.2 : 0.1, tickformat: ".1f" }],
        [labels[unit], { rangemode: "tozero", tickformat: unit === "Pa" ? ",~r" : "~g" }],
        { legend: { ...layout([""], [""]).legend, ...(small ? { orientation: "h", y: -0.2, yanchor: "top", x: 0 } : above ? { orientation: "h", x: 0, y: 1.01, xanchor: "left", yanchor: "bottom" } : { x: 0.99, y: 0.985, xanchor: "right", yanchor: "top" }) }, margin: { l: small ? 56 : 70, r: 12, t: above ? 58 : 10, b: small ? 66 + 22 * entries : 50 }, ...look }),
    };
  };
  const series = () => [["run", "branch", "step", "pc_Pa", "pc_star", "saturation", "trapped_wetting", "trapped_nonwetting"],
    runs.flatMap((run) => run.branches.flatMap((b) => b.pc.map((p, k) =>
      [run.label, b.name, b.step[k], p, run.star_per_Pa === null ? "" : p * run.star_per_Pa, b.saturation[k], b.trapped_wetting[k], b.trapped_nonwetting[k]])))];
  const caption = element("figcaption", {}, element("b", {}, `Figure ${number}. `), "Capillary pressure against saturation at each equilibrium (symbols), with the van Genuchten curve of each branch (lines; solid drainage, dashed imbibition).");
  const switches = [toggle("fits", "van Genuchten fits", (on) => { fits = on; })];
  if (runs.some((run) => run.star_per_Pa !== null)) switches.unshift(choice("unit", [["Pa", "Pa"], ["star", "scaled"]], (key) => { unit = key; }));
  return figure({ name: "retention", title: "Retention loop", caption, size: "tall", switches, draw, series });
}

const swatch = (run, r, branch) => {
  const mark = element("span", { class: branch.drainage ? "swatch" : "swatch dashed" });
  mark.style.borderColor = look(run, r, branch).colour;
  return mark;
};

const symbol = (letter, index) => element("span", {}, element("var", {}, letter), index ? element("sub", {}, index) : null);
const named = (node, rest) => element("span", {}, node, rest);

export function fitTable(runs) {
  const rows = runs.flatMap((run, r) => run.branches.map((b) => {
    const name = element("span", {}, swatch(run, r, b), title(run, r, b));
    const f = b.fit;
    return f ? [name, number(f.alpha * 1e3), number(f.n), number(f.residual_saturation, 3), number(f.maximal_saturation, 3), number(f.rms, 2), String(b.pc.length)]
      : [name, "–", "–", "–", "–", "–", String(b.pc.length)];
  }));
  return table("van Genuchten parameters", [{ head: "Branch" }, { head: named(symbol("α"), " (1/kPa)"), number: true }, { head: symbol("n"), number: true },
    { head: symbol("S", "r"), number: true }, { head: symbol("S", "s"), number: true }, { head: named("rms in ", symbol("S")), number: true }, { head: "points", number: true }], rows, "wide");
}

export function loopTable(runs) {
  const rows = runs.flatMap((run, r) => run.loops.map((loop) => [`${r === 0 ? "" : `${run.label}: `}${words(loop.upper)}, ${words(loop.lower)}`,
    number(loop.area_Pa), run.star_per_Pa === null ? "–" : number(loop.area_Pa * run.star_per_Pa, 3)]));
  if (rows.length === 0) return null;
  return table("Loop area: work lost per void volume", [{ head: "Between" }, { head: "Pa", number: true },
    { head: named("in γ/⟨", element("span", {}, element("var", {}, "r"), "⟩")), number: true }], rows);
}
