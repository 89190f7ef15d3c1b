// SPDX-License-Identifier: BSD-3-Clause
// A mesh in three dimensions, by three.js.

/** A run's mesh on a canvas. It draws when something has changed. */
class MeshView {
  /** mesh, frames as data.js reads them; frames null without results. */
  constructor(canvas, mesh, frames) {
    Object.assign(this, { canvas, mesh, frames, frame: 0, scale: 1, hidden: new Set(), is_due: false });
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, alpha: true });
    this.renderer.setPixelRatio(Math.min(window.devicePixelRatio, 2));
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(30, 1, 0.01, 100);
    this.camera.up.set(0, 0, 1);
    this.controls = new THREE.OrbitControls(this.camera, canvas);
    this.controls.enableKeys = false;
    this.controls.screenSpacePanning = true;
    this.controls.addEventListener("change", () => this.draw());
    this.controls.addEventListener("start", () => (this.is_fitted = null));
    this.point = new Float32Array(mesh.position);
    this.#make_faces();
    this.#make_lines();
    this.#light();
    this.#measure();
    this.look_along("fit");
    new ResizeObserver(() => this.#resize()).observe(canvas);
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
    this.rods = add(new THREE.LineBasicMaterial(), THREE.LineSegments);
    const [from, to] = this.mesh.lines.corners;
    this.rods.geometry.setIndex(Array.from({ length: 2 * this.mesh.lines.n }, (_, i) => (i % 2 ? to : from)[i >> 1]));
    this.dots = add(new THREE.PointsMaterial({ size: 6, sizeAttenuation: false }), THREE.Points);
    this.dots.geometry.setIndex(Array.from(this.mesh.particles));
    this.mark = add(new THREE.MeshBasicMaterial({ side: THREE.DoubleSide }), THREE.Mesh);
    this.frame_of_mark = add(new THREE.LineBasicMaterial({ depthTest: false }), THREE.LineSegments);
    this.frame_of_mark.renderOrder = 1;
    this.mark_face(null);
  }

  #light() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0xb4bac6, 0.8));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.4);
    lamp.position.set(0.4, 0.6, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera);
  }

  /** The middle and the radius of the mesh at the start. */
  #measure() {
    let squared = 0;
    const x = this.mesh.position;
    for (let i = 0; i < x.length; i += 3) squared = Math.max(squared, x[i] ** 2 + x[i + 1] ** 2 + x[i + 2] ** 2);
    this.radius = Math.sqrt(squared) || 1;
  }

  /** Puts the camera before the whole mesh: "x", "y", "z", or "fit" from above at a slant. */
  look_along(way) {
    const directions = { x: [1, 0, 0], y: [0, -1, 0], z: [0, -0.001, 1], fit: [0.55, -1, 0.62] };
    const away = new THREE.Vector3(...directions[way]).normalize();
    const { middle, distance } = this.#fit(away);
    this.is_fitted = way;
    this.controls.target.copy(middle);
    this.camera.position.copy(away.multiplyScalar(distance)).add(middle);
    this.camera.near = distance / 500;
    this.camera.far = distance * 20;
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  /** What the camera looks at along a direction, and from how far, to see every point as they are now. */
  #fit(away) {
    const right = new THREE.Vector3().crossVectors(this.camera.up, away).normalize();
    const axes = [right, new THREE.Vector3().crossVectors(away, right), away];
    const boxes = axes.map((axis) => this.#extent(axis, [0, 0, 0]));
    const middle = new THREE.Vector3();
    axes.forEach((axis, i) => middle.addScaledVector(axis, (boxes[i][0] + boxes[i][1]) / 2));
    const high = Math.tan((this.camera.fov * Math.PI) / 360);
    const slopes = [high * this.camera.aspect, high];
    // |across - middle| <= slope * (distance - depth) of every point, on both sides
    const needs = slopes.flatMap((slope, i) => [1, -1].map((sign) =>
      this.#extent(axes[i].clone().multiplyScalar(sign / slope).add(away), middle.toArray())[1]));
    return { middle, distance: 1.05 * Math.max(0.2 * this.radius, ...needs) };
  }

  /** The least and the largest product of a vector with the points, seen from an origin. */
  #extent({ x, y, z }, origin) {
    const from = x * origin[0] + y * origin[1] + z * origin[2];
    let low = Infinity;
    let high = -Infinity;
    for (let i = 0; i < this.point.length; i += 3) {
      const at = x * this.point[i] + y * this.point[i + 1] + z * this.point[i + 2] - from;
      if (at < low) low = at;
      if (at > high) high = at;
    }
    return low <= high ? [low, high] : [0, 0];
  }

  /** Turns the camera about the target [degrees], and moves it away by a factor. */
  turn(right, up, factor = 1) {
    this.is_fitted = null;
    const away = this.camera.position.clone().sub(this.controls.target);
    const to_z = new THREE.Quaternion().setFromUnitVectors(this.camera.up, new THREE.Vector3(0, 1, 0));
    const spherical = new THREE.Spherical().setFromVector3(away.applyQuaternion(to_z));
    spherical.theta -= (right * Math.PI) / 180;
    spherical.phi -= (up * Math.PI) / 180;
    spherical.makeSafe();
    spherical.radius *= factor;
    away.setFromSpherical(spherical).applyQuaternion(to_z.inverse());
    this.camera.position.copy(this.controls.target).add(away);
    this.controls.update();
    this.draw();
  }

  /** Takes over where another view's camera is. */
  follow(other) {
    this.is_fitted = null;
    this.camera.position.copy(other.camera.position);
    this.camera.near = other.camera.near;
    this.camera.far = other.camera.far;
    this.camera.updateProjectionMatrix();
    this.controls.target.copy(other.controls.target);
    this.camera.lookAt(this.controls.target);
    this.draw();
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
    this.draw();
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

  /** The face under a place of the canvas, in pixels from its upper left; null of none. */
  find_face(x, y) {
    const at = new THREE.Vector2((2 * x) / this.canvas.clientWidth - 1, 1 - (2 * y) / this.canvas.clientHeight);
    const ray = new THREE.Raycaster();
    this.camera.updateMatrixWorld();
    ray.setFromCamera(at, this.camera);
    const hits = ray.intersectObject(this.surface);
    return hits.length > 0 ? this.face_of_triangle[hits[0].faceIndex] : null;
  }

  /** Fills a face and draws a frame around it; null: of none. */
  mark_face(face) {
    const of = face === null ? [] : this.mesh.faces.corners.map((list) => list[face]);
    this.mark.geometry.setIndex(of.length > 0 ? [of[0], of[1], of[2], of[0], of[2], of[3]] : []);
    this.frame_of_mark.geometry.setIndex(of.flatMap((point, k) => [point, of[(k + 1) % 4]]));
    this.draw();
  }

  #resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (this.is_fitted) this.look_along(this.is_fitted);
    this.draw();
  }

  /** Takes over the colours of the style sheet. */
  restyle() {
    this.edges.material.color.set(style_colour("--mesh-line"));
    this.rods.material.color.set(style_colour("--accent"));
    this.dots.material.color.set(style_colour("--accent"));
    this.mark.material.color.set(style_colour("--mark"));
    this.frame_of_mark.material.color.set(style_colour("--mark"));
    this.draw();
  }

  draw() {
    if (this.is_due) return;
    this.is_due = true;
    requestAnimationFrame(() => this.draw_now());
  }

  draw_now() {
    this.is_due = false;
    this.renderer.render(this.scene, this.camera);
    this.after_drawing?.(this.camera);
  }
}
