// SPDX-License-Identifier: BSD-3-Clause
// A run's view with its legend and what is known of the picked face.

const place = (id) => document.getElementById(id);

class Panel {
  constructor(run, shared) {
    this.run = run;
    this.shared = shared;
    this.picked = null;
    const label = `Model of ${run.name}, in three dimensions`;
    this.canvas = make("canvas", { tabindex: "0", role: "application", "aria-label": label });
    this.legend = make("div", { class: "legend" });
    this.finder = make("input", { type: "number", min: "1", "aria-label": "Element id", placeholder: "element id" });
    const form = make("form", { class: "find" }, this.finder, make("button", {}, "Find"));
    this.facts = make("dl", { class: "facts", "aria-live": "polite" });
    const head = shared.runs.length > 1 ? make("h3", {}, `${run.letter}: ${run.name}`) : null;
    this.axes = make("div", { class: "axes", "aria-hidden": "true" });
    this.element = make("div", { class: "panel" }, head, make("div", { class: "stage" }, this.canvas, this.axes),
      make("div", { class: "side" }, this.legend, make("h3", {}, "Element"), form, this.facts));
    place("views").append(this.element);
    this.view = new MeshView(this.canvas, run.mesh, run.frames);
    this.view.after_drawing = (camera) => this.#show_axes(camera);
    form.addEventListener("submit", (event) => this.#find(event));
    this.#listen();
    this.pick(find_blamed_face(run));
  }

  #listen() {
    let from = null;
    this.canvas.addEventListener("pointerdown", (event) => (from = [event.clientX, event.clientY]));
    this.canvas.addEventListener("click", (event) => {
      const has_turned = from && Math.hypot(event.clientX - from[0], event.clientY - from[1]) > 4;
      if (!has_turned) this.pick_at(event.offsetX, event.offsetY);
    });
    this.canvas.addEventListener("keydown", (event) => this.#press(event));
    this.view.controls.addEventListener("change", () => this.shared.camera_moved(this));
  }

  /** The directions of the axes as the camera sees them. */
  #show_axes(camera) {
    const turn = camera.quaternion.clone().inverse();
    const arms = ["x", "y", "z"].map((name, axis) => {
      const { x, y } = new THREE.Vector3().setComponent(axis, 1).applyQuaternion(turn);
      const [right, down] = [30 + 20 * x, 30 - 20 * y];
      return `<line x1="30" y1="30" x2="${right}" y2="${down}"/>
        <text x="${30 + 26 * x}" y="${34 - 26 * y}">${name}</text>`;
    });
    this.axes.innerHTML = `<svg width="60" height="60">${arms.join("")}</svg>`;
  }

  #press(event) {
    const { view, shared } = this;
    const keys = {
      ArrowLeft: () => view.turn(10, 0), ArrowRight: () => view.turn(-10, 0),
      ArrowUp: () => view.turn(0, 10), ArrowDown: () => view.turn(0, -10),
      "+": () => view.turn(0, 0, 0.85), "=": () => view.turn(0, 0, 0.85), "-": () => view.turn(0, 0, 1 / 0.85),
      f: () => shared.look_along("fit"), " ": () => shared.toggle_play(),
      ",": () => shared.step(-1), ".": () => shared.step(1),
    };
    const act = keys[event.key] ?? keys[event.key.toLowerCase()];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
    shared.camera_moved(this);
  }

  #find(event) {
    event.preventDefault();
    const id = Number(this.finder.value);
    const face = find_face_of_element(this.run.mesh, id);
    const things = this.view.things.find(({ element }) => element.includes(id));
    const thing = face === null && things ? { things, i: things.element.indexOf(id) } : null;
    this.pick(face, thing);
    if (face !== null || thing !== null) return;
    this.facts.replaceChildren(make("dd", {}, `Nothing of element ${id} is on the outside.`));
  }

  /** Picks what is nearest to the eye at a place of the canvas. */
  pick_at(x, y) {
    const thing = this.view.find_thing(x, y);
    const is_before = thing !== null && thing.distance <= this.view.distance_of_face(x, y) + (thing.things.radius ?? 0);
    this.pick(is_before ? null : this.view.find_face(x, y), is_before ? thing : null);
  }

  /** A face, or a line or particle as find_thing gives it. */
  pick(face, thing = null) {
    this.picked = face;
    this.picked_thing = thing;
    this.view.mark_face(face);
    this.view.mark_thing(thing);
    this.describe();
  }

  describe() {
    if (this.picked === null && !this.picked_thing) {
      this.facts.replaceChildren(make("dd", { class: "muted" }, "Click a face, line or particle to ask about it."));
      return;
    }
    const { frame } = this.view;
    const rows = this.picked_thing ? describe_thing(this.run, this.picked_thing, frame)
      : describe_face(this.run, this.picked, frame);
    this.facts.replaceChildren(...rows.flatMap(([name, value]) => [make("dt", {}, name), make("dd", {}, value)]));
  }

  /** key_of(things, i) is the kind of a face, line or particle, from 1; 0: of none. */
  show_kinds(names, key_of) {
    const { faces, lines, particles } = this.run.mesh;
    const colour_of = (key) => (key > 0 ? kind_colour(key - 1) : no_colour);
    this.view.colour((face) => colour_of(key_of(faces, face)));
    this.view.colour_things((things, i) => colour_of(key_of(things, i)));
    const count = (number) => [count_faces(faces, number, key_of), ...[lines, particles].map((things) =>
      things.owner.filter((_, i) => key_of(things, i) === number).length)];
    const words = ["face", "line", "particle"];
    const describe = (number) => count(number).flatMap((n, i) => (n > 0 ? [show_count(n, words[i])] : [])).join(", ");
    const items = names.map((name, i) => {
      const number = i + 1;
      const box = make("input", { type: "checkbox" });
      box.checked = !this.view.hidden.has(number);
      box.addEventListener("change", () => this.#hide(number, !box.checked));
      const swatch = make("span", { class: "swatch", style: `background:${css_colour(kind_colour(i))}` });
      const is_owner = this.shared.colour === "owner";
      return make("li", {}, make("label", {}, is_owner ? box : null, swatch, name,
        make("span", { class: "muted" }, describe(number) || "nothing")));
    });
    if (describe(0)) {
      const swatch = make("span", { class: "swatch", style: `background:${css_colour(no_colour)}` });
      items.push(make("li", {}, make("label", {}, swatch, "of no surface",
        make("span", { class: "muted" }, describe(0)))));
    }
    this.legend.replaceChildren(make("ul", { class: "kinds" }, ...items));
  }

  #hide(number, is_hidden) {
    if (is_hidden) this.view.hidden.add(number);
    else this.view.hidden.delete(number);
    this.view.place_faces();
  }

  show_scale(name, [low, high], colour_of) {
    this.view.colour(colour_of);
    this.view.colour_things((_, i, point) => colour_of(null, point));
    const at = (t) => make("span", {}, show_short(low + t * (high - low)));
    this.legend.replaceChildren(make("div", { class: "scale-name" }, name),
      make("div", { class: "scale", style: `background:${scale_gradient()}` }),
      make("div", { class: "scale-values" }, at(0), at(0.5), at(1)));
  }
}

/** Faces of a kind; the facets of a face of second order are one. */
function count_faces(faces, kind, key_of) {
  let n = 0;
  for (let i = 0; i < faces.n; ++i) {
    const is_next_facet = i > 0 && faces.element[i] === faces.element[i - 1] && faces.side[i] === faces.side[i - 1];
    if (!is_next_facet && key_of(faces, i) === kind) ++n;
  }
  return n;
}
