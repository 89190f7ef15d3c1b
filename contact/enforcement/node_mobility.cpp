// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/node_mobility.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "core/least_mass.hpp"

namespace contactsim {

namespace {

/// Bound of the largest eigenvalue of a symmetric matrix without negative ones, by the smaller of two bounds.
double largest_stretch(const Eigen::Matrix3d& symmetric) {
  return std::min(symmetric.trace(), symmetric.cwiseAbs().rowwise().sum().maxCoeff());
}

bool is_positive(double mass) { return mass > least_mass; }

}  // namespace

void NodeMobility::begin(const Model& model, const MovingSurface& surface, const State& state) {
  surface_ = &surface;
  rigid_ = &model.rigid.nodes;
  state_ = &state;
  half_steps_ = 0.5 * (state.dt + state.next_dt);
  for (const Carrier& carrier : carriers_) carrier_[carrier.body] = none;
  carriers_.clear();
  mesh_nodes_.clear();
  for (Changes* changes : {&now_, &next_}) {
    changes->changes.clear();
    changes->turnings.clear();
  }
  if (free_.update(model, state.time) || inverse_mass_.empty()) {
    const std::size_t n_bodies = surface.faces().n_nodes() + model.rigid.bodies.size();
    general_.assign(n_bodies, none);
    inverse_mass_.assign(n_bodies, 0.0);
    carrier_.assign(n_bodies, none);
    generals_.clear();
    set_nodes(model);
    set_bodies(model);
  }
  turn_bodies(model, state);
}

NodeMobility::General& NodeMobility::make_general(std::uint32_t body) {
  general_[body] = static_cast<std::uint32_t>(generals_.size());
  return generals_.emplace_back();
}

void NodeMobility::set_nodes(const Model& model) {
  const ContactFaces& faces = surface_->faces();
  const bool turns = model.inertia.cols() > 0;
  const Eigen::Matrix3d all = Eigen::Matrix3d::Identity();
  for (std::uint32_t i = 0; i < faces.n_nodes(); ++i) {
    const NodeIndex node{faces.mesh_nodes[i]};
    const double mass = model.mass(0, node.value);
    if (faces.first_alike[i] != i || !rigid_->is_free(node) || !is_positive(mass)) continue;
    const Eigen::Matrix3d* free = free_.of_node(node.value);
    const double inertia = turns ? model.inertia(0, node.value) : 0.0;
    const bool is_held = free != nullptr && free->isZero(0.0);
    if (!is_positive(inertia) && (free == nullptr || is_held || *free == all)) {
      inverse_mass_[i] = is_held ? 0.0 : 1.0 / mass;
      continue;
    }
    General& general = make_general(i);
    general.translation = (free != nullptr ? *free : all) / mass;
    if (!is_positive(inertia)) continue;
    const Eigen::Matrix3d* free_turns = free_.of_turns(node.value);
    general.rotation = (free_turns != nullptr ? *free_turns : all) / inertia;
  }
}

void NodeMobility::set_bodies(const Model& model) {
  for (std::uint32_t i = 0; i < model.rigid.bodies.size(); ++i) {
    General& general = make_general(static_cast<std::uint32_t>(surface_->faces().n_nodes()) + i);
    const Eigen::Matrix3d* free = free_.of_body(i);
    general.translation =
        (free != nullptr ? *free : Eigen::Matrix3d::Identity()) / model.rigid.bodies[i].mass;
  }
}

void NodeMobility::turn_bodies(const Model& model, const State& state) {
  for (std::uint32_t i = 0; i < model.rigid.bodies.size(); ++i) {
    const RigidBody& body = model.rigid.bodies[i];
    General& general = generals_[general_[surface_->faces().n_nodes() + i]];
    const Eigen::Matrix3d axes = state.rigid[i].orientation.toRotationMatrix();
    const Eigen::Matrix3d* free = free_.of_body_turns(i);
    if (free == nullptr) {
      general.rotation = axes * body.flexible * axes.transpose();
    } else {
      const Eigen::Matrix3d inertia = *free * axes * body.inertia * axes.transpose() * *free;
      general.rotation = inverse_where_it_is(inertia);
    }
  }
}

std::uint32_t NodeMobility::use(std::uint32_t body) {
  std::uint32_t& carrier = carrier_[body];
  if (carrier != none) return carrier;
  carrier = static_cast<std::uint32_t>(carriers_.size());
  Carrier& made = carriers_.emplace_back(body, general_[body], half_steps_ * inverse_mass_[body]);
  if (made.general != none) {
    const General& general = generals_[made.general];
    made.mobility = half_steps_ * largest_stretch(general.translation);
    made.turn_bound = std::sqrt(half_steps_ * largest_stretch(general.rotation));
  }
  next_.changes.push_back(NodeVector::Zero());
  next_.turnings.push_back(NodeVector::Zero());
  return carrier;
}

std::uint32_t NodeMobility::use_node(std::uint32_t node) {
  const std::size_t n_before = carriers_.size();
  const std::uint32_t carrier = use(surface_->faces().first_alike[node]);
  if (carriers_.size() > n_before) mesh_nodes_.push_back(surface_->faces().mesh_nodes[node]);
  return carrier;
}

std::optional<std::uint32_t> NodeMobility::plain_carrier(std::uint32_t node) {
  const ContactFaces& faces = surface_->faces();
  const bool is_plain =
      rigid_->is_free({faces.mesh_nodes[node]}) && general_[faces.first_alike[node]] == none;
  return is_plain ? std::optional(use_node(node)) : std::nullopt;
}

void NodeMobility::add_terms(std::uint32_t node, double weight, const Eigen::Vector3d& beside,
                             std::vector<CarrierTerm>& terms) {
  const ContactFaces& faces = surface_->faces();
  const NodeIndex mesh_node{faces.mesh_nodes[node]};
  if (rigid_->is_free(mesh_node)) {
    Eigen::Vector3d arm = beside;
    const std::size_t n_mesh_points = faces.n_mesh_points();
    if (node >= n_mesh_points) arm += surface_->arms().col(static_cast<Eigen::Index>(node - n_mesh_points));
    terms.push_back({use_node(node), weight, arm});
    return;
  }
  const auto body = static_cast<std::uint32_t>(rigid_->body_of[mesh_node.value]);
  const std::uint32_t carrier = use(static_cast<std::uint32_t>(faces.n_nodes()) + body);
  const Eigen::Vector3d arm = surface_->x(node) + beside - state_->rigid[body].position;
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
  if (carriers_[carrier].general == none) return 0.0;
  const Eigen::Matrix3d& rotation = generals_[carriers_[carrier].general].rotation;
  return std::sqrt(std::max(0.0, half_steps_ * turn.dot(rotation * turn)));
}

CarrierMobility NodeMobility::mobility(std::uint32_t carrier) const {
  const Carrier& own = carriers_[carrier];
  if (own.general == none) return {own.mobility * Eigen::Matrix3d::Identity(), Eigen::Matrix3d::Zero()};
  const General& general = generals_[own.general];
  return {half_steps_ * general.translation, half_steps_ * general.rotation};
}

void NodeMobility::begin_passes() {
  first_ = next_;
  now_ = next_;
}

void NodeMobility::end_pass() {
  std::swap(now_, next_);
  next_ = first_;
}

void NodeMobility::push(std::uint32_t carrier, const Eigen::Vector3d& force, const Eigen::Vector3d& moment) {
  const Carrier& pushed = carriers_[carrier];
  if (pushed.general == none) {
    next_.changes[carrier].head<3>() += pushed.mobility * force;
    return;
  }
  const General& general = generals_[pushed.general];
  next_.changes[carrier].head<3>() += general.translation * (half_steps_ * force);
  next_.turnings[carrier].head<3>() += general.rotation * (half_steps_ * moment);
}

}  // namespace contactsim
