// SPDX-License-Identifier: BSD-3-Clause
#include "contact/output/contact_output.hpp"

#include <algorithm>
#include <cmath>
#include <span>

#include "contact/output/side_set_totals.hpp"
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
  for (const ContactNodeIndex i : contact_mesh.nodes())
    contact_node_[contact_mesh.mesh_nodes[i].value] = contact_mesh.first_alike[i];
  nodes_.resize(contact_mesh.n_nodes());
}

std::vector<OutputVariable> ContactOutput::variables() {
  std::vector<OutputVariable> made;
  for (const ContactNodeRow& row : contact_node_rows()) {
    const auto size = static_cast<std::size_t>(row.n_components());
    OutputVariable variable{
        std::string(row.name), FieldLocation::node, row.shape, row.n_components(), false, {}, {}};
    variable.fill = [this, &row, size](const OutputContext& context, const EntityRange& range,
                                       std::span<double> values) {
      evaluate(context.state);
      if (row.needs_gaps) evaluate_gaps(context.state);
      for (std::size_t i = 0; i < range.count; ++i) {
        const std::size_t node = range.first + i;
        NodeContact at_rest;
        at_rest.status = rest_status_[node];
        const OptionalIndex<ContactNodeIndex> own = contact_node_[node];
        row.fill(own ? nodes_[*own] : at_rest, values.data() + i * size);
      }
    };
    variable.dimension = dimension_of(row.help);
    made.push_back(std::move(variable));
  }
  add_side_sets(made);
  for (const ContactTotalRow& row : contact_total_rows()) {
    const auto& surfaces = contact_.surfaces.surfaces;
    for (const SurfaceIndex i : indices(surfaces)) {
      const auto of_surface = [this, i](const State& state) -> const ContactTotal& {
        return evaluate(state), surfaces_[i];
      };
      made.push_back(make_total(row, surfaces[i].name, of_surface));
    }
    for (const PairIndex i : indices(contact_.pairs)) {
      // What stands in for a pair outside its periods adds to its totals.
      if (find_total(contact_.pairs, i) != i) continue;
      const SurfacePair& pair = contact_.pairs[i];
      const auto of_pair = [this, i](const State& state) -> const ContactTotal& {
        return evaluate(state), pairs_[i];
      };
      made.push_back(make_total(row, surfaces[pair.first].name + "_" + surfaces[pair.second].name, of_pair));
    }
  }
  OutputVariable deepest{
      "contact_penetration_max", FieldLocation::global, FieldShape::scalar, 1, false, {}, {}, "[length]"};
  deepest.fill = [this](const OutputContext&, const EntityRange&, std::span<double> values) {
    values[0] = 0.0;
    for (const PairHistory& history : force_.histories()) values[0] = std::max(values[0], history.deepest);
  };
  made.push_back(std::move(deepest));
  return made;
}

template <class Find>
OutputVariable ContactOutput::make_total(const ContactTotalRow& row, const std::string& name,
                                         const Find& find) {
  OutputVariable variable{fold(std::string(row.name) + "_" + name),
                          FieldLocation::global,
                          row.shape,
                          component_count(row.shape),
                          false,
                          {},
                          {},
                          std::string(dimension_of(row.help))};
  variable.fill = [&row, find](const OutputContext& context, const EntityRange&, std::span<double> values) {
    row.fill(find(context.state), values.data());
  };
  return variable;
}

/// Surfaces and pairs come later and hide side sets of their names.
void ContactOutput::add_side_sets(std::vector<OutputVariable>& variables) {
  const Mesh& mesh = *model_.mesh;
  side_sets_.resize(mesh.side_sets().size());
  for (std::uint32_t i = 0; i < side_sets_.size(); ++i) {
    const auto of_set = [this, i](const State& state) -> const ContactTotal& {
      return total_of_side_set(i, state);
    };
    const std::string name = mesh.name({EntityKind::side_set, i}),
                      by_id = default_name(EntityKind::side_set, mesh.side_sets()[i].id);
    for (const ContactTotalRow& row : contact_total_rows()) {
      if (row.is_of_pairs) continue;
      variables.push_back(make_total(row, name, of_set));
      if (fold(name) != by_id) variables.push_back(make_total(row, by_id, of_set));
    }
  }
}

const ContactTotal& ContactOutput::total_of_side_set(std::size_t index, const State& state) {
  const std::lock_guard guard(lock_);
  SideSetTotal& set = side_sets_[index];
  if (set.step == state.step) return set.total;
  if (!set.step) {
    set.sides = model_.mesh->side_sets()[index].sides;
    std::ranges::sort(set.sides);
  }
  set.step = state.step;
  set.total = sum_over_sides(force_, set.sides);
  return set.total;
}

void ContactOutput::renew() {
  step_ = gaps_step_ = std::nullopt;
  for (SideSetTotal& set : side_sets_) set.step = std::nullopt;
}

void ContactOutput::evaluate(const State& state) {
  const std::lock_guard guard(lock_);
  if (state.step == step_) return;
  if (!step_) begin();
  step_ = state.step;
  const auto friction = force_.node_friction();
  const auto& first_alike = force_.contact_mesh().first_alike;
  for (NodeContact& node : nodes_) {
    node = {};
    node.status = 0.5;
  }
  for (const ContactNodeIndex i : indices(friction)) {
    NodeContact& node = nodes_[first_alike[i]];
    NodeFriction point = friction[i];
    point.slip = force_.node_slip(i);
    add(point, node.friction);
    if (!(state.dt > 0.0)) continue;
    node.slip_rate = node.friction.last_slip.norm() / state.dt;
    node.slip_velocity = node.friction.last_slip / state.dt;
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
  const IndexedVector<ContactNodeIndex, double> gaps = force_.node_gaps(motion_of(state));
  const auto& first_alike = force_.contact_mesh().first_alike;
  IndexedVector<ContactNodeIndex, std::uint8_t> is_known(nodes_.size(), 0);
  for (const ContactNodeIndex i : indices(gaps)) {
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

}  // namespace contactsim
