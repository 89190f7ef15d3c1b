// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/make_rigid_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/conditions/direction.hpp"
#include "core/definition/simulation.hpp"
#include "core/rigid/mass_moments.hpp"
#include "core/rigid/rigid_blocks.hpp"

namespace contactsim {

namespace {

/// Builds the bodies of a model, one after another.
class RigidBodyMaker {
 public:
  RigidBodyMaker(const SimulationDefinition& definition, const Region& region, Model& model,
                 Diagnostics& diagnostics)
      : definition_(definition),
        region_(region),
        model_(model),
        mesh_(*model.mesh),
        diagnostics_(diagnostics) {
    model.rigid.nodes.body_of.assign(mesh_.n_nodes(), std::nullopt);
    std::vector<ModelBlock> rigid;
    for (const ModelBlock& block : model.blocks) {
      if (block.is_rigid) rigid.push_back(block);
    }
    mass_of_rigid_ = lumped_mass(mesh_, rigid);
  }

  void add(const RigidBodyDefinition& definition);
  void finish();

 private:
  bool claim_nodes(const RigidBodyDefinition& definition, std::span<const std::uint32_t> blocks,
                   RigidBody& body);
  bool set_mass(const RigidBodyDefinition& definition, std::span<const std::uint32_t> blocks,
                RigidBody& body);
  bool check_reference(const RigidBodyDefinition& definition, RigidBody& body);
  bool share_mass(const DeckLocation& location, const RigidBody& body);
  MassMoments moments_of(std::span<const std::uint32_t> blocks, const RigidBody& body) const;

  const SimulationDefinition& definition_;
  const Region& region_;
  Model& model_;
  const Mesh& mesh_;
  Diagnostics& diagnostics_;
  Eigen::RowVectorXd mass_of_rigid_;  ///< that elements of rigid blocks give the nodes
};

bool RigidBodyMaker::claim_nodes(const RigidBodyDefinition& definition, std::span<const std::uint32_t> blocks,
                                 RigidBody& body) {
  for (const std::uint32_t block : blocks) {
    const auto& nodes = mesh_.blocks()[block].nodes;
    body.nodes.insert(body.nodes.end(), nodes.begin(), nodes.end());
  }
  for (const DeckName& name : definition.node_sets) {
    const auto set = mesh_.find(EntityKind::node_set, name.text);
    if (!set) {
      diagnostics_.add_error(name.location, fmt::format("the mesh has no node set '{}'", name.text));
      return false;
    }
    const auto& nodes = mesh_.node_sets()[*set].nodes;
    body.nodes.insert(body.nodes.end(), nodes.begin(), nodes.end());
  }
  std::sort(body.nodes.begin(), body.nodes.end());
  body.nodes.erase(std::unique(body.nodes.begin(), body.nodes.end()), body.nodes.end());
  auto& body_of = model_.rigid.nodes.body_of;
  for (const NodeIndex node : body.nodes) {
    if (body_of[node.value]) {
      const RigidBody& other = model_.rigid.bodies[*body_of[node.value]];
      diagnostics_.add_error(definition.name.location,
                             fmt::format("node {} belongs to the rigid bodies '{}' and '{}'",
                                         mesh_.node_id(node), other.name, body.name));
      return false;
    }
    body_of[node.value] = static_cast<std::uint32_t>(model_.rigid.bodies.size());
  }
  return true;
}

/// About the body's centre: its elements, and what neighbours that are not rigid give its nodes.
MassMoments RigidBodyMaker::moments_of(std::span<const std::uint32_t> blocks, const RigidBody& body) const {
  MassMoments sum;
  for (const ModelBlock& block : model_.blocks) {
    if (std::find(blocks.begin(), blocks.end(), block.mesh_block) == blocks.end()) continue;
    const MassMoments one = mass_moments(block, mesh_, body.centre);
    sum.mass += one.mass;
    sum.second += one.second;
  }
  for (const NodeIndex node : body.nodes) {
    const double from_others = model_.mass(node.value) - mass_of_rigid_(node.value);
    if (from_others > 0.0) sum.add(from_others, mesh_.coordinates().col(node.value) - body.centre);
  }
  return sum;
}

bool RigidBodyMaker::set_mass(const RigidBodyDefinition& definition, std::span<const std::uint32_t> blocks,
                              RigidBody& body) {
  for (const NodeIndex node : body.nodes) {
    body.mass += model_.mass(node.value);
    body.centre += model_.mass(node.value) * mesh_.coordinates().col(node.value);
  }
  if (!(body.mass > static_cast<double>(body.nodes.size()) * 2.0 * minimum_nodal_mass)) {
    diagnostics_.add_error(definition.name.location,
                           fmt::format("the rigid body '{}' has no elements with mass", body.name));
    return false;
  }
  body.centre /= body.mass;
  MassMoments moments = moments_of(blocks, body);
  const double factor = definition.mass.value_or(body.mass) / body.mass;
  body.mass *= factor;
  moments.second *= factor;
  MassMoments whole{body.mass, Eigen::Vector3d::Zero(), moments.second};
  for (const AttachedPointMass& point : definition.point_masses)
    whole.add(point.mass, point.location - body.centre);
  const Eigen::Vector3d shift = whole.first / whole.mass;
  body.mass = whole.mass;
  body.centre += shift;
  body.inertia = inertia_of(whole.second - whole.mass * shift * shift.transpose());
  if (definition.inertia) {
    const auto& i = *definition.inertia;
    body.inertia << i[0], i[3], i[5], i[3], i[1], i[4], i[5], i[4], i[2];
  }
  return check_reference(definition, body);
}

/// Whoever gives mass, inertia and a place means that place as the centre.
bool RigidBodyMaker::check_reference(const RigidBodyDefinition& definition, RigidBody& body) {
  if (!definition.reference_location) return true;
  const Eigen::Vector3d& reference = *definition.reference_location;
  if (definition.mass && definition.inertia) {
    body.centre = reference;
    return true;
  }
  double size = 0.0;
  for (const NodeIndex node : body.nodes)
    size = std::max(size, (mesh_.coordinates().col(node.value) - body.centre).norm());
  constexpr double round_off = 1e-6;  // decks write places to some seven digits
  if ((reference - body.centre).norm() <= round_off * size) return true;
  diagnostics_.add_error(
      definition.name.location,
      fmt::format(
          "the reference location of '{}' is not its centre of mass, ({:.6g}, {:.6g}, {:.6g}), which is "
          "not supported",
          body.name, body.centre.x(), body.centre.y(), body.centre.z()),
      "leave REFERENCE LOCATION out, or give MASS and INERTIA with it");
  return false;
}

/// Shares the body's mass among its nodes anew where the deck gives a mass, a centre or point masses, such
/// that weight acts at the centre: every node's mass times a linear function of its place.
bool RigidBodyMaker::share_mass(const DeckLocation& location, const RigidBody& body) {
  MassMoments at_nodes;
  for (const NodeIndex node : body.nodes)
    at_nodes.add(model_.mass(node.value), mesh_.coordinates().col(node.value) - body.centre);
  const Eigen::Vector3d centre = at_nodes.first / at_nodes.mass;
  const Eigen::Matrix3d spread = at_nodes.second / at_nodes.mass - centre * centre.transpose();
  const Eigen::Vector3d slope = -inverse_where_it_is(spread) * centre;
  const Eigen::Vector3d left = spread * slope + centre;  // where nodes lie in a plane that has not the centre
  bool is_possible = left.norm() <= 1e-6 * std::sqrt(spread.trace());
  for (const NodeIndex node : body.nodes) {
    const Eigen::Vector3d arm = mesh_.coordinates().col(node.value) - body.centre - centre;
    const double factor = body.mass / at_nodes.mass * (1.0 + slope.dot(arm));
    is_possible = is_possible && factor > 0.0;
    model_.mass(node.value) *= factor;
  }
  if (is_possible) return true;
  diagnostics_.add_error(
      location,
      fmt::format("the centre of mass of the rigid body '{}' lies too far from its elements to be supported",
                  body.name));
  return false;
}

void RigidBodyMaker::add(const RigidBodyDefinition& definition) {
  RigidBody body;
  body.name = definition.name.text;
  const auto blocks = find_rigid_blocks(definition_, region_, mesh_, definition);
  if (blocks.empty() && definition.node_sets.empty()) return;  // of another region
  if (!claim_nodes(definition, blocks, body) || !set_mass(definition, blocks, body)) return;
  if (!share_mass(definition.name.location, body)) return;
  body.flexible = inverse_where_it_is(body.inertia);
  body.arms.resize(3, static_cast<Eigen::Index>(body.nodes.size()));
  for (std::size_t i = 0; i < body.nodes.size(); ++i)
    body.arms.col(static_cast<Eigen::Index>(i)) = mesh_.coordinates().col(body.nodes[i].value) - body.centre;
  model_.rigid.bodies.push_back(std::move(body));
}

/// What is known once all bodies are.
void RigidBodyMaker::finish() {
  RigidBodies& rigid = model_.rigid;
  if (rigid.empty()) {
    rigid.nodes = {};
    return;
  }
  MeshParts parts;
  parts.path = mesh_.path();
  parts.coordinates.resize(3, static_cast<Eigen::Index>(rigid.bodies.size()));
  rigid.free_mass = model_.mass;
  rigid.free_inertia = model_.inertia;
  for (std::size_t i = 0; i < rigid.bodies.size(); ++i) {
    const RigidBody& body = rigid.bodies[i];
    parts.coordinates.col(static_cast<Eigen::Index>(i)) = body.centre;
    rigid.nodes.names.push_back(body.name);
    rigid.nodes.counts.push_back(body.nodes.size());
    for (const NodeIndex node : body.nodes) {
      rigid.free_mass(node.value) = 0.0;
      if (rigid.free_inertia.cols() > 0) rigid.free_inertia(node.value) = 0.0;
    }
  }
  rigid.nodes.references = std::make_shared<const Mesh>(std::move(parts));
}

}  // namespace

void make_rigid_bodies(const SimulationDefinition& definition, const Region& region, Model& model,
                       Diagnostics& diagnostics) {
  if (definition.rigid_bodies.empty()) return;
  RigidBodyMaker maker(definition, region, model, diagnostics);
  for (const RigidBodyDefinition& body : definition.rigid_bodies) maker.add(body);
  maker.finish();
}

void set_rigid_velocities(const ConditionScope& scope, const RigidBodies& rigid, Eigen::Matrix3Xd& velocity) {
  for (const RigidBody& body : rigid.bodies) {
    const auto is_it = [&](const RigidBodyDefinition& one) { return one.name.text == body.name; };
    const auto& all = scope.definition.rigid_bodies;
    const RigidBodyDefinition& given = *std::find_if(all.begin(), all.end(), is_it);
    const bool moves = std::isfinite(given.magnitude), turns = std::isfinite(given.angular_velocity);
    if ((moves && !given.direction) || (turns && !given.cylindrical_axis)) {
      scope.diagnostics.add_error(
          given.name.location, fmt::format("the initial velocity of the rigid body '{}' has no {}", body.name,
                                           moves && !given.direction ? "DIRECTION" : "CYLINDRICAL AXIS"));
      continue;
    }
    const auto way = moves ? find_direction({{}, given.direction, {}}, scope) : std::nullopt;
    const auto axis = turns ? find_direction({{}, {}, given.cylindrical_axis}, scope) : std::nullopt;
    for (const NodeIndex node : body.nodes) {
      if (!way && !axis) break;
      Eigen::Vector3d v = Eigen::Vector3d::Zero();
      if (way) v += given.magnitude * sum_of_units(*way);
      if (axis) {
        const Axis& about = std::get<Axis>(*axis);
        v += given.angular_velocity *
             about.direction.cross(about.offset_of(scope.mesh.coordinates().col(node.value)));
      }
      velocity.col(node.value) = v;
    }
  }
}

}  // namespace contactsim
