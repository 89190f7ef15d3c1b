// SPDX-License-Identifier: BSD-3-Clause
// A scene on a canvas and the camera before it, by three.js.

/** Points in space that can be looked at from all sides. It draws when something has changed. */
class Stage {
  /** position: [3 n_points] about the middle of the model. */
  constructor(canvas, position) {
    Object.assign(this, { canvas, is_due: false, point: new Float32Array(position) });
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
    this.#light();
    this.#measure();
    this.look_along("fit");
    new ResizeObserver(() => this.#resize()).observe(canvas);
  }

  #light() {
    this.scene.add(new THREE.HemisphereLight(0xffffff, 0xb4bac6, 0.8));
    const lamp = new THREE.DirectionalLight(0xffffff, 0.4);
    lamp.position.set(0.4, 0.6, 1);
    this.camera.add(lamp);
    this.scene.add(this.camera);
  }

  /** The radius of the model at the start. */
  #measure() {
    let squared = 0;
    const x = this.point;
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

  /** What a length takes of the canvas at a distance from the eye [pixels]. */
  pixels_of(length, distance, height) {
    return (length * height) / (2 * Math.tan((this.camera.fov * Math.PI) / 360) * distance);
  }

  /** Points as balls of a radius; null: as dots of one size. */
  ball_material(radius) {
    const vertexColors = THREE.VertexColors;
    if (radius === null) return new THREE.PointsMaterial({ size: 9, sizeAttenuation: false, vertexColors });
    // three.js makes a point size * height / (2 distance) pixels wide.
    const size = (2 * radius) / Math.tan((this.camera.fov * Math.PI) / 360);
    const material = new THREE.PointsMaterial({ size, vertexColors });
    material.onBeforeCompile = (shader) => {
      shader.fragmentShader = shader.fragmentShader.replace("#include <color_fragment>", `#include <color_fragment>
        vec2 off = 2.0 * gl_PointCoord - 1.0;
        if (dot(off, off) > 1.0) discard;
        diffuseColor.rgb *= 0.5 + 0.5 * sqrt(1.0 - dot(off, off));`);
    };
    return material;
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

  #resize() {
    const { clientWidth, clientHeight } = this.canvas;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    if (this.is_fitted) this.look_along(this.is_fitted);
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
