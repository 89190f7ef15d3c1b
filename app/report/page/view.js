// SPDX-License-Identifier: BSD-3-Clause
// A mesh on a stage.

/** The place of a segment, or of a point, nearest to the mouse: how far from the eye, and how far off [pixels]. */
function nearest_of([a, b = a], mouse) {
  const along = { x: b.x - a.x, y: b.y - a.y };
  const squared = along.x ** 2 + along.y ** 2;
  const share = squared > 0 ? ((mouse.x - a.x) * along.x + (mouse.y - a.y) * along.y) / squared : 0;
  const t = Math.min(1, Math.max(0, share));
  const off = Math.hypot(a.x + t * along.x - mouse.x, a.y + t * along.y - mouse.y);
  return { distance: a.distance + t * (b.distance - a.distance), off };
}

/** A run's mesh: what is shown of it, where its points are, how it is coloured, which face is under the mouse. */
class MeshView extends Stage {
  /** mesh, frames as data.js reads them; frames null without results. */
  constructor(canvas, mesh, frames) {
    super(canvas, mesh.position);
    Object.assign(this, { mesh, frames, frame: 0, scale: 1, hidden: new Set() });
    this.#make_faces();
    this.#make_lines();
    const lines = new THREE.LineBasicMaterial({ vertexColors: THREE.VertexColors });
    this.things = [this.#make_things(mesh.lines, THREE.LineSegments, lines, 2)];
    for (const radius of new Set(mesh.blocks.map((block) => block.radius))) {
      const particles = of_radius(mesh.particles, mesh.blocks, radius);
      if (particles.n > 0) this.things.push(this.#make_things(particles, THREE.Points, this.ball_material(radius), 1));
    }
  }

  #make_faces() {
    const { n, corners } = this.mesh.faces;
    const corner = [];
    const face = [];
    for (let i = 0; i < n; ++i) {
      const [a, b, c, d] = corners.map((list) => list[i]);
      corner.push(a, b, c);
      face.push(i);
      if (c === d) continue;
      corner.push(a, c, d);
      face.push(i);
    }
    this.corner = Uint32Array.from(corner);
    this.face_of_triangle = Uint32Array.from(face);
    this.shell = new THREE.BufferGeometry();
    this.shell.setAttribute("position", new THREE.BufferAttribute(new Float32Array(3 * corner.length), 3));
    this.shell.setAttribute("color", new THREE.BufferAttribute(new Uint8Array(3 * corner.length), 3, true));
    const material = new THREE.MeshPhongMaterial({
      vertexColors: THREE.VertexColors, flatShading: true, side: THREE.DoubleSide, shininess: 12, specular: 0x222222,
      polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1,
    });
    this.surface = new THREE.Mesh(this.shell, material);
    this.surface.frustumCulled = false;
    this.scene.add(this.surface);
  }

  #make_lines() {
    const shared = new THREE.BufferAttribute(this.point, 3);
    const add = (material, things) => {
      const geometry = new THREE.BufferGeometry();
      geometry.setAttribute("position", shared);
      const object = new things(geometry, material);
      object.frustumCulled = false;
      this.scene.add(object);
      return object;
    };
    this.shared = shared;
    this.edges = add(new THREE.LineBasicMaterial({ transparent: true, opacity: 0.45 }), THREE.LineSegments);
    this.edges.visible = false;
    this.mark = add(new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }), THREE.Mesh);
    this.frame_of_mark = add(new THREE.LineBasicMaterial({ depthTest: false }), THREE.LineSegments);
    this.dot_of_mark = add(new THREE.PointsMaterial({ size: 7, sizeAttenuation: false, depthTest: false }), THREE.Points);
    this.frame_of_mark.renderOrder = this.dot_of_mark.renderOrder = 1;
    this.mark_face(null);
  }

  /** Lines or particles with points and colours of their own. */
  #make_things(things, kind, material, n_ends) {
    const geometry = new THREE.BufferGeometry();
    const array = (type, ...more) => new THREE.BufferAttribute(new type(3 * n_ends * things.n), 3, ...more);
    geometry.setAttribute("position", array(Float32Array));
    geometry.setAttribute("color", array(Uint8Array, true));
    const object = new kind(geometry, material);
    object.frustumCulled = false;
    this.scene.add(object);
    return { ...things, geometry, n_ends };
  }

  is_shown(face) {
    const { owner, shown_from, hidden_from } = this.mesh.faces;
    if (this.hidden.has(owner[face])) return false;
    if (!hidden_from || !this.frames) return true;
    const at = this.frames.positions[this.frame];
    return at >= shown_from[face] && at < hidden_from[face];
  }

  /** Moves the mesh to a frame, drawn with displacements times `scale`. */
  move(frame, scale) {
    this.frame = frame;
    this.scale = scale;
    const { position } = this.mesh;
    const moved = this.frames && this.frames.moved.length > 0 ? this.frames.moved : null;
    const step = moved ? this.frames.step * scale : 0;
    const n = this.mesh.points;
    const first = frame * 3 * n;
    for (let i = 0; i < n; ++i) {
      for (let axis = 0; axis < 3; ++axis) {
        const by = moved ? step * moved[first + axis * n + i] : 0;
        this.point[3 * i + axis] = position[3 * i + axis] + by;
      }
    }
    this.shared.needsUpdate = true;
    this.place_faces();
  }

  /** Gives the triangles their points; those of hidden faces shrink to one. */
  place_faces() {
    const { corner, point } = this;
    const to = this.shell.attributes.position.array;
    const n_triangles = this.face_of_triangle.length;
    for (let t = 0; t < n_triangles; ++t) {
      const is_shown = this.is_shown(this.face_of_triangle[t]);
      for (let k = 0; k < 3; ++k) {
        const at = 3 * (3 * t + k);
        const from = 3 * corner[is_shown ? 3 * t + k : 3 * t];
        to[at] = point[from];
        to[at + 1] = point[from + 1];
        to[at + 2] = point[from + 2];
      }
    }
    this.shell.attributes.position.needsUpdate = true;
    this.shell.boundingSphere = null;
    if (this.edges.visible) this.#place_edges();
    this.#place_things();
    this.draw();
  }

  #place_things() {
    for (const { n, n_ends, corners, owner, geometry } of this.things) {
      const to = geometry.attributes.position.array;
      const index = [];
      for (let i = 0; i < n * n_ends; ++i) {
        const thing = Math.floor(i / n_ends);
        const from = 3 * corners[i % n_ends][thing];
        to.set(this.point.subarray(from, from + 3), 3 * i);
        if (!this.hidden.has(owner[thing])) index.push(i);
      }
      geometry.attributes.position.needsUpdate = true;
      geometry.setIndex(index);
    }
  }

  #place_edges() {
    const { n, corners } = this.mesh.faces;
    const index = [];
    for (let i = 0; i < n; ++i) {
      if (!this.is_shown(i)) continue;
      for (let k = 0; k < 4; ++k) {
        const a = corners[k][i];
        const b = corners[(k + 1) % 4][i];
        if (a !== b) index.push(a, b);
      }
    }
    this.edges.geometry.setIndex(new THREE.BufferAttribute(Uint32Array.from(index), 1));
  }

  show_edges(is_visible) {
    this.edges.visible = is_visible;
    if (is_visible) this.#place_edges();
    this.draw();
  }

  /** Colours the faces: colour_of(face, point) gives [r, g, b] at a corner of a face. */
  colour(colour_of) {
    const to = this.shell.attributes.color.array;
    for (let t = 0; t < this.face_of_triangle.length; ++t) {
      for (let k = 0; k < 3; ++k) {
        const colour = colour_of(this.face_of_triangle[t], this.corner[3 * t + k]);
        const at = 3 * (3 * t + k);
        to[at] = colour[0];
        to[at + 1] = colour[1];
        to[at + 2] = colour[2];
      }
    }
    this.shell.attributes.color.needsUpdate = true;
    this.draw();
  }

  /** Colours lines and particles: colour_of(things, i, point) as of faces. */
  colour_things(colour_of) {
    for (const things of this.things) {
      const to = things.geometry.attributes.color.array;
      for (let i = 0; i < things.n * things.n_ends; ++i) {
        const thing = Math.floor(i / things.n_ends);
        to.set(colour_of(things, thing, things.corners[i % things.n_ends][thing]), 3 * i);
      }
      things.geometry.attributes.color.needsUpdate = true;
    }
    this.draw();
  }

  /** The face under a place of the canvas, in pixels from its upper left; null of none. */
  find_face(x, y) {
    const hit = this.#hit(x, y);
    return hit ? this.face_of_triangle[hit.faceIndex] : null;
  }

  #hit(x, y) {
    const at = new THREE.Vector2((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
    const ray = new THREE.Raycaster();
    this.camera.updateMatrixWorld();
    ray.setFromCamera(at, this.camera);
    return ray.intersectObject(this.surface)[0];
  }

  /** The line or particle under a place of the canvas that is nearest to the eye, {things, i, distance}; null of none. */
  find_thing(x, y) {
    const { clientWidth, clientHeight } = this.canvas;
    const reach = 5; // pixels beside a line or a dot that still mean it
    const mouse = new THREE.Vector2(x, y);
    let nearest = null;
    for (const things of this.things) {
      for (let i = 0; i < things.n; ++i) {
        if (this.hidden.has(things.owner[i])) continue;
        const ends = things.corners.slice(0, things.n_ends).map((list) => this.#see(list[i], clientWidth, clientHeight));
        const { distance, off } = nearest_of(ends, mouse);
        const radius = things.n_ends === 1 && things.radius ? this.pixels_of(things.radius, distance, clientHeight) : 0;
        const is_it = off <= Math.max(radius, reach) && (nearest === null || distance < nearest.distance);
        if (is_it) nearest = { things, i, distance };
      }
    }
    return nearest;
  }

  /** Where a point is on the canvas [pixels], and how far from the eye. */
  #see(point, width, height) {
    const at = new THREE.Vector3().fromArray(this.point, 3 * point);
    const distance = at.distanceTo(this.camera.position);
    at.project(this.camera);
    return { x: ((at.x + 1) / 2) * width, y: ((1 - at.y) / 2) * height, distance };
  }

  /** How far a face is from the eye at a place of the canvas. */
  distance_of_face(x, y) {
    const hit = this.#hit(x, y);
    return hit ? hit.distance : Infinity;
  }

  /** Marks a line or particle; null: none. */
  mark_thing(found) {
    const ends = found === null ? [] : found.things.corners.slice(0, found.things.n_ends).map((list) => list[found.i]);
    if (ends.length === 2) this.frame_of_mark.geometry.setIndex(ends);
    this.dot_of_mark.geometry.setIndex(ends);
    this.draw();
  }

  /** Fills a face and draws a frame around it; null: of none. */
  mark_face(face) {
    const of = face === null ? [] : this.mesh.faces.corners.map((list) => list[face]);
    this.mark.geometry.setIndex(of.length > 0 ? [of[0], of[1], of[2], of[0], of[2], of[3]] : []);
    this.frame_of_mark.geometry.setIndex(of.flatMap((point, k) => [point, of[(k + 1) % 4]]));
    this.draw();
  }

  /** Takes over the colours of the style sheet. */
  restyle() {
    this.edges.material.color.set(style_colour("--mesh-line"));
    this.mark.material.color.set(style_colour("--mark"));
    this.frame_of_mark.material.color.set(style_colour("--mark"));
    this.dot_of_mark.material.color.set(style_colour("--mark"));
    this.draw();
  }
}
