// SPDX-License-Identifier: BSD-3-Clause
// Puts the report together: all panels under one time and one colour, and what stands below them.

/** All panels, the time and what they are coloured by. */
class Report {
  constructor(runs) {
    this.runs = runs;
    this.panels = [];
    this.colour = "owner";
    this.move_cursors = () => {};
    const drawn = runs.filter((run) => run.mesh && run.mesh.points > 0);
    this.#make_panels(drawn);
    place("views").classList.toggle("several", drawn.length > 1);
    const longest = drawn.reduce((a, b) => ((b.frames?.times.length ?? 0) > (a?.frames?.times.length ?? 0) ? b : a), null);
    this.times = longest?.frames?.times ?? [];
    if (drawn.length === 0) place("views").append(make("p", { class: "note" }, "There is no mesh to draw."));
    this.#fill_choices();
    this.#listen();
    this.show_time(Math.max(0, this.times.length - 1));
    this.look_along("fit");
  }

  /** Where a browser cannot draw in three dimensions, everything else is shown all the same. */
  #make_panels(runs) {
    try {
      for (const run of runs) this.panels.push(new Panel(run, this));
    } catch (error) {
      this.panels = [];
      const text = `This browser does not draw in three dimensions (WebGL: ${error.message}).`;
      place("views").replaceChildren(make("p", { class: "note bad" }, text));
    }
  }

  /** All views from one place, from which each shows its whole mesh. */
  look_along(way) {
    for (const { view } of this.panels) view.look_along(way);
    const away = ({ view }) => view.camera.position.length();
    const farthest = this.panels.reduce((a, b) => (a && away(a) >= away(b) ? a : b), null);
    if (farthest) this.camera_moved(farthest);
  }

  /** The frame of a run nearest to the time of the slider. */
  frame_of(run) {
    const now = this.times[this.now] ?? 0;
    const away = (run.frames?.times ?? [0]).map((time) => Math.abs(time - now));
    return away.indexOf(Math.min(...away));
  }

  #fill_choices() {
    const names = new Set(this.panels.flatMap(({ run }) => (run.frames?.fields ?? []).map((field) => field.name)));
    const options = [["owner", "contact surface"], ["block", "element block"]];
    if (this.panels.some(({ run }) => run.frames?.moved.length > 0)) options.push(["|displacement|", "|displacement|"]);
    for (const name of names) options.push([name, name]);
    place("colour").append(...options.map(([value, text]) => make("option", { value }, text)));
    place("scale").append(...[0, 1, 2, 5, 10, 50, 100, 1000].map((factor) =>
      make("option", { value: factor, selected: factor === 1 }, factor === 0 ? "none" : `× ${factor}`)));
    place("time").max = Math.max(0, this.times.length - 1);
    place("timeline").hidden = this.times.length < 2;
    const faces = this.panels.reduce((sum, { run }) => sum + run.mesh.faces.n, 0);
    place("lines").checked = faces > 0 && faces <= 20000;
    const wanted = new URLSearchParams(location.search).get("colour");
    if (wanted && options.some(([value]) => value === wanted)) place("colour").value = wanted;
  }

  #listen() {
    place("colour").addEventListener("change", () => this.recolour());
    place("range").addEventListener("change", () => this.recolour());
    place("scale").addEventListener("change", () => this.show_time(this.now));
    place("lines").addEventListener("change", () => this.show_lines());
    place("time").addEventListener("input", () => this.show_time(Number(place("time").value)));
    place("play").addEventListener("click", () => this.toggle_play());
    place("picture").addEventListener("click", () => this.save_pictures());
    for (const button of document.querySelectorAll("[data-view]")) {
      button.addEventListener("click", () => this.look_along(button.dataset.view));
    }
    this.show_lines();
  }

  show_lines() {
    for (const { view } of this.panels) view.show_edges(place("lines").checked);
  }

  show_time(now) {
    this.now = now;
    place("time").value = now;
    const text = this.times.length > 0 ? `time ${show_number(this.times[now])}` : "";
    place("time-text").textContent = text;
    place("time").setAttribute("aria-valuetext", text);
    for (const panel of this.panels) {
      panel.view.move(this.frame_of(panel.run), Number(place("scale").value));
      panel.describe();
    }
    this.recolour();
    this.move_cursors(this.times[now] ?? null);
  }

  step(by) {
    const n = this.times.length;
    if (n > 0) this.show_time((this.now + by + n) % n);
  }

  toggle_play() {
    const plays = this.timer !== undefined;
    clearInterval(this.timer);
    this.timer = plays || this.times.length < 2 ? undefined : setInterval(() => this.step(1), 120);
    place("play").textContent = this.timer === undefined ? "▶" : "❚❚";
    place("play").setAttribute("aria-label", this.timer === undefined ? "Play" : "Stop");
  }

  camera_moved(panel) {
    if (this.is_following) return;
    this.is_following = true;
    for (const other of this.panels) if (other !== panel) other.view.follow(panel.view);
    this.is_following = false;
  }

  recolour() {
    this.colour = place("colour").value;
    const is_kind = this.colour === "owner" || this.colour === "block";
    place("range-label").hidden = is_kind;
    if (is_kind) for (const panel of this.panels) this.#colour_kinds(panel);
    else this.#colour_scale();
  }

  #colour_kinds(panel) {
    const { mesh } = panel.run;
    if (this.colour === "owner") panel.show_kinds(mesh.owners, ({ owner }, i) => owner[i]);
    else panel.show_kinds(mesh.blocks.map(({ name }) => name), ({ block }, i) => block[i] + 1);
  }

  /** The value at a point of a face (null: of a line), NaN where there is none; null when the run does not have it. */
  #value_of({ run, view }) {
    const frame = view.frame;
    if (this.colour === "|displacement|") {
      const { moved, step } = run.frames ?? { moved: [] };
      if (moved.length === 0) return null;
      const n = run.mesh.points;
      const at = 3 * n * frame;
      return (_, point) => step * Math.hypot(moved[at + point], moved[at + n + point], moved[at + 2 * n + point]);
    }
    const field = run.frames?.fields.find(({ name }) => name === this.colour);
    if (!field) return null;
    if (field.nodal) return (_, point) => field_value(field, frame, point);
    return (face) => (face === null ? NaN : field_value(field, frame, face));
  }

  #range_of(panel, value) {
    const field = panel.run.frames.fields.find(({ name }) => name === this.colour);
    const asked = place("range").value;
    if (field && asked !== "now") return asked === "usual" ? field.usual : [field.lowest, field.highest];
    let low = Infinity;
    let high = -Infinity;
    const take = (face, point) => {
      const at = value(face, point);
      if (at < low) low = at;
      if (at > high) high = at;
    };
    const { faces, lines, particles } = panel.run.mesh;
    for (let i = 0; i < faces.n; ++i) for (let k = 0; k < 4; ++k) take(i, faces.corners[k][i]);
    for (const { n, corners } of [lines, particles]) for (let i = 0; i < n; ++i) take(null, corners[0][i]);
    return low <= high ? [low, high] : [0, 0];
  }

  /** One range for all runs, so that colours compare. */
  #colour_scale() {
    const values = this.panels.map((panel) => this.#value_of(panel));
    const ranges = this.panels.flatMap((panel, i) => (values[i] ? [this.#range_of(panel, values[i])] : []));
    const low = Math.min(...ranges.map(([least]) => least));
    const high = Math.max(...ranges.map(([, most]) => most));
    const factor = high > low ? 255 / (high - low) : 0;
    this.panels.forEach((panel, i) => {
      const value = values[i] ?? (() => NaN);
      const field = panel.run.frames?.fields.find(({ name }) => name === this.colour);
      const beyond = field?.highest > high * (1 + 1e-6) ? `, up to ${show_short(field.highest)} in places` : "";
      const name = values[i] ? this.colour + beyond : `${this.colour}: not in these results`;
      panel.show_scale(name, [low, high], (face, point) => {
        const at = value(face, point);
        return Number.isNaN(at) ? no_colour : scale_colours[Math.max(0, Math.min(255, Math.round(factor * (at - low))))];
      });
    });
  }

  save_pictures() {
    for (const { view, run } of this.panels) {
      view.draw_now();
      view.canvas.toBlob((blob) => {
        const link = make("a", { href: URL.createObjectURL(blob), download: `${run.name.replace(/\W+/g, "_")}.png` });
        link.click();
        setTimeout(() => URL.revokeObjectURL(link.href), 1000);
      });
    }
  }

  restyle() {
    for (const { view } of this.panels) view.restyle();
    this.move_cursors = show_charts(place("charts"), this.runs);
    this.move_cursors(this.times[this.now] ?? null);
  }
}

function show_notes(runs) {
  for (const run of runs) {
    if (run.notes.length === 0) continue;
    const head = runs.length > 1 ? `What ${run.letter} does not show` : "What is not shown";
    place("notes").append(make("h3", {}, head), make("ul", {}, ...run.notes.map((text) => make("li", {}, text))));
  }
}

function show_licences(version) {
  place("licences").textContent =
    `The page is of contactsim ${version}, BSD 3-Clause. The model is drawn by three.js r${THREE.REVISION}, ` +
    `© three.js authors, the curves by Chart.js ${Chart.version}, © Chart.js Contributors; both under the MIT licence:`;
}

function show_title(runs) {
  const titles = [...new Set(runs.map((run) => run.title || run.name))];
  place("title").textContent = titles.join(" · ");
  place("under-title").textContent = runs.map((run) => (runs.length > 1 ? `${run.letter}: ` : "") + run.name).join(" · ");
}

async function start() {
  if (typeof DecompressionStream === "undefined") throw new Error("this browser is too old to unpack the report");
  const data = JSON.parse(place("report-data").textContent);
  const { runs } = data;
  for (const [number, run] of runs.entries()) {
    run.number = number;
    run.letter = String.fromCharCode(65 + number);
    run.mesh = run.mesh ? await read_mesh(run.mesh) : null;
    run.frames = run.mesh && run.frames?.times.length > 0 ? await read_frames(run.frames, run.mesh) : null;
  }
  show_title(runs);
  show_figures(place("figures"), runs);
  show_tables(place("tables"), runs);
  show_problems(place("problem-list"), runs);
  show_deck(place("deck-files"), runs);
  show_notes(runs);
  show_licences(data.version);
  const report = new Report(runs);
  report.restyle();
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", () => report.restyle());
  document.documentElement.dataset.ready = "yes";
  window.report = report;
}

start().catch((error) => {
  place("failure").hidden = false;
  place("failure").textContent = `The report cannot be shown: ${error.message}.`;
  console.error(error);
});
