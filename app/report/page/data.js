// SPDX-License-Identifier: BSD-3-Clause
// Reads what app/report/report_json.cpp has written.

/** The whole numbers of a table that pack_numbers made: [n_rows x n_columns] row by row. */
async function unpack(text, n_columns, in_time) {
  if (!text) return new Int32Array(0);
  const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
  const bytes = new Uint8Array(await new Response(stream).arrayBuffer());
  return undo_differences(read_numbers(bytes), n_columns, in_time);
}

/** Base-128 numbers, the sign in the lowest bit. Ids pass 32 bits: no bit operations on whole numbers. */
function read_numbers(bytes) {
  const numbers = new Float64Array(bytes.length);
  let n = 0;
  for (let at = 0; at < bytes.length; ) {
    let value = 0;
    let weight = 1;
    while (bytes[at] >= 128) {
      value += (bytes[at++] - 128) * weight;
      weight *= 128;
    }
    value += bytes[at++] * weight;
    numbers[n++] = value % 2 ? -(value + 1) / 2 : value / 2;
  }
  return numbers.subarray(0, n);
}

function undo_differences(numbers, n_columns, in_time) {
  const columns = n_columns || numbers.length;
  for (let row = 0; row < numbers.length; row += columns) {
    const end = Math.min(row + columns, numbers.length);
    for (let i = row + 1; i < end; ++i) numbers[i] += numbers[i - 1];
    if (!in_time || row === 0) continue;
    for (let i = row; i < end; ++i) numbers[i] += numbers[i - columns];
  }
  return numbers;
}

/** The mesh of a run: arrays in place of texts. */
async function read_mesh(json) {
  const points = json.points;
  const position = new Float32Array(3 * points);
  const middle = [];
  for (let axis = 0; axis < 3; ++axis) {
    const { first, step, numbers } = json.coordinates[axis];
    const codes = await unpack(numbers);
    // About the middle of the model: far from the origin 32 bits would show.
    middle.push(first + step * 32767.5);
    for (let i = 0; i < points; ++i) position[3 * i + axis] = step * (codes[i] - 32767.5);
  }
  const faces = { n: json.faces.n, corners: await Promise.all(json.faces.corners.map((t) => unpack(t))) };
  for (const key of ["element", "side", "block", "owner", "claims", "shown_from", "hidden_from"]) {
    if (json.faces[key] !== undefined) faces[key] = await unpack(json.faces[key]);
  }
  const [lines, particles] = [await read_lines(json.lines), await read_lines(json.particles)];
  return { ...json, position, middle, faces, lines, particles };
}

async function read_lines({ n, corners, element, block, owner }) {
  const lists = await Promise.all([...corners, element, block, owner].map((text) => unpack(text)));
  return { n, corners: lists.slice(0, 2), element: lists[2], block: lists[3], owner: lists[4] };
}

/** Lines or particles of one radius; null: of those that have none. */
function of_radius(things, blocks, radius) {
  const chosen = [...Array(things.n).keys()].filter((i) => blocks[things.block[i]].radius === radius);
  const take = (list) => chosen.map((i) => list[i]);
  return {
    n: chosen.length, radius, corners: things.corners.map(take), element: take(things.element), block: take(things.block),
    owner: take(things.owner),
  };
}

/** The frames of a run: displacements and fields at the shown times. */
async function read_frames(json, mesh) {
  const n = mesh.position.length;
  const fields = [];
  for (const field of json.fields) {
    const columns = field.nodal ? mesh.points : mesh.faces.n;
    const read = { ...field, columns, codes: Uint16Array.from(await unpack(field.numbers, columns, true)) };
    fields.push({ ...read, usual: usual_range(read) });
  }
  return {
    ...json,
    fields,
    step: json.displacement.step,
    moved: Int32Array.from(await unpack(json.displacement.numbers, n, true)),
  };
}

/** What a code of a field stands for; NaN where there is no value. */
function field_value(field, frame, i) {
  const code = field.codes[frame * field.columns + i];
  return code === 0 ? NaN : value_of_code(field, code);
}

function value_of_code(field, code) {
  const value = field.first + field.step * (code - 1);
  return field.linear_part > 0 ? field.linear_part * Math.sinh(value) : value;
}

/** The range of a run without the 2 % of its values farthest out, where a few pass all others by far. */
function usual_range(field) {
  if (!(field.linear_part > 0)) return [field.lowest, field.highest];
  const counts = new Uint32Array(65537);
  for (const code of field.codes) ++counts[code];
  const is_positive = field.lowest >= 0;
  counts[0] = 0;
  if (is_positive) counts[1] = 0; // where nothing touches
  const n_out = counts.reduce((a, b) => a + b, 0) / 50;
  const find = (code, by) => {
    for (let n = counts[code]; n <= n_out && code + by > 0 && code + by < 65537; n += counts[code]) code += by;
    return value_of_code(field, code);
  };
  return [is_positive ? field.lowest : find(1, 1), find(65536, -1)];
}

/** A number as a table shows it: six digits at most. */
function show_number(value) {
  if (value === null || value === undefined || Number.isNaN(value)) return "–";
  if (!Number.isFinite(value)) return String(value);
  if (Number.isInteger(value) && Math.abs(value) < 1e6) return String(value).replace("-", "−");
  const size = Math.abs(value);
  const text = size >= 1e-3 && size < 1e6 ? value.toPrecision(6) : value.toExponential(4);
  return text.replace(/(\.\d*?)0+(e|$)/, "$1$2").replace(/\.(e|$)/, "$1").replace("-", "−").replace("e−", "e-");
}

/** The same with four digits. */
function show_short(value) {
  return Number.isFinite(value) ? show_number(Number(value.toPrecision(4))) : show_number(value);
}

/** "1 error", "2 errors". */
function show_count(n, what) {
  return `${n} ${what}${n === 1 ? "" : "s"}`;
}

/** An element with attributes and children, as a call: make("td", {class: "number"}, "12"). */
function make(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [key, value] of Object.entries(attributes)) {
    if (value !== undefined && value !== false) element.setAttribute(key, value === true ? "" : value);
  }
  element.append(...children.filter((child) => child !== null && child !== undefined));
  return element;
}
