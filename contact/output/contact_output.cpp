// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/contact_output.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "core/base/names.hpp"
#include "core/dynamics/state_motion.hpp"

namespace contactsim {

namespace {

/// Nodes of blocks and surfaces that take part.
std::vector<double> find_rest_status(const ContactModel& contact, const Mesh& mesh) {
  std::vector<double> status(mesh.n_nodes(), 0.0);
  std::vector<std::uint8_t> is_in(mesh.blocks().size(), 0);
  for (const ContactSurface& surface : contact.surfaces.surfaces) {
    for (const ElementSide face : surface.faces) is_in[mesh.block_of(face.element())] = 1;
    for (const ElementIndex element : surface.lofted_elements) is_in[mesh.block_of(element)] = 1;
    for (const NodeIndex node : surface.nodes) status[node.value] = 0.5;
  }
  for (std::size_t b = 0; b < is_in.size(); ++b) {
    if (is_in[b] == 0) continue;
    for (const NodeIndex node : mesh.blocks()[b].nodes) status[node.value] = 0.5;
  }
  return status;
}

void add(const ContactTotal& part, ContactTotal& sum) {
  sum.normal_force += part.normal_force;
  sum.friction_force += part.friction_force;
  sum.normal_moment += part.normal_moment;
  sum.friction_moment += part.friction_moment;
  sum.centre += part.centre;
  sum.normal_sum += part.normal_sum;
  sum.area += part.area;
}

/// The points of lofts that hang on one node: the one that has slid farthest says how far, energies add up.
void add(const NodeFriction& point, NodeFriction& sum) {
  const double energy = sum.energy + point.energy;
  if (point.slip_length > sum.slip_length) sum = point;
  sum.energy = energy;
}

/// The same on the other side.
ContactTotal opposite(ContactTotal total) {
  total.normal_force = -total.normal_force;
  total.friction_force = -total.friction_force;
  total.normal_moment = -total.normal_moment;
  total.friction_moment = -total.friction_moment;
  return total;
}

/// The pair that a pair adds to in the totals: of those that take turns by their periods the first one that
/// an interaction names.
PairIndex find_total(const SurfacePairs& pairs, PairIndex index) {
  const SurfacePair& pair = pairs[index];
  const bool takes_turns = !pair.periods.active.empty() || !pair.periods.inactive.empty();
  if (!takes_turns) return index;
  const auto is_it = [&](const SurfacePair& other) {
    return !other.is_from_defaults &&
           std::minmax(other.first, other.second) == std::minmax(pair.first, pair.second);
  };
  const auto found = std::ranges::find_if(pairs, is_it);
  return found == pairs.end() ? index : index_of(pairs, found);
}

}  // namespace

ContactOutput::ContactOutput(ContactForce& force, const ContactModel& contact, const Model& model)
    : force_(force),
      contact_(contact),
      model_(model),
      surfaces_(contact.surfaces.surfaces.size()),
      pairs_(contact.pairs.size()) {}

/// Most runs never ask, and the arrays are large.
void ContactOutput::begin() {
  rest_status_ = find_rest_status(contact_, *model_.mesh);
  contact_node_.assign(model_.mesh->n_nodes(), std::nullopt);
  const ContactMesh& contact_mesh = force_.contact_mesh();
  for (std::uint32_t i = 0; i < contact_mesh.n_nodes(); ++i)
    contact_node_[contact_mesh.mesh_nodes[i]] = contact_mesh.first_alike[i];
  nodes_.resize(contact_mesh.n_nodes());
}

std::vector<OutputVariable> ContactOutput::variables() {
  std::vector<OutputVariable> made;
  for (const ContactNodeRow& row : contact_node_rows()) {
    const auto size = static_cast<std::size_t>(component_count(row.shape));
    OutputVariable variable{
        std::string(row.name), FieldLocation::node, row.shape, component_count(row.shape), false, {}, {}};
    variable.fill = [this, &row, size](const OutputContext& context, const EntityRange& range,
                                       std::span<double> values) {
      evaluate(context.state);
      if (row.needs_gaps) evaluate_gaps(context.state);
      for (std::size_t i = 0; i < range.count; ++i) {
        const std::size_t node = range.first + i;
        NodeContact at_rest;
        at_rest.status = rest_status_[node];
        const OptionalIndex<std::uint32_t> own = contact_node_[node];
        row.fill(own ? nodes_[*own] : at_rest, values.data() + i * size);
      }
    };
    made.push_back(std::move(variable));
  }
  for (const ContactTotalRow& row : contact_total_rows()) {
    const auto& surfaces = contact_.surfaces.surfaces;
    for (std::size_t i = 0; i < surfaces.size(); ++i)
      made.push_back(make_total(
          row, surfaces[i].name, [ this, i ]() -> const auto& { return surfaces_[i]; }));
    for (const PairIndex i : indices(contact_.pairs)) {
      // What stands in for a pair outside its periods adds to its totals.
      if (find_total(contact_.pairs, i) != i) continue;
      const SurfacePair& pair = contact_.pairs[i];
      made.push_back(make_total(
          row, surfaces[pair.first].name + "_" + surfaces[pair.second].name,
          [ this, i ]() -> const auto& { return pairs_[i]; }));
    }
  }
  OutputVariable deepest{
      "contact_penetration_max", FieldLocation::global, FieldShape::scalar, 1, false, {}, {}};
  deepest.fill = [this](const OutputContext&, const EntityRange&, std::span<double> values) {
    values[0] = 0.0;
    for (const PairHistory& history : force_.histories()) values[0] = std::max(values[0], history.deepest);
  };
  made.push_back(std::move(deepest));
  return made;
}

OutputVariable ContactOutput::make_total(const ContactTotalRow& row, const std::string& name,
                                         std::function<const ContactTotal&()> total) {
  OutputVariable variable{fold(std::string(row.name) + "_" + name),
                          FieldLocation::global,
                          row.shape,
                          component_count(row.shape),
                          false,
                          {},
                          {}};
  variable.fill = [this, &row, total = std::move(total)](const OutputContext& context, const EntityRange&,
                                                         std::span<double> values) {
    evaluate(context.state);
    row.fill(total(), values.data());
  };
  return variable;
}

void ContactOutput::evaluate(const State& state) {
  const std::lock_guard guard(lock_);
  if (state.step == step_) return;
  if (step_ < 0) begin();
  step_ = state.step;
  const auto friction = force_.node_friction();
  const auto& first_alike = force_.contact_mesh().first_alike;
  for (NodeContact& node : nodes_) {
    node = {};
    node.status = 0.5;
  }
  for (std::size_t i = 0; i < friction.size(); ++i) {
    NodeContact& node = nodes_[first_alike[i]];
    add(friction[i], node.friction);
    node.slip_rate = state.dt > 0.0 ? node.friction.last_slip.norm() / state.dt : 0.0;
  }
  for (const SurfaceNode& node : force_.contact_mesh().surface_nodes)
    nodes_[first_alike[node.node]].surface_area += node.area;
  std::fill(surfaces_.begin(), surfaces_.end(), ContactTotal{});
  std::fill(pairs_.begin(), pairs_.end(), ContactTotal{});
  const auto histories = force_.histories();
  for (const PairIndex i : indices(histories)) {
    const SurfacePair& pair = contact_.pairs[i];
    ContactTotal* const of_pair = &pairs_[find_total(contact_.pairs, i)];
    const auto add_history = [&](ContactTotal& total) {
      total.penetration = std::max(total.penetration, histories[i].deepest);
      total.energy += histories[i].taken + histories[i].ramped;
      total.friction += histories[i].friction_work;
    };
    add_history(*of_pair);
    add_history(surfaces_[pair.first]);
    if (pair.first != pair.second) add_history(surfaces_[pair.second]);
  }
  for (const ContactPoint& point : force_.points()) add_place(point);
  for (const ConstraintForces& held : force_.constraint_forces()) add_tie(held.constraint, held.forces);
}

void ContactOutput::evaluate_gaps(const State& state) {
  const std::lock_guard guard(lock_);
  if (state.step == gaps_step_) return;
  gaps_step_ = state.step;
  const std::vector<double> gaps = force_.node_gaps(motion_of(state));
  const auto& first_alike = force_.contact_mesh().first_alike;
  std::vector<std::uint8_t> is_known(nodes_.size(), 0);
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    NodeContact& node = nodes_[first_alike[i]];
    if (node.status == 1.0) continue;
    std::uint8_t& known = is_known[first_alike[i]];
    if (known == 0 || std::abs(gaps[i]) < std::abs(node.gap)) node.gap = gaps[i];
    known = 1;
  }
}

void ContactOutput::add_to_totals(PairIndex pair, bool is_swapped, const ContactTotal& on_first) {
  const ContactTotal on_second = opposite(on_first);
  const SurfacePair& of = contact_.pairs[pair];
  const PairIndex total = find_total(contact_.pairs, pair);
  const bool is_turned = contact_.pairs[total].first != of.first;
  add(is_swapped != is_turned ? on_second : on_first, pairs_[total]);
  add(on_first, surfaces_[is_swapped ? of.second : of.first]);
  add(on_second, surfaces_[is_swapped ? of.first : of.second]);
}

void ContactOutput::add_place(const ContactPoint& contact_point) {
  add_to_nodes(contact_point, contact_point.first, 1.0);
  add_to_nodes(contact_point, contact_point.second, -1.0);
  if (!contact_point.touches()) return;
  Eigen::Vector3d point_position = Eigen::Vector3d::Zero();
  for (std::size_t k = 0; k < 4; ++k)
    point_position += contact_point.first.weights[static_cast<Eigen::Index>(k)] *
                      force_.position(contact_point.first.nodes[k]);
  ContactTotal total;
  total.add(point_position, contact_point.force * contact_point.normal, contact_point.tangential);
  total.normal_sum = contact_point.force;
  total.centre = contact_point.force * point_position;
  total.area = contact_point.area;
  add_to_totals(contact_point.pair, contact_point.is_swapped, total);
}

void ContactOutput::add_to_nodes(const ContactPoint& contact_point, const ContactPointSide& side,
                                 double sign) {
  const bool has_friction = force_.rules().of(contact_point).friction > 0.0;
  for (std::size_t k = 0; k < 4; ++k) {
    const double weight = side.weights[static_cast<Eigen::Index>(k)];
    if (weight == 0.0) continue;
    NodeContact& node = nodes_[force_.contact_mesh().first_alike[side.nodes[k]]];
    const bool is_first_place = node.interaction == 0.0;
    node.interaction = contact_point.pair.value + 1.0;
    if (is_first_place || contact_point.gap < node.gap) {
      node.gap = contact_point.gap;
      node.tangential_gap = contact_point.elastic_slip.norm();
    }
    if (!contact_point.touches()) continue;
    node.status = 1.0;
    if (has_friction)
      node.slip_status = std::max(node.slip_status, contact_point.dissipated > 0.0 ? 2.0 : 1.0);
    node.normal += sign * weight * contact_point.force * contact_point.normal;
    node.tangential += sign * weight * contact_point.tangential;
    node.area += weight * contact_point.area;
  }
}

void ContactOutput::add_tie(const InterfaceConstraint& tie, const CornerForces& forces) {
  if (forces.normal.isZero()) return;
  ContactTotal total;
  total.area = tie.area;
  for (std::size_t k = 0; k < 8; ++k) {
    const Eigen::Vector3d force = forces.forces.col(static_cast<Eigen::Index>(k));
    const bool is_first = k < 4;
    const auto same = std::find(tie.nodes.begin() + (is_first ? 0 : 4),
                                tie.nodes.begin() + static_cast<int>(k), tie.nodes[k]);
    NodeContact& node = nodes_[force_.contact_mesh().first_alike[tie.nodes[k]]];
    const Eigen::Vector3d normal = forces.normal.dot(force) * forces.normal;
    node.status = node.slip_status = 1.0;
    node.interaction = tie.pair.value + 1.0;
    node.normal += normal;
    node.tangential += force - normal;
    const bool is_repeated = same != tie.nodes.begin() + static_cast<int>(k);
    if (!is_repeated) node.area += tie.area * tie_share(tie, is_first);
    if (!is_first) continue;
    total.add(force_.position(tie.nodes[k]), normal, force - normal);
    total.normal_sum += std::abs(normal.norm());
    total.centre += normal.norm() * force_.position(tie.nodes[k]);
  }
  add_to_totals(tie.pair, tie.is_swapped, total);
}

double ContactOutput::tie_share(const InterfaceConstraint& tie, bool is_first) {
  std::array<std::uint32_t, 4> nodes;
  std::copy_n(tie.nodes.begin() + (is_first ? 0 : 4), 4, nodes.begin());
  std::sort(nodes.begin(), nodes.end());
  return 1.0 / static_cast<double>(std::unique(nodes.begin(), nodes.end()) - nodes.begin());
}

}  // namespace contactsim
