// SPDX-License-Identifier: BSD-3-Clause
// Key figures, tables, warnings.

/** A table with a caption; columns are [title, row => value, is_number]. */
function make_table(caption, columns, rows) {
  const cell = (row) => ([, value, is_number]) => {
    const content = value(row);
    return make("td", { class: is_number ? "number" : undefined }, is_number ? show_number(content) : content ?? "–");
  };
  const head = columns.map(([title, , is_number]) =>
    make("th", { scope: "col", class: is_number ? "number" : undefined }, title));
  const table = make("table", {}, make("caption", {}, caption), make("thead", {}, make("tr", {}, ...head)),
    make("tbody", {}, ...rows.map((row) => make("tr", {}, ...columns.map(cell(row))))));
  return make("div", { class: "table", tabindex: "0", role: "region", "aria-label": caption }, table);
}

/** The line that made a surface: of the deck file itself, whatever it includes. */
function surface_line(run, line) {
  if (!line) return "–";
  if (!run.deck.has_surface_lines) return String(line);
  return make("a", { href: `#deck-${run.number}-0-${line}` }, String(line));
}

function surface_tables(run) {
  const { surfaces } = run;
  if (!surfaces) return [];
  const tables = [make_table("Contact surfaces", [
    ["surface", (row) => row.name],
    ["made by", (row) => row.command.toLowerCase()],
    ["line", (row) => surface_line(run, row.line)],
    ["claimed", (row) => row.claimed, true],
    ["owned", (row) => row.owned, true],
    ["triangles", (row) => row.triangles, true],
    ["quads", (row) => row.quadrilaterals, true],
    ["lofted", (row) => row.lofted.elements, true],
    ["nodes", (row) => row.nodes, true],
    ["area", (row) => row.area, true],
  ], surfaces.surfaces)];
  const lost = surfaces.surfaces.flatMap((of) => of.lost_to.map((row) => ({ ...row, loser: of.name })));
  if (lost.length > 0) {
    tables.push(make_table("Claims lost to earlier surfaces", [
      ["surface", (row) => row.loser],
      ["lost to", (row) => row.surface],
      ["faces", (row) => row.faces, true],
      ["lofted", (row) => row.lofted, true],
      ["nodes", (row) => row.nodes, true],
    ], lost));
  }
  return tables;
}

/** Pairs as they were set up and, with a summary, what they did. */
function pair_table(run) {
  const set_up = run.surfaces?.pairs ?? [];
  const done = run.summary?.pairs ?? [];
  const rows = set_up.map((pair, i) => ({ number: i + 1, ...pair, ...done.find((one) => one.number === i + 1) }));
  const all = rows.length > 0 ? rows : done;
  if (all.length === 0) return [];
  const touched = all.filter((pair) => pair.peak_force > 0 || pair.contact_time > 0);
  const shown = touched.length > 0 ? touched : all.slice(0, 200);
  const others = all.length - shown.length;
  const caption = touched.length > 0 && others > 0
    ? `Contact pairs that touched (${others} more never did)` : "Contact pairs";
  return [make_table(caption, [
    ["no", (row) => row.number, true],
    ["first", (row) => row.first],
    ["second", (row) => row.second],
    ["interaction", (row) => row.interaction],
    ["law", (row) => row.law],
    ["contact time", (row) => row.contact_time, true],
    ["peak force", (row) => row.peak_force, true],
    ["deepest penetration", (row) => row.deepest_penetration, true],
    ["of thickness", (row) => row.deepest_share, true],
    ["friction work", (row) => row.friction_work, true],
  ], shown)];
}

function block_table(run) {
  if (!run.mesh) return [];
  return [make_table("Element blocks", [
    ["block", (row) => row.name],
    ["elements", (row) => row.elements, true],
    ["type", (row) => row.shape],
  ], run.mesh.blocks)];
}

function energy_table(run) {
  const energies = run.summary?.run?.energies;
  if (!energies) return [];
  const rows = Object.entries(energies).filter(([name]) => name !== "error_share");
  return [make_table("Energies at the end", [
    ["energy", ([name]) => name.replaceAll("_", " ")],
    ["value", ([, value]) => value, true],
  ], rows)];
}

function show_tables(place, runs) {
  for (const run of runs) {
    if (runs.length > 1) place.append(make("h3", {}, `${run.letter}: ${run.name}`));
    const tables = [...surface_tables(run), ...pair_table(run), ...energy_table(run), ...block_table(run)];
    place.append(make("div", { class: "tables" }, ...tables));
    if (!run.surfaces) place.append(make("p", { class: "note" }, "No contact surfaces are known of this run."));
  }
}

/** The pair with the largest value of a key. */
function largest_pair(run, key) {
  const known = (run.summary?.pairs ?? []).filter((pair) => pair[key] > 0);
  return known.reduce((a, b) => (a && a[key] >= b[key] ? a : b), undefined);
}

/** Key figures: [name, value, more]. */
function figures_of(run) {
  const { summary, mesh, frames } = run;
  const figures = [];
  const states = { done: "done", failed: "failed", stopped: "stopped", running: "not ended" };
  const stages = { parse: "the deck was read alone", tables: "surfaces alone, no run", check: "checked, not run" };
  if (summary) {
    const code = summary.exit_code ? `exit code ${summary.exit_code}` : "";
    const more = stages[summary.stage] ?? summary.run?.ended_by ?? code;
    figures.push(["State", states[summary.state] ?? summary.state, more]);
  }
  if (summary?.run) {
    const { steps, time, termination_time, energies, wall_time } = summary.run;
    figures.push(["Time", show_number(time), `of ${show_number(termination_time)}, ${show_count(steps, "step")}`]);
    figures.push(["Energy error", `${show_number(Number((100 * energies.error_share).toPrecision(2)))} %`,
      "of the largest energy"]);
    const force = largest_pair(run, "peak_force");
    if (force) figures.push(["Peak contact force", show_number(force.peak_force), `${force.first} – ${force.second}`]);
    const deep = largest_pair(run, "deepest_penetration");
    if (deep) {
      const share = deep.deepest_share ? `, ${(100 * deep.deepest_share).toPrecision(2)} % of its thickness` : "";
      figures.push(["Deepest penetration", show_number(deep.deepest_penetration),
        `${deep.first} – ${deep.second}${share}`]);
    }
    if (wall_time) figures.push(["Run took", `${wall_time.whole.toPrecision(3)} s`, show_count(summary.threads, "thread")]);
  } else if (frames && frames.times.length > 0) {
    figures.push(["Time", show_number(frames.times.at(-1)), `${show_count(frames.times.length, "time")} shown`]);
  }
  if (mesh) {
    const more = `${show_count(mesh.nodes, "node")}, ${show_count(mesh.blocks.length, "block")}`;
    figures.push(["Elements", String(mesh.elements), more]);
  }
  const counts = ["error", "warning"].map((severity) => problems_of(run).filter((p) => p.severity === severity).length);
  if (summary) figures.push(["Warnings", String(counts[1]), counts[0] > 0 ? show_count(counts[0], "error") : "no errors"]);
  return figures;
}

function show_figures(place, runs) {
  if (runs.length > 1) {
    place.append(figure_table(runs));
    return;
  }
  const cards = figures_of(runs[0]).map(([name, value, more]) =>
    make("div", { class: "figure" }, make("dt", {}, name), make("dd", {}, value), make("dd", { class: "more" }, more)));
  place.append(make("dl", { class: `figures ${runs[0].summary?.state ?? "unknown"}` }, ...cards));
}

/** The figures of several runs, a column for each. */
function figure_table(runs) {
  const figures = runs.map((run) => new Map(figures_of(run).map(([name, ...rest]) => [name, rest])));
  const names = [...new Set(figures.flatMap((of) => [...of.keys()]))];
  const column = (run, i) => [`${run.letter}: ${run.name}`, (name) => {
    const [value, more] = figures[i].get(name) ?? ["–", ""];
    return make("span", {}, value, make("span", { class: "source" }, more));
  }];
  return make_table("Key figures", [["", (name) => name], ...runs.map(column)], names);
}

/** Errors and warnings with all their places; those of a summary have the first alone. */
function problems_of(run) {
  const errors_first = (list) => [...list].sort((a, b) => (b.severity === "error") - (a.severity === "error"));
  if (run.problems.length > 0 || !run.summary) return errors_first(run.problems);
  const of = (list, severity) => list.map((one) => ({
    severity, id: one.id ?? "", text: one.text, hint: "", alike: Math.max(0, (one.count ?? 1) - 1),
    places: one.file ? [{ file: one.file, line: one.line, column: one.column }] : [],
  }));
  return [...of(run.summary.errors, "error"), ...of(run.summary.warnings, "warning")];
}

function show_problem(run, problem) {
  const places = problem.places.map(({ file, line, column }) => {
    const id = line_id(run, file, line);
    const name = `${file}:${line}:${column}`;
    const text = deck_line(run, file, line);
    return make("div", { class: "place" }, id ? make("a", { href: `#${id}` }, name) : name,
      text ? make("code", {}, text.trim()) : null);
  });
  const more = problem.alike > 0 ? ` (and ${problem.alike} more of the kind)` : "";
  return make("li", { class: problem.severity }, make("strong", {}, problem.severity), " ",
    problem.text + (problem.hint ? `; ${problem.hint}` : "") + more,
    problem.id ? make("span", { class: "source" }, problem.id) : null, ...places);
}

function show_problems(place, runs) {
  for (const run of runs) {
    const problems = problems_of(run);
    if (runs.length > 1) place.append(make("h3", {}, `${run.letter}: ${run.name}`));
    const none = run.summary ? "No warnings, no errors." : "Not known: there is no summary of the run.";
    place.append(problems.length === 0 ? make("p", {}, none)
      : make("ul", { class: "problems" }, ...problems.map((problem) => show_problem(run, problem))));
  }
}
