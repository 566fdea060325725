// Builds the report page from the data in it.
import { distributionFigures } from "./distributions.js";
import { element, label, number, table } from "./dom.js";
import { loadingSections } from "./loading.js";
import { permeabilitySection } from "./permeability.js";
import { poreSpaceSection } from "./pore_space.js";
import { fitTable, loopTable, retentionFigure } from "./retention.js";
import { saturatedFigures } from "./saturated.js";
import { flowSection } from "./two_phase.js";
import { unsaturatedSections } from "./unsaturated.js";

const data = JSON.parse(document.getElementById("data").textContent);
const { manifest, runs } = data;
const root = document.documentElement;
window.addEventListener("error", (event) => { root.dataset.error = event.message; });

function header() {
  const failed = manifest.checks.filter((check) => !check.passed).length;
  const pill = manifest.exit_code === 3 ? element("span", { class: "pill bad" }, "interrupted")
    : failed > 0 ? element("span", { class: "pill bad" }, `${failed} of ${manifest.checks.length} checks failed`)
    : manifest.exit_code !== 0 ? element("span", { class: "pill bad" }, "ended with an error")
    : element("span", { class: "pill good" }, manifest.checks.length > 0 ? `all ${manifest.checks.length} checks passed` : "finished");
  const facts = [manifest.started_utc.replace("T", " ").replace("Z", " UTC"), `seed ${manifest.seed}`, `${number(manifest.wall_time_s, 3)} s`, `puadem ${manifest.version}`];
  return element("header", {}, element("div", { class: "kicker" }, "Simulation report"), element("h1", {}, data.title),
    element("div", { class: "meta" }, pill, facts.flatMap((fact) => [element("span", { class: "sep" }, "·"), fact])),
    manifest.error ? element("div", { class: "banner bad" }, element("b", {}, `Ended with exit code ${manifest.exit_code}: `), manifest.error) : null,
    manifest.warnings.length === 0 ? null : element("div", { class: "banner" }, element("b", {}, manifest.warnings.length === 1 ? "Warning" : "Warnings"),
      element("ul", {}, manifest.warnings.map((warning) => element("li", {}, warning)))),
    data.highlights.length === 0 ? null : element("dl", { class: "highlights" }, data.highlights.map((h) => element("div", {}, element("dt", {}, label(h.label)),
      element("dd", { class: "value" }, h.value), element("dd", { class: "note" }, label(h.note))))));
}

const section = (title, ...content) => element("section", {}, element("h2", {}, title), content);

function checksTable() {
  const rows = manifest.checks.map((check) => [check.name, check.value === null ? "not computed" : number(check.value, 5), check.bound,
    { text: check.passed ? "✓ holds" : "✗ fails", class: check.passed ? "mark good" : "mark bad" }]);
  return rows.length === 0 ? null : table("Checks", [{ head: "What" }, { head: "value", number: true }, { head: "must be" }, { head: "" }], rows, "wide");
}

function ledgerTable() {
  const ledger = manifest.ledger;
  if (!(ledger.void_volume_m3 > 0)) return null;
  // As many decimals for all as the void needs: rounding dust reads as zero.
  const decimals = Math.max(0, 5 - Math.floor(Math.log10(ledger.void_volume_m3 * 1e9)));
  const volume = (cubic_metres) => (cubic_metres * 1e9).toFixed(decimals).replace(/^-(?=[0.]+$)/, "").replace("-", "−");
  const row = (name, key) => [name, ...["start", "in", "out", "end"].map((part) => volume(ledger[`${key}_${part}_m3`])), number(ledger[`${key}_error`], 2)];
  return table("Volume ledger of the counted pores (mm³)", [{ head: "Fluid" }, { head: "start", number: true }, { head: "in", number: true },
    { head: "out", number: true }, { head: "end", number: true }, { head: "error / void", number: true }], [row("Wetting", "wetting"), row("Non-wetting", "nonwetting")], "wide");
}

const factTable = ({ title, rows }) => table(title, [{}, {}], rows.map(([what, value]) => [label(what), value]), "facts");

const scalarList = () => data.scalars.map(([name, value]) => element("div", { class: "scalar" }, element("code", {}, name), element("span", {}, value)));

function source(title, text) {
  return text ? element("details", {}, element("summary", {}, title), element("pre", {}, text)) : null;
}

function footer() {
  const m = manifest;
  const rows = [["Program", `puadem ${m.version}, commit ${m.commit}`], ["Built with", `${m.compiler}, ${m.build_type}: ${m.flags}`],
    ["Libraries", Object.entries(m.libraries).map(([name, version]) => `${name} ${version}`).join(", ")],
    ["Machine", `${m.cpu}, ${m.threads} ${m.threads === 1 ? "thread" : "threads"}`], ["Wall time, peak memory", `${number(m.wall_time_s, 3)} s, ${number(m.peak_memory_bytes / 2 ** 20, 3)} MiB`],
    ["Case hash, state hash", `${m.case_hash}, ${m.state_hash}`], ["Folder", data.folder]];
  return element("footer", {}, element("dl", {}, rows.flatMap(([what, value]) => [element("dt", {}, what), element("dd", {}, value)])),
    element("p", {}, runs.every((run) => run.branches.length === 0) ? "" : ["Retention curves: M. Th. van Genuchten, Soil Sci. Soc. Am. J. 44, 892–898 (1980), S = S", element("sub", {}, "r"), " + (S", element("sub", {}, "s"), " − S", element("sub", {}, "r"), ")[1 + (αp", element("sub", {}, "c"), ")ⁿ]^(1/n − 1). "],
      "Charts: plotly.js, MIT licence. This file asks no server for anything."));
}

function build() {
  const page = document.getElementById("page");
  const figures = [];
  const grid = (name, ...content) => element("div", { class: name }, content);
  page.replaceChildren(header());
  let next = 1;
  for (const [title, drawn] of loadingSections(runs, next)) {
    figures.push(...drawn);
    page.append(section(title, grid("pair", drawn.map((f) => f.node))));
    ++next;
  }
  if (data.permeability.length > 0) {
    const flow = permeabilitySection(data.permeability, next++);
    figures.push(...flow.figures);
    page.append(section("Permeability", flow.nodes));
  }
  if (runs.some((run) => run.branches.length > 0)) {
    const loop = retentionFigure(runs, next++);
    figures.push(loop);
    page.append(section("Retention", loop.node, grid("tables uneven", fitTable(runs), loopTable(runs))));
  }
  for (const flow of data.flows) {
    const { pictures, figures: drawn } = flowSection(flow, next++);
    figures.push(...drawn);
    page.append(section(data.flows.length > 1 ? `Two-phase flow, ${flow.name}` : "Two-phase flow", pictures, grid("pair", drawn.map((f) => f.node))));
  }
  for (const stage of data.saturated) {
    const drawn = saturatedFigures(stage, next++);
    figures.push(...drawn);
    page.append(section(data.saturated.length > 1 ? `Fluid and grains, ${stage.name}` : "Fluid and grains", grid("pair", drawn.map((f) => f.node))));
  }
  for (const stage of data.unsaturated) {
    const { pictures, figures: drawn, used } = unsaturatedSections(stage, next);
    next += used;
    figures.push(...drawn);
    page.append(section(data.unsaturated.length > 1 ? `Grains and two fluids, ${stage.name}` : "Grains and two fluids", grid("pair", drawn.map((f) => f.node)), pictures));
    const pores = poreSpaceSection(stage, next);
    next += pores.maps ? 2 : 1;
    figures.push(...pores.figures);
    page.append(section(data.unsaturated.length > 1 ? `Pore space, ${stage.name}` : "Pore space", grid("pair", pores.figures.map((f) => f.node)), pores.maps));
  }
  if (runs.some((run) => run.pore.low.length > 0)) {
    const pair = distributionFigures(runs, next);
    figures.push(...pair);
    page.append(section("Pores and throats", grid("pair", pair.map((f) => f.node))));
  }
  const judged = [checksTable(), ledgerTable()].filter(Boolean);
  if (judged.length > 0) page.append(section("Checks and balance", grid("tables", judged)));
  if (data.facts.length > 0) page.append(section(data.facts.length > 1 ? "Packing and pore network" : data.facts[0].title, grid("pair", data.facts.map(factTable))));
  if (data.scalars.length > 0) page.append(element("details", {}, element("summary", {}, `All ${data.scalars.length} results by name`), grid("columns", scalarList())));
  page.append(section("Case", grid("triple", data.case.map(factTable)), source("Case file", data.case_text), source("Resolved case, SI units", data.resolved_text)));
  page.append(footer());
  // Figures are drawn once they are in the page and have a size.
  return Promise.all(figures.map((f) => f.redraw())).then(() => { root.dataset.figures = figures.length; });
}

build().then(() => { root.dataset.rendered = "yes"; }, (error) => { root.dataset.error = String(error); throw error; });
