// SPDX-License-Identifier: BSD-3-Clause
#include "support/contact_bodies.hpp"

#include <numbers>
#include <stdexcept>

#include "contact/interface_laws/make_interface_laws.hpp"
#include "contact/search/contact_search.hpp"
#include "core/elements/element_table.hpp"
#include "core/materials/elastic.hpp"

namespace contactsim::test {

namespace {

const Modelled& checked(const Modelled& made) {
  if (!made.messages.empty()) throw std::logic_error(made.messages);
  return made;
}

ModelBlock make_block(const Mesh& mesh, std::uint32_t index) {
  ElementProperties properties;
  properties.law = ElasticLaw{{1.0, 0.5}};
  properties.density = 1.0;
  const ElementBlock& block = mesh.blocks()[index];
  const Family family = topology(block.shape).family;
  if (family == Family::solid)
    return make_solid_block(mesh, index, *default_solid_element(block.shape), properties);
  const std::vector<double> sizes(block.n_elements, block.attributes.at(0));
  if (family == Family::shell) {
    const ElementFormulation& shell = *find_shell_element(block.shape, "bt_shell");
    return make_shell_block(mesh, index, shell, properties, {}, sizes);
  }
  const char* formulation = family == Family::particle ? "particle" : "beam";
  BeamShapeSettings round;
  round.area = sizes[0];
  round.second_t = round.second_s = sizes[0] * sizes[0] / (4.0 * std::numbers::pi);
  return make_line_block(mesh, index, *find_line_element(block.shape, formulation), properties, round, sizes);
}

}  // namespace

std::string general_contact(const std::string& more, const std::string& surfaces) {
  return surfaces + "begin interaction defaults\ngeneral contact = on\n" + more + "end\n";
}

ContactBodies::ContactBodies(const MeshBuilder& builder, const Region& given, const std::string& defined,
                             std::vector<TimeSteppingBlock> periods, Ranks& ranks)
    : mesh(builder.build()),
      region(given),
      functions(parse_definitions(defined).functions),
      time_stepping_blocks(std::move(periods)),
      definition(checked(test::make_model(mesh, region))),
      model(make_model_of(mesh)),
      x(mesh.coordinates()),
      v(Eigen::Matrix3Xd::Zero(3, x.cols())),
      forces(Eigen::Matrix3Xd::Zero(3, x.cols())),
      turning(v),
      moments(Eigen::Matrix3Xd::Zero(3, model.inertia.size())),
      contact({*region.contact, definition, model, time_stepping_blocks, functions, ranks}) {}

Region ContactBodies::with_contact(const std::string& lines) {
  Region region;
  region.contact = parse_contact(lines);
  return region;
}

ForceReport ContactBodies::ask() {
  const ForceReport report = contact.set_forces(motion(), forces);
  if (moments.cols() > 0) contact.set_moments(motion(), moments);
  return report;
}

Model ContactBodies::make_model_of(const Mesh& mesh) {
  Model model;
  model.mesh = &mesh;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) model.blocks.push_back(make_block(mesh, b));
  model.mass = lumped_mass(mesh, model.blocks);
  model.inertia = lumped_inertia(mesh, model.blocks);
  return model;
}

ForceReport ContactBodies::step(double size) {
  dt = size;
  time += size;
  x += size * v;
  return ask();
}

void ContactBodies::shift(std::size_t block, const Eigen::Vector3d& way) {
  std::vector<std::uint8_t> is_moved(mesh.n_nodes(), 0);
  for (const NodeIndex node : mesh.blocks()[block].nodes) is_moved[node.value] = 1;
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    if (is_moved[static_cast<std::size_t>(i)] != 0) x.col(i) += way;
  }
}

void ContactBodies::set_velocity(std::size_t block, const Eigen::Vector3d& velocity) {
  for (const NodeIndex node : mesh.blocks()[block].nodes) v.col(node.value) = velocity;
}

Eigen::Vector3d ContactBodies::force_on(std::size_t block) const {
  std::vector<std::uint8_t> is_in(mesh.n_nodes(), 0);
  for (const NodeIndex node : mesh.blocks()[block].nodes) is_in[node.value] = 1;
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    if (is_in[static_cast<std::size_t>(i)] != 0) sum += forces.col(i);
  }
  return sum;
}

Eigen::Vector3d ContactBodies::net_moment() const {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) sum += x.col(i).cross(forces.col(i));
  if (moments.cols() > 0) sum += moments.rowwise().sum();
  return sum;
}

ContactParts::ContactParts(const MeshBuilder& builder, const std::string& contact_lines)
    : mesh(builder.build()),
      definition(parse_contact(contact_lines)),
      model(checked(test::make_model(mesh, contact_lines))),
      contact_mesh(make_contact_mesh(model, mesh)),
      rules(model.pairs, std::vector<ActiveTimes>(model.pairs.size()), model.surfaces.surfaces.size()),
      kinematics(contact_mesh),
      x(mesh.coordinates()),
      v(Eigen::Matrix3Xd::Zero(3, x.cols())) {
  Diagnostics diagnostics;
  rules.set_laws(make_pair_laws(model.pairs, {definition.friction_models, {}, {}}, diagnostics));
  for (ContactFace& face : contact_mesh.faces) face.penalty_properties.mass_per_area = 4.0;
  for (SurfaceNode& node : contact_mesh.surface_nodes) node.penalty_properties.mass_per_area = 4.0;
  move();
}

void ContactParts::search(std::span<const float> face_depths, std::span<const float> node_depths) {
  move();
  ContactSearch search(contact_mesh, mesh, rules, definition.search, definition.dash);
  find_candidates(search, 0.0, face_depths, node_depths);
}

void ContactParts::find_candidates(ContactSearch& search, double dt, std::span<const float> face_depths,
                                   std::span<const float> node_depths) {
  search.find_face_pairs(kinematics, motion(dt), face_depths, face_partners);
  search.find_node_faces(kinematics, motion(dt), node_depths, node_faces);
  search.finish(kinematics);
}

}  // namespace contactsim::test
