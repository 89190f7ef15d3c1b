// SPDX-License-Identifier: BSD-3-Clause
#include <utility>
#include <vector>

#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/kinematic_conflicts.hpp"
#include "core/conditions/kinematics.hpp"
#include "core/conditions/oblique_holds.hpp"
#include "core/conditions/stored_values.hpp"
#include "core/least_mass.hpp"

namespace contactsim {

namespace {

const char* words_of(PrescribedQuantity quantity) {
  static constexpr const char* words[] = {"the prescribed displacement", "the prescribed velocity",
                                          "the prescribed acceleration", "the prescribed rotation",
                                          "the prescribed rotational velocity"};
  return words[static_cast<std::size_t>(quantity)];
}

Drive drive_of(PrescribedQuantity quantity) {
  switch (quantity) {
    case PrescribedQuantity::displacement:
    case PrescribedQuantity::rotation:
      return Drive::displacement;
    case PrescribedQuantity::velocity:
    case PrescribedQuantity::rotational_velocity:
      return Drive::velocity;
    case PrescribedQuantity::acceleration:
      break;
  }
  return Drive::acceleration;
}

bool is_of_rotations(const PrescribedCondition& prescribed) {
  return prescribed.quantity == PrescribedQuantity::rotation ||
         prescribed.quantity == PrescribedQuantity::rotational_velocity;
}

/// What conditions are compiled for.
struct Driven {
  bool are_bodies = false;                    ///< rigid bodies in place of nodes
  bool turn = false;                          ///< rotations in place of places
  const Eigen::Matrix3Xd* inertia = nullptr;  ///< of the nodes, when these turn
};

/// Compiles conditions, each on its own.
class KinematicsMaker {
 public:
  KinematicsMaker(const ConditionScope& scope, const Driven& driven) : scope_(scope), wanted_(driven) {}

  void add(const FixedCondition& fixed);
  void add(const PrescribedCondition& prescribed);
  std::vector<DrivenNodes> take() { return std::move(driven_); }

 private:
  bool find_names(const EntitySet& set, const DirectionChoice& choice, DrivenNodes& driven) const;
  bool keep_turning(std::vector<NodeIndex>& nodes) const;
  void sort_out_bodies(DrivenNodes& driven) const;

  const ConditionScope& scope_;
  Driven wanted_;
  std::vector<DrivenNodes> driven_;
};

/// Returns whether there is something to drive.
bool KinematicsMaker::find_names(const EntitySet& set, const DirectionChoice& choice,
                                 DrivenNodes& driven) const {
  driven.nodes = find_nodes(set, driven.label, scope_);
  sort_out_bodies(driven);
  const auto direction = find_direction(choice, scope_);
  if (direction) driven.direction = *direction;
  if (const auto* axis = std::get_if<Axis>(&driven.direction); axis != nullptr && wanted_.turn)
    driven.direction = Eigen::Vector3d(axis->direction);
  return direction && !driven.nodes.empty();
}

/// Leaves nodes that are free, or bodies of which all nodes are named.
void KinematicsMaker::sort_out_bodies(DrivenNodes& driven) const {
  if (scope_.rigid == nullptr || scope_.rigid->names.empty()) return;
  const RigidNodes& rigid = *scope_.rigid;
  std::vector<std::size_t> counts(rigid.names.size(), 0);
  std::vector<NodeIndex> free, bodies;
  for (const NodeIndex node : driven.nodes) {
    if (rigid.is_free(node))
      free.push_back(node);
    else
      ++counts[static_cast<std::size_t>(rigid.body_of[node.value])];
  }
  for (std::uint32_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == rigid.counts[i]) bodies.push_back({i});
    if (wanted_.are_bodies || counts[i] == 0 || counts[i] == rigid.counts[i]) continue;
    scope_.diagnostics.add_warning(
        "condition-rigid", driven.label.location,
        driven.label.what + " leaves out nodes of the rigid body '" + rigid.names[i] + "'",
        "name its block or the body itself to act on all of it");
  }
  driven.nodes = wanted_.are_bodies ? std::move(bodies) : std::move(free);
}

/// Returns whether some are left, or there were none before.
bool KinematicsMaker::keep_turning(std::vector<NodeIndex>& nodes) const {
  if (wanted_.inertia == nullptr || nodes.empty()) return true;
  const Eigen::Matrix3Xd& inertia = *wanted_.inertia;
  std::erase_if(nodes,
                [&](NodeIndex node) { return inertia.cols() == 0 || inertia(0, node.value) <= least_mass; });
  return !nodes.empty();
}

void KinematicsMaker::add(const FixedCondition& fixed) {
  DrivenNodes driven;
  driven.label = {fixed.is_rotation ? "the fixed rotation" : "the fixed displacement", fixed.name.location};
  driven.times = make_active_times(fixed.periods, scope_.blocks);
  const bool has_nodes = find_names(fixed.set, fixed.direction, driven);
  if (!keep_turning(driven.nodes)) {
    scope_.diagnostics.add_warning("condition-ignored", fixed.name.location,
                                   "the fixed rotation has no effect: none of its nodes has rotations, as "
                                   "those of shells, beams and point inertias do");
    return;
  }
  if (has_nodes) driven_.push_back(std::move(driven));
}

void KinematicsMaker::add(const PrescribedCondition& prescribed) {
  DrivenNodes driven;
  driven.label = {words_of(prescribed.quantity), prescribed.name.location};
  driven.drive = drive_of(prescribed.quantity);
  driven.times = make_active_times(prescribed.periods, scope_.blocks);
  const bool has_nodes = find_names(prescribed.set, prescribed.direction, driven);
  if (!keep_turning(driven.nodes)) {
    return scope_.diagnostics.add_error(
        driven.label.location,
        driven.label.what +
            " cannot act: none of its nodes has rotations, as those of shells, beams and point inertias do",
        "PRESCRIBED DISPLACEMENT or VELOCITY with CYLINDRICAL AXIS turns nodes about an axis");
  }
  if (wanted_.are_bodies && prescribed.variable.variable && has_nodes) {
    return scope_.diagnostics.add_error(driven.label.location,
                                        driven.label.what + " of a rigid body cannot be read from the mesh",
                                        "give it a FUNCTION");
  }
  const ValueTarget target{prescribed.direction.components, driven.nodes, driven.label};
  const auto values = find_condition_values(prescribed.function, prescribed.variable, target, scope_);
  if (!values || !has_nodes) return;
  if (values->size() == 1) {
    driven.value = values->front();
    driven_.push_back(std::move(driven));
    return;
  }
  std::size_t next = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!prescribed.direction.components[c]) continue;
    DrivenNodes& part = driven_.emplace_back(driven);
    part.direction = Components{{c == 0, c == 1, c == 2}};
    part.value = (*values)[next++];
  }
}

Kinematics compile(const ConditionScope& scope, const Driven& wanted) {
  KinematicsMaker maker(scope, wanted);
  for (const FixedCondition& fixed : scope.region.fixed_conditions) {
    if (fixed.is_rotation == wanted.turn) maker.add(fixed);
  }
  for (const PrescribedCondition& prescribed : scope.region.prescribed_conditions) {
    if (is_of_rotations(prescribed) == wanted.turn) maker.add(prescribed);
  }
  std::vector<DrivenNodes> driven = maker.take();
  const Mesh& mesh = wanted.are_bodies ? *scope.rigid->references : scope.mesh;
  check_conflicts(driven, mesh, scope.diagnostics);
  return Kinematics(mesh, separate_oblique_holds(std::move(driven)));
}

/// Conditions on bodies are looked up a second time: what is wrong with them has been said.
Kinematics compile_bodies(const ConditionScope& scope, bool turn) {
  if (scope.rigid == nullptr || scope.rigid->names.empty() || scope.diagnostics.has_errors()) return {};
  Diagnostics quiet;
  const ConditionScope again{scope.definition, scope.region, scope.blocks, scope.mesh, quiet,
                             scope.stored,     scope.rigid};
  Kinematics made = compile(again, {true, turn, nullptr});
  for (const Diagnostic& diagnostic : quiet.all()) {
    if (diagnostic.severity == Severity::error)
      scope.diagnostics.add_error(diagnostic.location, diagnostic.text, diagnostic.hint);
  }
  return made;
}

}  // namespace

Kinematics make_kinematics(const ConditionScope& scope) { return compile(scope, {}); }

Kinematics make_rotation_kinematics(const ConditionScope& scope, const Eigen::Matrix3Xd& inertia) {
  return compile(scope, {false, true, &inertia});
}

Kinematics make_body_kinematics(const ConditionScope& scope) { return compile_bodies(scope, false); }

Kinematics make_body_rotation_kinematics(const ConditionScope& scope) { return compile_bodies(scope, true); }

}  // namespace contactsim
