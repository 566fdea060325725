// Stages that loaded the grains: stress, volume and energy against strain.
import { element } from "./dom.js";
import { figure, layout, choice } from "./figure.js";

// This run's stages first, then those of other runs; dashes tell them apart in grey print.
const own = ["#1f5fa8", "#d1561b", "#168a83", "#5a4fb0"];
const others = ["#3c444d", "#7a4a21", "#4f6b3a", "#8c96a1"];
const dashes = ["solid", "7px,3px", "2px,2px", "8px,3px,2px,3px"];

const percent = (values) => values.map((v) => 100 * v);
const kilo = (values) => values.map((v) => v / 1e3);
const ratio = (a, b) => a.map((v, k) => (b[k] > 0 ? v / b[k] : null));

/** Stages of some kinds over all runs, each with a name and a look. */
function curves(runs, kinds) {
  const list = [];
  runs.forEach((run, r) => {
    const stages = run.loading.filter((stage) => kinds.includes(stage.kind));
    stages.forEach((stage, k) => {
      const name = r === 0 ? stage.name : stages.length > 1 ? `${run.label}: ${stage.name}` : run.label;
      list.push({ stage, run, name, line: { color: (r === 0 ? own : others)[(r === 0 ? k : r - 1 + k) % 4], width: 1.7, dash: r === 0 ? dashes[k % 4] : dashes[(r + k) % 4] } });
    });
  });
  return list;
}

const above = (entries) => (entries < 2 ? { showlegend: false } : {
  legend: { ...layout([""], [""]).legend, orientation: "h", x: 0, y: 1.02, xanchor: "left", yanchor: "bottom" }, margin: { l: 62, r: 12, t: 22 + 20 * Math.ceil(entries / 2), b: 48 },
});

/** One figure of curves; x and y are {title, of: stage => values, more}. */
function plot({ name, title, list, x, y, number, letter, text, switches = [] }) {
  const pick = (axis) => (typeof axis === "function" ? axis() : axis);
  const draw = () => {
    const [h, v] = [pick(x), pick(y)];
    const data = list.map(({ stage, name: curve, line }) => ({
      x: h.of(stage), y: v.of(stage), name: curve, mode: "lines", line, hovertemplate: `%{x:.4~g}, %{y:.4~g}<extra>%{fullData.name}</extra>`,
    }));
    return { data, layout: layout([h.title, h.more ?? {}], [v.title, v.more ?? {}], above(list.length)) };
  };
  const series = () => [["run", "stage", h0().column, v0().column], list.flatMap(({ run, stage }) => {
    const [h, v] = [h0().of(stage), v0().of(stage)];
    return h.map((value, k) => [run.label, stage.name, value, v[k]]);
  })];
  const [h0, v0] = [() => pick(x), () => pick(y)];
  return figure({ name, title, size: "low", draw, series, switches, caption: element("figcaption", {}, element("b", {}, `Figure ${number}${letter}. `), text) });
}

const axialStrain = { title: "Axial strain <i>ε</i><sub>a</sub> (%)", of: (s) => percent(s.axial_strain), column: "axial_strain_percent" };
const shearStrain = { title: "Shear strain <i>γ</i>", of: (s) => s.shear_strain, column: "shear_strain" };
const volumetric = { title: "Volumetric strain <i>ε</i><sub>v</sub> (%)", of: (s) => percent(s.volumetric_strain), column: "volumetric_strain_percent" };
const deviator = { title: "Deviatoric stress <i>q</i> (kPa)", of: (s) => kilo(s.q), column: "q_kPa" };
const meanStress = { title: "Mean stress <i>p</i> (kPa)", of: (s) => kilo(s.p), more: { rangemode: "tozero" }, column: "p_kPa" };
const stressRatio = { title: "Stress ratio <i>q</i>/<i>p</i>", of: (s) => ratio(s.q, s.p), column: "q_over_p" };

function compression(runs, kind, number) {
  const list = curves(runs, kind);
  let shown = stressRatio;
  return [
    plot({ name: "stress-strain", title: "Stress against strain", list, x: axialStrain, y: () => shown, number, letter: "a",
      switches: [choice("stress", [["ratio", "q/p"], ["q", "q"]], (key) => { shown = key === "q" ? deviator : stressRatio; })],
      text: "Deviatoric stress, the axial less the mean lateral stress, against logarithmic axial strain." }),
    plot({ name: "volume-strain", title: "Volume against strain", list, x: axialStrain, y: volumetric, number, letter: "b",
      text: "Volumetric strain, positive where the packing gets denser; a falling curve is dilation." }),
    plot({ name: "stress-path", title: "Stress path", list, x: meanStress, y: { ...deviator, more: { rangemode: "tozero" } }, number, letter: "c", text: "Deviatoric against mean stress." }),
  ];
}

function oedometer(runs, number) {
  const list = curves(runs, ["oedometer"]);
  return [
    plot({ name: "compression-curve", title: "Compression curve", list, number, letter: "a",
      x: { title: "Axial stress <i>σ</i><sub>a</sub> (kPa)", of: (s) => kilo(s.axial_stress), more: { type: "log", dtick: "D2" }, column: "axial_stress_kPa" },
      y: { title: "Void ratio <i>e</i>", of: (s) => s.void_ratio, column: "void_ratio" }, text: "Void ratio against axial stress, lateral faces standing." }),
    plot({ name: "stress-path-oedometer", title: "Stress path", list, x: meanStress, y: { ...deviator, more: { rangemode: "tozero" } }, number, letter: "b", text: "Deviatoric against mean stress." }),
  ];
}

function shear(runs, number) {
  const list = curves(runs, ["shear"]);
  return [
    plot({ name: "shear-stress", title: "Shear stress against shear strain", list, x: shearStrain, number, letter: "a",
      y: { title: "Stress ratio <i>τ</i>/<i>σ</i><sub>n</sub>", of: (s) => ratio(s.shear_stress, s.normal_stress), column: "shear_over_normal_stress" }, text: "Tangential over normal stress on the walls that slide." }),
    plot({ name: "shear-volume", title: "Volume against shear strain", list, x: shearStrain, y: volumetric, number, letter: "b", text: "Volumetric strain, positive where the packing gets denser." }),
  ];
}

function rest(runs, number) {
  const list = curves(runs, ["isotropic", "settle"]);
  return [plot({ name: "rest", title: "Coming to rest", list, number, letter: "",
    x: { title: "Time (s)", of: (s) => s.time, column: "time_s" },
    y: { title: "Unbalanced force ratio", of: (s) => s.unbalanced.map((u) => (u > 0 ? u : null)), more: { type: "log", dtick: 1, exponentformat: "power" }, column: "unbalanced" },
    text: "Mean resultant on a grain over mean contact force." })];
}

/** Where the work went: changes since the start of the stage. */
function energy(stage, number, letter) {
  const since = (values) => values.map((v) => v - values[0]);
  const e = stage.energy;
  const hasPotential = e.friction.some((v) => v !== 0) || e.shear.some((v) => v !== 0);
  const terms = [
    ["work put in", since(e.input), "#1a2330", "solid"],
    ["stored in normal springs", since(e.normal), "#1f5fa8", "solid"],
    ...(hasPotential ? [["stored in shear springs", since(e.shear), "#168a83", "solid"], ["lost in sliding", since(e.friction), "#d1561b", "solid"]]
      : [["taken up in shear", since(e.shear_work), "#d1561b", "solid"]]),
    ["taken up in rolling", since(e.rolling), "#5a4fb0", "7px,3px"], ["lost in viscous contacts", since(e.viscous), "#b8860b", "7px,3px"],
    ["lost to damping", since(e.damping), "#8c96a1", "7px,3px"], ["kinetic", since(e.kinetic), "#a63a6a", "2px,2px"],
    ["of liquid bridges", since(e.bridges), "#2a9fd6", "solid"], ["given off where bridges formed", since(e.wetting), "#2a9fd6", "2px,2px"],
  ];
  const largest = Math.max(...terms.flatMap(([, values]) => values.map(Math.abs)), Number.MIN_VALUE);
  const [scale, unit] = largest >= 1 ? [1, "J"] : largest >= 1e-3 ? [1e3, "mJ"] : largest >= 1e-6 ? [1e6, "µJ"] : [1e9, "nJ"];
  const drawn = terms.filter(([, values]) => Math.max(...values.map(Math.abs)) > 2e-3 * largest);
  const x = stage.kind === "shear" ? shearStrain : axialStrain;
  const draw = () => ({
    data: drawn.map(([name, values, color, dash]) => ({ x: x.of(stage), y: values.map((v) => v * scale), name, mode: "lines", line: { color, dash, width: 1.6 }, hovertemplate: `%{x:.4~g}: %{y:.4~g} ${unit}<extra>%{fullData.name}</extra>` })),
    layout: layout([x.title, {}], [`Energy (${unit})`, {}], above(drawn.length)),
  });
  return figure({ name: `energy-${stage.name}`, title: `Energy, ${stage.name}`, size: "low", draw,
    series: () => [[x.column, ...terms.map(([name]) => `${name} (J)`)], x.of(stage).map((value, k) => [value, ...terms.map(([, values]) => values[k])])],
    caption: element("figcaption", {}, element("b", {}, `Figure ${number}${letter}. `), "Work put in since the start of the stage, and where it went; terms below 0.2 % are left out.") });
}

/** Forces of contacts and of liquid bridges side by side, or how many bridges there are and what they hold. */
function bridges(stage, number, letter) {
  const x = stage.kind === "shear" ? shearStrain : stage.kind === "isotropic" || stage.kind === "settle" ? { title: "Time (s)", of: (s) => s.time, column: "time_s" } : axialStrain;
  const b = stage.bridges;
  const micro = (values) => values.map((v) => 1e6 * v);
  const views = {
    force: { title: "Mean force (µN)", curves: [["contacts, normal", micro(b.contact_force)], ["bridges, of attraction", micro(b.force)]] },
    stress: { title: "Mean stress (Pa)", curves: [["all", stage.p], ["bridges alone", b.stress]] },
    count: { title: "Bridges of a grain", curves: [["bridges of a grain", b.per_grain]] },
    water: { title: "Water (mm³)", curves: [["in bridges", b.water.map((v) => 1e9 * v)], ["on grains", b.films.map((v) => 1e9 * v)]] },
  };
  let shown = "force";
  const draw = () => ({
    data: views[shown].curves.map(([name, values], k) => ({ x: x.of(stage), y: values, name, mode: "lines", line: { color: own[k], dash: dashes[k], width: 1.7 }, hovertemplate: "%{x:.4~g}, %{y:.4~g}<extra>%{fullData.name}</extra>" })),
    layout: layout([x.title, {}], [views[shown].title, {}], above(views[shown].curves.length)),
  });
  const columns = Object.values(views).flatMap((view) => view.curves.map(([name, values]) => [`${name}, ${view.title}`, values]));
  return figure({ name: `bridges-${stage.name}`, title: `Liquid bridges, ${stage.name}`, size: "low", draw,
    switches: [choice("quantity", [["force", "forces"], ["stress", "stress"], ["count", "number"], ["water", "water"]], (key) => { shown = key; })],
    series: () => [[x.column, ...columns.map(([name]) => name)], x.of(stage).map((value, k) => [value, ...columns.map(([, values]) => values[k])])],
    caption: element("figcaption", {}, element("b", {}, `Figure ${number}${letter}. `), "Contacts and liquid bridges between the same grains.") });
}

/** Sections [title, figures] of all that was loaded; figures are counted from `first`. */
export function loadingSections(runs, first) {
  const sections = [];
  const has = (kinds) => runs.some((run) => run.loading.some((stage) => kinds.includes(stage.kind)));
  const add = (title, kinds, make) => {
    if (!has(kinds)) return;
    const figures = make(first + sections.length);
    const last = runs[0].loading.filter((stage) => kinds.includes(stage.kind)).pop();
    if (last && !kinds.includes("settle")) figures.push(energy(last, first + sections.length, "abcde"[figures.length]));
    if (last && last.bridges) figures.push(bridges(last, first + sections.length, "abcde"[figures.length]));
    sections.push([title, figures]);
  };
  add("Coming to rest", ["isotropic", "settle"], (n) => rest(runs, n));
  add("Oedometric compression", ["oedometer"], (n) => oedometer(runs, n));
  add("Triaxial compression", ["triaxial"], (n) => compression(runs, ["triaxial"], n));
  add("Straining", ["strain"], (n) => compression(runs, ["strain"], n));
  add("Shear between walls", ["shear"], (n) => shear(runs, n));
  return sections;
}
