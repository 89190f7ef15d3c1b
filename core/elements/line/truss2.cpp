// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/elements.hpp"
#include "core/elements/line/fibre_point.hpp"
#include "core/elements/line/line_batches.hpp"

namespace contactsim {

namespace {

/// Straight bars of two nodes that have nothing but an axial stress. The cross-section does not change. A
/// preload comes as a strain that the nodes do not see.
struct Truss {
  static constexpr std::size_t n_own = 0;
  static constexpr bool has_rotations = false;

  /// As LineStep; the middle of a step makes a turn of any size free of strain.
  static void advance(const ModelBlock& block, std::size_t batch, const LineMotion& motion,
                      std::span<Lanes> state, LineStep& step) {
    const LineGeometry middle(motion.x, motion.v, 0.5 * motion.dt), end(motion.x);
    FibreStep strain{{}, motion.dt};
    for (Lanes& component : strain.strain) component.setZero();
    strain.strain[0] = motion.dt * dot(motion.velocity_difference(), middle.axis) / middle.length;
    const Lanes stretched = strain.strain[0], &area = block.section[batch];
    const MaterialLaw& law = block.properties.law;
    const double youngs = law.moduli().youngs();
    const Preload& preload = block.preload;
    const double growth = preload.share(motion.time) - preload.share(motion.time - motion.dt);
    strain.strain[0] += preload.load * growth / (youngs * area);
    Lanes stiffening = Lanes::Ones();
    const FibreLanes before = fibre_stress(law, state);
    const FibreLanes after = update_fibre(law, strain, state, stiffening);
    step.stress_work = 0.5 * (before[0] + after[0]) * stretched * area * middle.length;
    const Lanes stiffness = youngs * area * stiffening;
    step.stable_step = (motion.mass * middle.length / stiffness).sqrt();
    step.volume = area * end.length;
    step.pull = scaled(end.axis, area * after[0]);
  }
};

}  // namespace

const ElementFormulation bar2_truss = line_element<Truss>(Shape::bar2, "truss");
const ElementFormulation beam2_truss = line_element<Truss>(Shape::beam2, "truss");

}  // namespace contactsim
