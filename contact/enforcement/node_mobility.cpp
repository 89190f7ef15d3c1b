// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/node_mobility.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/base/threads.hpp"
#include "core/dynamics/model.hpp"
#include "core/elements/minimum_nodal_mass.hpp"

namespace contactsim {

namespace {

/// The largest eigenvalue of a symmetric matrix without negative ones, the same in every frame.
double largest_stretch(const Eigen::Matrix3d& symmetric) {
  return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(symmetric, Eigen::EigenvaluesOnly)
      .eigenvalues()
      .maxCoeff();
}

bool is_positive(double mass) { return mass > minimum_nodal_mass; }

}  // namespace

void NodeMobility::begin(const Model& model, const ModelFreeDirections& free,
                         const ContactKinematics& kinematics, const State& state) {
  kinematics_ = &kinematics;
  rigid_ = &model.rigid.nodes;
  state_ = &state;
  half_steps_ = 0.5 * (state.dt + state.next_dt);
  for (const Carrier& carrier : carriers_) carrier_[carrier.body] = std::nullopt;
  carriers_.clear();
  mesh_nodes_.clear();
  rings_.clear();
  ring_carriers_.clear();
  for (Changes* changes : {&now_, &next_}) {
    changes->changes.clear();
    changes->turnings.clear();
  }
  if (inverse_mass_.empty()) {
    const std::size_t n_bodies = kinematics.contact_mesh().n_nodes() + model.rigid.bodies.size();
    general_.assign(n_bodies, std::nullopt);
    inverse_mass_.assign(n_bodies, 0.0);
    carrier_.assign(n_bodies, std::nullopt);
    generals_.clear();
    set_nodes(model, free);
    set_bodies(model, free);
  }
  turn_bodies(model, free, state);
}

NodeMobility::General& NodeMobility::make_general(std::uint32_t body) {
  general_[body] = static_cast<std::uint32_t>(generals_.size());
  return generals_.emplace_back();
}

/// Plain nodes answer by 1 / m alike along all axes. Others by P / m and P' / I, where P and P' project onto
/// the directions along and about which conditions leave them free.
void NodeMobility::set_nodes(const Model& model, const ModelFreeDirections& directions) {
  const ContactMesh& contact_mesh = kinematics_->contact_mesh();
  const bool turns = model.inertia.cols() > 0;
  const Eigen::Matrix3d all = Eigen::Matrix3d::Identity();
  const bool has_rings = kinematics_->spins().size() > 0;
  contact_node_.assign(has_rings ? static_cast<std::size_t>(model.mass.cols()) : 0, std::nullopt);
  for (const ContactNodeIndex i : contact_mesh.nodes()) {
    const NodeIndex node = contact_mesh.mesh_nodes[i];
    if (has_rings && contact_mesh.first_alike[i] == i) contact_node_[node.value] = i;
    const double mass = model.mass(node.value);
    if (contact_mesh.first_alike[i] != i || !rigid_->is_free(node) || !is_positive(mass)) continue;
    const Eigen::Matrix3d* free = directions.of_node(node);
    const double inertia = turns ? model.inertia(node.value) : 0.0;
    const bool is_held = free != nullptr && free->isZero(0.0);
    const bool has_ring = kinematics_->spins().find(node).has_value();
    if (!is_positive(inertia) && !has_ring && (free == nullptr || is_held || *free == all)) {
      inverse_mass_[i.value] = is_held ? 0.0 : 1.0 / mass;
      continue;
    }
    General& general = make_general(i.value);
    general.translation = (free != nullptr ? *free : all) / mass;
    general.translation_bound = largest_stretch(general.translation);
    if (!is_positive(inertia) || has_ring) continue;
    const Eigen::Matrix3d* free_turns = directions.of_turns(node);
    general.rotation = (free_turns != nullptr ? *free_turns : all) / inertia;
    general.rotation_bound = largest_stretch(general.rotation);
  }
  plain_.assign(contact_mesh.n_nodes(), std::nullopt);
  for (const ContactNodeIndex node : contact_mesh.nodes()) {
    const std::uint32_t body = contact_mesh.first_alike[node].value;
    if (rigid_->is_free(contact_mesh.mesh_nodes[node]) && !general_[body]) plain_[node] = body;
  }
}

void NodeMobility::set_bodies(const Model& model, const ModelFreeDirections& directions) {
  for (std::uint32_t i = 0; i < model.rigid.bodies.size(); ++i) {
    General& general = make_general(static_cast<std::uint32_t>(kinematics_->contact_mesh().n_nodes()) + i);
    const Eigen::Matrix3d* free = directions.of_body(i);
    general.translation =
        (free != nullptr ? *free : Eigen::Matrix3d::Identity()) / model.rigid.bodies[i].mass;
    general.translation_bound = largest_stretch(general.translation);
  }
}

/// Angular velocity by moment: R I^-1 R^T of a free body that is turned by R, else the inverse of
/// P R I R^T P where it has one, with the projection P onto the axes about which it is free.
void NodeMobility::turn_bodies(const Model& model, const ModelFreeDirections& directions,
                               const State& state) {
  for (std::uint32_t i = 0; i < model.rigid.bodies.size(); ++i) {
    const RigidBody& body = model.rigid.bodies[i];
    General& general = generals_[*general_[kinematics_->contact_mesh().n_nodes() + i]];
    const Eigen::Matrix3d axes = state.rigid[i].orientation.toRotationMatrix();
    const Eigen::Matrix3d* free = directions.of_body_turns(i);
    if (free == nullptr) {
      general.rotation = axes * body.flexible * axes.transpose();
    } else {
      const Eigen::Matrix3d inertia = *free * axes * body.inertia * axes.transpose() * *free;
      general.rotation = inverse_where_it_is(inertia);
    }
    general.rotation_bound = largest_stretch(general.rotation);
  }
}

std::uint32_t NodeMobility::use(std::uint32_t body) {
  if (carrier_[body]) return *carrier_[body];
  const auto carrier = static_cast<std::uint32_t>(carriers_.size());
  carrier_[body] = carrier;
  Carrier& made = carriers_.emplace_back(body, general_[body], half_steps_ * inverse_mass_[body]);
  if (made.general) {
    const General& general = generals_[*made.general];
    made.mobility = half_steps_ * general.translation_bound;
    made.turn_bound = std::sqrt(half_steps_ * general.rotation_bound);
  }
  next_.changes.push_back(NodeVector::Zero());
  next_.turnings.push_back(NodeVector::Zero());
  return carrier;
}

std::uint32_t NodeMobility::use_node(ContactNodeIndex node) {
  const std::size_t n_before = carriers_.size();
  const std::uint32_t carrier = use(kinematics_->contact_mesh().first_alike[node].value);
  if (carriers_.size() > n_before) mesh_nodes_.push_back(kinematics_->contact_mesh().mesh_nodes[node].value);
  return carrier;
}

/// Has a node of a lofted shell turn with the nodes around.
void NodeMobility::use_ring(std::uint32_t carrier, NodeIndex mesh_node) {
  const OptionalIndex<std::uint32_t> spin = kinematics_->spins().find(mesh_node);
  if (!spin || carriers_[carrier].ring) return;
  carriers_[carrier].ring = static_cast<std::uint32_t>(rings_.size());
  carriers_[carrier].turn_bound = 1.0;
  rings_.push_back({carrier, *spin, static_cast<std::uint32_t>(ring_carriers_.size())});
  for (const NodeIndex other : kinematics_->spins().neighbours(*spin))
    ring_carriers_.push_back(use_node(*contact_node_[other.value]));
}

std::optional<std::uint32_t> NodeMobility::plain_carrier(ContactNodeIndex node) {
  const OptionalIndex<std::uint32_t> body = plain_[node];
  if (!body) return std::nullopt;
  return carrier_[*body] ? *carrier_[*body] : use_node(node);
}

NodeVector NodeMobility::last_velocity(std::uint32_t carrier) const {
  const Eigen::Vector3d velocity = kinematics_->last_v({carriers_[carrier].body});
  return {velocity.x(), velocity.y(), velocity.z(), 0.0};
}

void NodeMobility::add_terms(ContactNodeIndex node, double weight, const Eigen::Vector3d& beside,
                             std::vector<CarrierTerm>& terms) {
  const ContactMesh& contact_mesh = kinematics_->contact_mesh();
  const NodeIndex mesh_node = contact_mesh.mesh_nodes[node];
  if (rigid_->is_free(mesh_node)) {
    Eigen::Vector3d arm = beside;
    const std::size_t n_mesh_points = contact_mesh.n_mesh_points();
    if (node.value >= n_mesh_points)
      arm += kinematics_->offsets().col(static_cast<Eigen::Index>(node.value - n_mesh_points));
    const std::uint32_t carrier = use_node(node);
    use_ring(carrier, mesh_node);
    terms.push_back({carrier, weight, arm});
    return;
  }
  const std::uint32_t body = *rigid_->body_of[mesh_node.value];
  const std::uint32_t carrier = use(static_cast<std::uint32_t>(contact_mesh.n_nodes()) + body);
  const Eigen::Vector3d arm = kinematics_->x(node) + beside - state_->rigid[body].position;
  const auto same = std::ranges::find_if(
      terms, [&](const CarrierTerm& term) { return term.carrier == carrier && term.weight * weight > 0.0; });
  if (same == terms.end()) {
    terms.push_back({carrier, weight, arm});
    return;
  }
  const double sum = same->weight + weight;
  same->arm += weight / sum * (arm - same->arm);
  same->weight = sum;
}

double NodeMobility::turn_root(std::uint32_t carrier, const Eigen::Vector3d& turn) const {
  if (carriers_[carrier].ring) return turn.norm();
  if (!carriers_[carrier].general) return 0.0;
  const Eigen::Matrix3d& rotation = generals_[*carriers_[carrier].general].rotation;
  return std::sqrt(std::max(0.0, half_steps_ * turn.dot(rotation * turn)));
}

CarrierMobility NodeMobility::mobility(std::uint32_t carrier) const {
  const Carrier& own = carriers_[carrier];
  if (!own.general) return {own.mobility * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero()};
  const General& general = generals_[*own.general];
  return {half_steps_ * general.translation, half_steps_ * general.rotation};
}

void NodeMobility::spread_areas(LeaningAreas& areas) const {
  const LoftSpins& spins = kinematics_->spins();
  for (const Ring& ring : rings_) {
    const double area = areas[ring.carrier][1];
    areas[ring.carrier][0] += area * spins.own_bound(ring.spin);
    for (std::size_t k = 0; k < spins.neighbours(ring.spin).size(); ++k)
      areas[ring_carriers_[ring.first + k]][0] += area * spins.bound(ring.spin, k);
  }
  for (const Ring& ring : rings_) {
    const auto turns = [&](std::uint32_t carrier, double bound) {
      return bound * translation_bound(carrier) * areas[carrier][0];
    };
    double sum = turns(ring.carrier, spins.own_bound(ring.spin));
    for (std::size_t k = 0; k < spins.neighbours(ring.spin).size(); ++k)
      sum += turns(ring_carriers_[ring.first + k], spins.bound(ring.spin, k));
    areas[ring.carrier][1] = sum;
  }
}

/// Gives the moments on rings to the nodes around, and then turns the rings as these move.
void NodeMobility::turn_rings(Changes& of) const {
  const LoftSpins& spins = kinematics_->spins();
  for (const Ring& ring : rings_) {
    const Eigen::Vector3d moment = of.turnings[ring.carrier].head<3>();
    if (moment.isZero(0.0)) continue;
    const Eigen::Vector3d own =
        spins.spread(ring.spin, moment, [&](std::size_t k, const Eigen::Vector3d& force) {
          const std::uint32_t carrier = ring_carriers_[ring.first + k];
          of.changes[carrier].head<3>() += moved_by(carrier, force);
        });
    of.changes[ring.carrier].head<3>() += moved_by(ring.carrier, own);
  }
  for (const Ring& ring : rings_) {
    const auto change = [&](std::uint32_t carrier) -> Eigen::Vector3d {
      return of.changes[carrier].head<3>();
    };
    of.turnings[ring.carrier].head<3>() =
        spins.spin(ring.spin, Eigen::Vector3d::Zero(), change(ring.carrier),
                   [&](std::size_t k) { return change(ring_carriers_[ring.first + k]); });
  }
}

void NodeMobility::begin_passes() {
  first_ = next_;
  now_ = next_;
  pressed_.assign(carriers_.size(), NodeVector::Zero());
  turn_rings(now_);
  turns_ =
      std::ranges::any_of(carriers_, [](const Carrier& carrier) { return carrier.general || carrier.ring; });
}

void NodeMobility::end_pass() {
  std::swap(now_, next_);
  parallel_for_ranges(
      std::ssize(carriers_), threads_for(carriers_.size()), [this](std::int64_t begin, std::int64_t end) {
        for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i) {
          now_.changes[i] += carriers_[i].mobility * pressed_[i];
          pressed_[i].setZero();
        }
        const auto begin_again = [&](const auto& first, auto& next) {
          std::copy(first.begin() + begin, first.begin() + end, next.begin() + begin);
        };
        begin_again(first_.changes, next_.changes);
        if (turns_) begin_again(first_.turnings, next_.turnings);
      });
  turn_rings(now_);
}

/// The change of velocity by a force over the coming step.
Eigen::Vector3d NodeMobility::moved_by(std::uint32_t carrier, const Eigen::Vector3d& force) const {
  const Carrier& pushed = carriers_[carrier];
  if (!pushed.general) return pushed.mobility * force;
  return generals_[*pushed.general].translation * (half_steps_ * force);
}

void NodeMobility::push(std::uint32_t carrier, const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
  next_.changes[carrier].head<3>() += moved_by(carrier, force);
  const Carrier& pushed = carriers_[carrier];
  if (pushed.ring) {
    next_.turnings[carrier].head<3>() += moment;
  } else if (pushed.general) {
    next_.turnings[carrier].head<3>() += generals_[*pushed.general].rotation * (half_steps_ * moment);
  }
}

}  // namespace contactsim
