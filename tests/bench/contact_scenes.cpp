// SPDX-License-Identifier: BSD-3-Clause
#include "contact_scenes.hpp"

#include <malloc.h>

#include <cmath>

#include "core/elements/elements.hpp"
#include "core/mesh/renumber_mesh.hpp"
#include "core/mesh/skin.hpp"
#include "machine_limits.hpp"

namespace contactsim::bench {

namespace {

double memory_in_use() {
  const auto info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd);
}

/// A layer of hexahedra on a surface of quadrilaterals, inwards or outwards by a length of 1.
ElementBlock add_layer(const QuadSurface& surface, bool inwards, MeshParts& parts) {
  const Eigen::Index first = parts.coordinates.cols(), n = surface.positions.cols();
  parts.coordinates.conservativeResize(3, first + 2 * n);
  const Eigen::RowVectorXd radius = surface.positions.colwise().norm();
  const Eigen::RowVectorXd scale = 1.0 + (inwards ? -1.0 : 1.0) / radius.array();
  parts.coordinates.middleCols(first, n) = surface.positions;
  parts.coordinates.middleCols(first + n, n) = surface.positions * scale.asDiagonal();
  ElementBlock block;
  block.id = static_cast<std::int64_t>(parts.blocks.size()) + 1;
  block.shape = Shape::hex8;
  block.type_name = "HEX8";
  block.nodes_per_element = 8;
  block.n_elements = static_cast<std::uint32_t>(surface.quads.size());
  const auto below = static_cast<std::uint32_t>(inwards ? first + n : first);
  const auto above = static_cast<std::uint32_t>(inwards ? first : first + n);
  for (const auto& quad : surface.quads) {
    for (const std::uint32_t node : quad) block.nodes.push_back(NodeIndex{below + node});
    for (const std::uint32_t node : quad) block.nodes.push_back(NodeIndex{above + node});
  }
  return block;
}

Mesh make_sphere_layers(std::uint32_t n, double gap) {
  const SpherePair pair = make_sphere_pair(n);
  QuadSurface outer = pair.outer;
  const double moved = gap - 0.1;
  for (auto point : outer.positions.colwise()) point += moved * point.normalized();
  MeshParts parts;
  parts.path = "spheres";
  parts.coordinates.resize(3, 0);
  parts.blocks.push_back(add_layer(pair.inner, true, parts));
  parts.blocks.push_back(add_layer(outer, false, parts));
  return renumber_mesh(Mesh(std::move(parts)));
}

ContactSurface surface_of(const std::string& name, std::uint32_t first, std::uint32_t n, int side) {
  ContactSurface surface;
  surface.name = name;
  for (std::uint32_t e = 0; e < n; ++e) surface.faces.push_back(ElementSide(ElementIndex{first + e}, side));
  return surface;
}

/// Contact of two surfaces with everything automatic.
ContactModel make_pair(ContactSurface first, ContactSurface second, PairSettings settings) {
  ContactModel contact;
  contact.surfaces.surfaces = {std::move(first), std::move(second)};
  SurfacePair pair;
  pair.second = {1};
  pair.formulation = settings.formulation;
  pair.enforcement = settings.enforcement;
  contact.pairs.push_back(pair);
  return contact;
}

Model make_model(const Mesh& mesh) {
  Model model;
  model.mesh = &mesh;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) {
    model.blocks.push_back(
        make_solid_block(mesh, b, hex8_mean_quadrature, ElementProperties{elastic_law(), 7800.0}));
  }
  model.mass = lumped_mass(mesh, model.blocks);
  return model;
}

/// Time that a pressure wave takes along an edge of length 1.
double stable_step() { return 1.0 / std::sqrt((160e9 + 4.0 / 3.0 * 80e9) / 7800.0); }

/// Two cubes of 64 x 64 x 64, the second one on top of the first.
Mesh make_two_cubes() {
  const Mesh cube = make_hex_cube(64);
  MeshParts parts;
  parts.path = "cubes";
  const Eigen::Index n = cube.coordinates().cols();
  parts.coordinates.resize(3, 2 * n);
  parts.coordinates << cube.coordinates(), cube.coordinates().colwise() + Eigen::Vector3d(0.3, 0.2, 64.0);
  for (std::uint32_t b = 0; b < 2; ++b) {
    ElementBlock block = cube.blocks()[0];
    block.id = b + 1;
    for (NodeIndex& node : block.nodes) node.value += b * static_cast<std::uint32_t>(n);
    parts.blocks.push_back(std::move(block));
  }
  return renumber_mesh(Mesh(std::move(parts)));
}

/// All outside faces of a block.
ContactSurface skin_of(const std::string& name, const Mesh& mesh, std::size_t block) {
  const Skin skin = make_skin(mesh, std::vector<std::uint8_t>(mesh.n_elements(), 1));
  const auto sides = skin.sides_of_block(mesh.blocks()[block]);
  ContactSurface surface;
  surface.name = name;
  surface.faces.assign(sides.begin(), sides.end());
  return surface;
}

/// The rotation by a hundredth of an edge on the surface of a sphere of n x n x 6 faces.
Eigen::Matrix3d turn_of_sphere(std::uint32_t n) {
  constexpr double slide_per_step = 0.01;
  const double radius = n * std::sqrt(6.0 / (4.0 * EIGEN_PI));
  const Eigen::Vector3d axis = Eigen::Vector3d(1.0, 2.0, 3.0).normalized();
  return Eigen::AngleAxisd(slide_per_step / radius, axis).toRotationMatrix();
}

std::uint32_t faces_along_edge(std::int64_t n_faces) {
  return static_cast<std::uint32_t>(std::lround(std::sqrt(static_cast<double>(n_faces) / 6.0)));
}

}  // namespace

SphereScene::SphereScene(std::int64_t n_faces, bool touches, PairSettings settings)
    : mesh_(make_sphere_layers(faces_along_edge(n_faces), touches ? -0.03 : 0.1)) {
  const std::uint32_t n = faces_along_edge(n_faces), each = 6 * n * n;
  n_faces_ = 2.0 * each;
  contact_ = make_pair(surface_of("inner", 0, each, 6), surface_of("outer", each, each, 5), settings);
  model_ = make_model(mesh_);
  state_ = make_state(mesh_.coordinates(), model_.blocks, 0.0);
  forces_ = state_.velocity;
  turn_ = turn_of_sphere(n);
  memory_before_ = memory_in_use();
  force_.emplace(ContactSetup{definition_, contact_, model_, {}});
  state_.next_dt = stable_step();
  step();
  state_.dt = state_.next_dt;
}

void SphereScene::move() {
  Eigen::Matrix3Xd& x = state_.coordinates;
  const Eigen::Index n_outer = x.cols() / 2;
  const Eigen::Matrix3Xd moved = turn_ * x.rightCols(n_outer);
  state_.velocity.rightCols(n_outer) = (moved - x.rightCols(n_outer)) / state_.dt;
  x.rightCols(n_outer) = moved;
  state_.time += state_.dt;
}

void SphereScene::step() {
  force_->set_forces({state_.time, state_.dt, state_.coordinates, state_.velocity, state_.next_dt}, forces_);
  force_->balance(state_, forces_);
}

double SphereScene::pushed() const {
  std::size_t n_pushed = 0;
  for (const auto& f : forces_.colwise()) n_pushed += f.squaredNorm() > 0.0 ? 1 : 0;
  return static_cast<double>(n_pushed) / n_nodes();
}

double SphereScene::memory() const { return memory_in_use() - memory_before_; }

ForceReport Timed::set_forces(const Motion& motion, Eigen::Matrix3Xd& forces) {
  const double start = wall_seconds();
  const ForceReport report = term_.set_forces(motion, forces);
  seconds += wall_seconds() - start;
  return report;
}

std::optional<ForceReport> Timed::balance(const State& state, Eigen::Matrix3Xd& forces) {
  const double start = wall_seconds();
  const auto report = term_.balance(state, forces);
  seconds += wall_seconds() - start;
  return report;
}

ImpactScene::ImpactScene(PairSettings settings) : mesh_(make_two_cubes()), model_(make_model(mesh_)) {
  contact_ = make_pair(skin_of("low", mesh_, 0), skin_of("high", mesh_, 1), settings);
  state_ = make_state(mesh_.coordinates(), model_.blocks, 0.0);
  state_.velocity.rightCols(state_.velocity.cols() / 2).row(2).setConstant(-50.0);
  state_.forces.contact = Eigen::Matrix3Xd::Zero(3, state_.velocity.cols());
  internal_.emplace(model_, state_);
  force_.emplace(ContactSetup{definition_, contact_, model_, {}});
  timed_.emplace(*force_);
  start(model_, {*internal_, none_, &*timed_}, control_, state_);
  timed_->seconds = 0.0;
}

void ImpactScene::step() { advance(model_, {*internal_, none_, &*timed_}, control_, state_); }

}  // namespace contactsim::bench
