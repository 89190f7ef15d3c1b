// SPDX-License-Identifier: BSD-3-Clause
// What is known of a face, a line or a particle.

/** Rows [name, value] about a face of a run at a frame. */
function describe_face(run, face, frame) {
  const { mesh, frames } = run;
  const { element, side, block, owner } = mesh.faces;
  const of = mesh.blocks[block[face]];
  const rows = [
    ["Element", `${element[face]} of ${of.name} (${of.shape})`],
    ["Side", of.shell ? "both sides of the shell" : String(side[face])],
    ["Surface", owner[face] > 0 ? mesh.owners[owner[face] - 1] : "none: no contact surface owns it"],
    ["Claims lost", describe_claims(mesh, face)],
  ];
  for (const field of frames ? frames.fields : []) {
    const value = field.nodal ? mean_of_corners(mesh, face, field, frame) : field_value(field, frame, face);
    if (!Number.isNaN(value)) rows.push([field.name, show_rounded(field, value)]);
  }
  return rows;
}

/** The same about a line or particle. */
function describe_thing(run, { things, i }, frame) {
  const { mesh, frames } = run;
  const of = mesh.blocks[things.block[i]];
  const rows = [
    ["Element", `${things.element[i]} of ${of.name} (${of.shape})`],
    ["Surface", things.owner[i] > 0 ? mesh.owners[things.owner[i] - 1] : "none: no contact surface owns it"],
  ];
  if (of.radius) rows.push(["Radius", show_number(of.radius)]);
  for (const field of frames ? frames.fields.filter(({ nodal }) => nodal) : []) {
    const value = mean_of_points(new Set(things.corners.map((list) => list[i])), field, frame);
    if (!Number.isNaN(value)) rows.push([field.name, show_rounded(field, value)]);
  }
  return rows;
}

/** With the digits that the packed field has. */
function show_rounded(field, value) {
  const is_coarse = field.linear_part > 0 || field.highest - field.lowest < 1000 * field.step;
  const text = show_number(Number(value.toPrecision(is_coarse ? 2 : 3)));
  return is_coarse && value !== 0 ? `about ${text}` : text;
}

function describe_claims(mesh, face) {
  if (!mesh.knows_claims) return "not known without the deck";
  const lost = mesh.lost[mesh.faces.claims[face]];
  if (lost.length === 0) return "none";
  return lost.map(([loser, winner]) => `${mesh.owners[loser]} claimed it, ${mesh.owners[winner]} has it`).join("; ");
}

function mean_of_corners(mesh, face, field, frame) {
  return mean_of_points(new Set(mesh.faces.corners.map((list) => list[face])), field, frame);
}

function mean_of_points(points, field, frame) {
  let sum = 0;
  for (const point of points) sum += field_value(field, frame, point);
  return sum / points.size;
}

/** A face of the element that an error of the run names: "element 17 of plate has turned inside out". */
function find_blamed_face(run) {
  const errors = problems_of(run).filter(({ severity }) => severity === "error");
  const named = errors.map(({ text }) => /\belement (\d+)\b/.exec(text)).find((found) => found);
  return named ? find_face_of_element(run.mesh, Number(named[1])) : null;
}

/** The first face of an element, by its Exodus id; null of none. */
function find_face_of_element(mesh, id) {
  const face = mesh.faces.element.indexOf(id);
  return face < 0 ? null : face;
}
