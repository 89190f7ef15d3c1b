// SPDX-License-Identifier: BSD-3-Clause
#include <string>
#include <utility>
#include <vector>

#include "core/conditions/entity_nodes.hpp"
#include "core/conditions/kinematic_conflicts.hpp"
#include "core/conditions/kinematic_constraints.hpp"
#include "core/conditions/skew_supports.hpp"
#include "core/conditions/stored_values.hpp"
#include "core/definition/condition.hpp"
#include "core/definition/region.hpp"
#include "core/elements/minimum_nodal_mass.hpp"

namespace contactsim {

namespace {

const char* words_of(PrescribedQuantity quantity) {
  static constexpr const char* words[] = {"the prescribed displacement", "the prescribed velocity",
                                          "the prescribed acceleration", "the prescribed rotation",
                                          "the prescribed rotational velocity"};
  return words[static_cast<std::size_t>(quantity)];
}

MotionType motion_type_of(PrescribedQuantity quantity) {
  switch (quantity) {
    case PrescribedQuantity::displacement:
    case PrescribedQuantity::rotation:
      return MotionType::displacement;
    case PrescribedQuantity::velocity:
    case PrescribedQuantity::rotational_velocity:
      return MotionType::velocity;
    case PrescribedQuantity::acceleration:
      break;
  }
  return MotionType::acceleration;
}

bool is_of_rotations(const PrescribedCondition& prescribed) {
  return prescribed.quantity == PrescribedQuantity::rotation ||
         prescribed.quantity == PrescribedQuantity::rotational_velocity;
}

/// What conditions are compiled for.
struct ConstraintTarget {
  bool are_bodies = false;                      ///< rigid bodies in place of nodes
  bool turn = false;                            ///< rotations in place of places
  const Eigen::RowVectorXd* inertia = nullptr;  ///< of the nodes, when these turn
};

/// Compiles conditions, each on its own.
class KinematicConstraintsMaker {
 public:
  KinematicConstraintsMaker(const ConditionScope& scope, const ConstraintTarget& target)
      : scope_(scope), target_(target) {}

  void add(const FixedCondition& fixed);
  void add(const PrescribedCondition& prescribed);
  std::vector<PrescribedMotion> take() { return std::move(motions_); }

 private:
  bool find_names(const EntitySet& set, const DirectionChoice& choice, PrescribedMotion& motion) const;
  bool keep_turning(std::vector<NodeIndex>& nodes) const;
  void sort_out_bodies(PrescribedMotion& motion) const;

  const ConditionScope& scope_;
  ConstraintTarget target_;
  std::vector<PrescribedMotion> motions_;
};

/// Returns whether there is something to drive.
bool KinematicConstraintsMaker::find_names(const EntitySet& set, const DirectionChoice& choice,
                                           PrescribedMotion& motion) const {
  motion.nodes = find_nodes(set, motion.label, scope_);
  sort_out_bodies(motion);
  const auto direction = find_direction(choice, scope_);
  if (direction) motion.direction = *direction;
  if (const auto* axis = std::get_if<Axis>(&motion.direction); axis != nullptr && target_.turn)
    motion.direction = Eigen::Vector3d(axis->direction);
  return direction && !motion.nodes.empty();
}

/// Leaves nodes that are free, or bodies of which all nodes are named.
void KinematicConstraintsMaker::sort_out_bodies(PrescribedMotion& motion) const {
  if (scope_.rigid == nullptr || scope_.rigid->names.empty()) return;
  const RigidNodes& rigid = *scope_.rigid;
  std::vector<std::size_t> counts(rigid.names.size(), 0);
  std::vector<NodeIndex> free, bodies;
  for (const NodeIndex node : motion.nodes) {
    if (rigid.is_free(node))
      free.push_back(node);
    else
      ++counts[*rigid.body_of[node.value]];
  }
  for (std::uint32_t i = 0; i < counts.size(); ++i) {
    if (counts[i] == rigid.counts[i]) bodies.push_back({i});
    if (target_.are_bodies || counts[i] == 0 || counts[i] == rigid.counts[i]) continue;
    scope_.diagnostics.add_warning(
        "condition-rigid", motion.label.location,
        motion.label.what + " leaves out nodes of the rigid body '" + rigid.names[i] + "'",
        "name its block or the body itself to act on all of it");
  }
  motion.nodes = target_.are_bodies ? std::move(bodies) : std::move(free);
  if (target_.are_bodies) motion.bodies = rigid.names;
}

/// Returns whether some are left, or there were none before.
bool KinematicConstraintsMaker::keep_turning(std::vector<NodeIndex>& nodes) const {
  if (target_.inertia == nullptr || nodes.empty()) return true;
  const Eigen::RowVectorXd& inertia = *target_.inertia;
  std::erase_if(nodes, [&](NodeIndex node) {
    return inertia.cols() == 0 || inertia(node.value) <= minimum_nodal_mass;
  });
  return !nodes.empty();
}

void KinematicConstraintsMaker::add(const FixedCondition& fixed) {
  PrescribedMotion motion;
  motion.label = {fixed.is_rotation ? "the fixed rotation" : "the fixed displacement", fixed.name.location};
  motion.times = make_active_times(fixed.periods, scope_.time_stepping_blocks);
  const bool has_nodes = find_names(fixed.set, fixed.direction, motion);
  if (!keep_turning(motion.nodes)) {
    scope_.diagnostics.add_warning("condition-ignored", fixed.name.location,
                                   "the fixed rotation has no effect: none of its nodes has rotations, as "
                                   "those of shells, beams and point inertias do");
    return;
  }
  if (has_nodes) motions_.push_back(std::move(motion));
}

void KinematicConstraintsMaker::add(const PrescribedCondition& prescribed) {
  PrescribedMotion motion;
  motion.label = {words_of(prescribed.quantity), prescribed.name.location};
  motion.type = motion_type_of(prescribed.quantity);
  motion.times = make_active_times(prescribed.periods, scope_.time_stepping_blocks);
  const bool has_nodes = find_names(prescribed.set, prescribed.direction, motion);
  if (!keep_turning(motion.nodes)) {
    return scope_.diagnostics.add_error(
        motion.label.location,
        motion.label.what +
            " cannot act: none of its nodes has rotations, as those of shells, beams and point inertias do",
        "PRESCRIBED DISPLACEMENT or VELOCITY with CYLINDRICAL AXIS turns nodes about an axis");
  }
  if (target_.are_bodies && prescribed.variable.variable && has_nodes) {
    return scope_.diagnostics.add_error(motion.label.location,
                                        motion.label.what + " of a rigid body cannot be read from the mesh",
                                        "give it a FUNCTION");
  }
  const ValueTarget target{prescribed.direction.components, motion.nodes, motion.label};
  const auto values = find_condition_values(prescribed.function, prescribed.variable, target, scope_);
  if (!values || !has_nodes) return;
  if (values->size() == 1) {
    motion.value = values->front();
    motions_.push_back(std::move(motion));
    return;
  }
  std::size_t next = 0;
  for (std::size_t c = 0; c < 3; ++c) {
    if (!prescribed.direction.components[c]) continue;
    PrescribedMotion& part = motions_.emplace_back(motion);
    part.direction = Components{{c == 0, c == 1, c == 2}};
    part.value = (*values)[next++];
  }
}

KinematicConstraints compile(const ConditionScope& scope, const ConstraintTarget& target) {
  KinematicConstraintsMaker maker(scope, target);
  for (const FixedCondition& fixed : scope.region.fixed_conditions) {
    if (fixed.is_rotation == target.turn) maker.add(fixed);
  }
  for (const PrescribedCondition& prescribed : scope.region.prescribed_conditions) {
    if (is_of_rotations(prescribed) == target.turn) maker.add(prescribed);
  }
  std::vector<PrescribedMotion> motions = maker.take();
  const Mesh& mesh = target.are_bodies ? *scope.rigid->references : scope.mesh;
  const auto name_of = [&](NodeIndex node) {
    return target.are_bodies ? "the rigid body '" + scope.rigid->names[node.value] + "'"
                             : "node " + std::to_string(mesh.node_id(node));
  };
  check_conflicts(motions, name_of, scope.diagnostics);
  return KinematicConstraints(mesh, separate_skew_supports(std::move(motions)));
}

/// Conditions on bodies are looked up a second time: what is wrong with them has been said.
KinematicConstraints compile_bodies(const ConditionScope& scope, bool turn) {
  if (scope.rigid == nullptr || scope.rigid->names.empty() || scope.diagnostics.has_errors()) return {};
  Diagnostics quiet;
  const ConditionScope again{scope.definition, scope.region, scope.time_stepping_blocks, scope.mesh, quiet,
                             scope.stored,     scope.rigid};
  KinematicConstraints made = compile(again, {true, turn, nullptr});
  for (const Diagnostic& diagnostic : quiet.all()) {
    if (diagnostic.severity == Severity::error)
      scope.diagnostics.add_error(diagnostic.location, diagnostic.text, diagnostic.hint);
  }
  return made;
}

}  // namespace

KinematicConstraints make_kinematic_constraints(const ConditionScope& scope) { return compile(scope, {}); }

KinematicConstraints make_rotation_constraints(const ConditionScope& scope,
                                               const Eigen::RowVectorXd& inertia) {
  return compile(scope, {false, true, &inertia});
}

KinematicConstraints make_body_constraints(const ConditionScope& scope) {
  return compile_bodies(scope, false);
}

KinematicConstraints make_body_rotation_constraints(const ConditionScope& scope) {
  return compile_bodies(scope, true);
}

}  // namespace contactsim
