// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "core/elements/line/line_batches.hpp"

namespace contactsim {

namespace {

/// Sets what a force along springs or dampers gives besides work; the stress is that of their cross-section.
void pull(const ModelBlock& block, std::size_t batch, const LineGeometry& end, const Lanes& force,
          std::span<Lanes> state, LineStep& step) {
  const Lanes& area = block.section[batch];
  state[0] = force / area;
  step.pull = scaled(end.axis, force);
  step.volume = area * end.length;
  step.stable_step = block.discrete.stable_step[batch];
}

/// Two nodes that a force of their distance pulls together.
struct Spring {
  static constexpr std::size_t n_own = 0;
  static constexpr bool has_rotations = false;

  static Lanes force(const DiscreteParts& parts, std::size_t batch, const Lanes& length) {
    const Lanes& rest = parts.length[batch];
    if (!parts.force_of_strain) return parts.stiffness[batch] * (length - rest);
    Lanes force = length / rest - 1.0;
    for (Eigen::Index lane = 0; lane < n_lanes; ++lane)
      force(lane) = parts.force_of_strain->evaluate(force(lane));
    return force;
  }

  /// As LineStep.
  static void advance(const ModelBlock& block, std::size_t batch, const LineMotion& motion,
                      std::span<Lanes> state, LineStep& step) {
    const LineGeometry start(motion.x, motion.v, motion.dt), end(motion.x);
    const Lanes before = force(block.discrete, batch, start.length);
    const Lanes after = force(block.discrete, batch, end.length);
    step.stress_work = 0.5 * (before + after) * (end.length - start.length);
    pull(block, batch, end, after, state, step);
  }
};

/// Two nodes whose distance changes against a resistance.
struct Damper {
  static constexpr std::size_t n_own = 0;
  static constexpr bool has_rotations = false;

  /// As LineStep.
  static void advance(const ModelBlock& block, std::size_t batch, const LineMotion& motion,
                      std::span<Lanes> state, LineStep& step) {
    const LineGeometry middle(motion.x, motion.v, 0.5 * motion.dt), end(motion.x);
    const Lanes rate = dot(motion.velocity_difference(), middle.axis);
    const Lanes force = block.discrete.stiffness[batch] * rate;
    step.stress_work = motion.dt * force * rate;
    pull(block, batch, end, force, state, step);
  }
};

template <class Line>
constexpr ElementFormulation discrete_line(Shape shape, std::string_view formulation, StepRule rule) {
  ElementFormulation element = line_element<Line>(shape, formulation);
  element.step_rule = rule;
  return element;
}

}  // namespace

const ElementFormulation bar2_spring = discrete_line<Spring>(Shape::bar2, "spring", StepRule::stiffness);
const ElementFormulation beam2_spring = discrete_line<Spring>(Shape::beam2, "spring", StepRule::stiffness);
const ElementFormulation bar2_damper = discrete_line<Damper>(Shape::bar2, "damper", StepRule::damping);
const ElementFormulation beam2_damper = discrete_line<Damper>(Shape::beam2, "damper", StepRule::damping);

}  // namespace contactsim
