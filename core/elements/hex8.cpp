// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/hex8.hpp"

#include <cmath>

#include "core/elements/rotation.hpp"

namespace contactsim {

namespace {

/// Patterns have this length, eight nodes of plus or minus one.
const double pattern_length = std::sqrt(8.0);

using PatternVectors = std::array<std::array<Lanes, 4>, 3>;

PatternVectors pattern_sums(const HexVectors& values) {
  return {hourglass_sums(values[0]), hourglass_sums(values[1]), hourglass_sums(values[2])};
}

/// Coordinates at the middle of the step.
HexVectors middle_of(const HexMotion& motion) {
  HexVectors x;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t node = 0; node < 8; ++node)
      x[i][node] = motion.x[i][node] - 0.5 * motion.dt * motion.v[i][node];
  }
  return x;
}

/// The hexahedra at the middle of a step.
struct MiddleOfStep {
  HexVectors x, gradient;
  Lanes volume, gradient_norm;    ///< gradient_norm: B:B [length^4]
  Lanes greatest_eigenvalue;      ///< bound for that of B B^T [length^4]
  TensorLanes velocity_gradient;  ///< [1/time]

  explicit MiddleOfStep(const HexMotion& motion)
      : x(middle_of(motion)), gradient(volume_gradient(x)), volume(hex_volume(x, gradient)) {
    const Lanes per_volume = 1.0 / volume;
    velocity_gradient = outer_sum(motion.v, gradient);
    for (auto& row : velocity_gradient) {
      for (Lanes& component : row) component *= per_volume;
    }
    bound_eigenvalue();
  }

  /// The largest eigenvalue of a symmetric 3 x 3 tensor lies at most sqrt(2/3) times the deviator's norm
  /// above the mean.
  void bound_eigenvalue() {
    const auto dot = [&](std::size_t i, std::size_t j) -> Lanes {
      Lanes sum = gradient[i][0] * gradient[j][0];
      for (std::size_t node = 1; node < 8; ++node) sum += gradient[i][node] * gradient[j][node];
      return sum;
    };
    const SymmetricLanes product{{dot(0, 0), dot(1, 1), dot(2, 2), dot(0, 1), dot(1, 2), dot(2, 0)}};
    gradient_norm = trace(product);
    const SymmetricLanes spread = deviator(product);
    greatest_eigenvalue = gradient_norm / 3.0 + (2.0 / 3.0 * contract(spread, spread)).sqrt();
  }
};

/// Rates of the hourglass modes: what is left of the velocities without their linear part
/// [component][pattern].
PatternVectors hourglass_rates(const HexMotion& motion, const MiddleOfStep& middle) {
  const PatternVectors x = pattern_sums(middle.x);
  PatternVectors rates = pattern_sums(motion.v);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto& row = middle.velocity_gradient[i];
    for (std::size_t k = 0; k < 4; ++k) {
      rates[i][k] = (rates[i][k] - row[0] * x[0][k] - row[1] * x[1][k] - row[2] * x[2][k]) / pattern_length;
    }
  }
  return rates;
}

/// Forces of a stress (with the hourglass forces' share of it taken off) and of the hourglass forces.
void set_forces(const SymmetricLanes& stress, const PatternVectors& hourglass, const HexVectors& x,
                HexStep& step) {
  const HexVectors gradient = volume_gradient(x);
  step.volume = hex_volume(x, gradient);
  const PatternVectors sums = pattern_sums(x);
  constexpr std::size_t index[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  const Lanes scale = 1.0 / (pattern_length * step.volume);
  for (std::size_t i = 0; i < 3; ++i) {
    std::array<Lanes, 3> row;
    for (std::size_t j = 0; j < 3; ++j) {
      Lanes share = hourglass[i][0] * sums[j][0];
      for (std::size_t k = 1; k < 4; ++k) share += hourglass[i][k] * sums[j][k];
      row[j] = stress[index[i][j]] - scale * share;
    }
    for (std::size_t node = 0; node < 8; ++node) {
      step.force[i][node] =
          row[0] * gradient[0][node] + row[1] * gradient[1][node] + row[2] * gradient[2][node];
    }
    std::array<Lanes, 4> amounts;
    for (std::size_t k = 0; k < 4; ++k) amounts[k] = hourglass[i][k] / pattern_length;
    add_hourglass(amounts, step.force[i]);
  }
}

/// The tensors of a law's state, which turn with the material.
template <class Law>
void turn_state(const TensorLanes& rotation, std::array<Lanes, Law::n_state>& state) {
  for (std::size_t first = 0; first < 6 * Law::n_tensors; first += 6) {
    SymmetricLanes tensor;
    for (std::size_t i = 0; i < 6; ++i) tensor[i] = state[first + i];
    tensor = turned(tensor, rotation);
    for (std::size_t i = 0; i < 6; ++i) state[first + i] = tensor[i];
  }
}

TensorLanes scaled(TensorLanes tensor, double factor) {
  for (auto& row : tensor) {
    for (Lanes& component : row) component *= factor;
  }
  return tensor;
}

/// How stiff the hexahedra are at the middle of the step.
struct Stiffness {
  Lanes hourglass;   ///< of the generalised hourglass forces [force/length]
  Lanes frequency;   ///< bound for the highest [1/time]
  Lanes wave_speed;  ///< of pressure [length/time]

  Stiffness(const ElasticModuli& moduli, const HexParameters& parameters, const HexMotion& motion,
            const MiddleOfStep& middle) {
    const double patterns = parameters.hourglass_stiffness * moduli.shear;
    hourglass = patterns * middle.gradient_norm / middle.volume;
    const Lanes sum =
        (moduli.lambda() + patterns) * middle.gradient_norm + 2.0 * moduli.shear * middle.greatest_eigenvalue;
    frequency = (8.0 * sum / (motion.mass * middle.volume)).sqrt();
    wave_speed = (moduli.p_wave() * middle.volume / motion.mass).sqrt();
  }
};

/// Bulk viscosity: linear in the dilatation rate, and quadratic while the elements close. Its length is that
/// which a wave crosses in the stable step. Source: Abaqus Theory Guide, explicit dynamic analysis.
///   dilatation  rate of volume change [1/time]
Lanes viscous_stress(const Stiffness& stiffness, const HexParameters& parameters, const HexMotion& motion,
                     const MiddleOfStep& middle, const Lanes& dilatation, HexStep& step) {
  const double linear = parameters.linear_bulk_viscosity;
  const double quadratic = parameters.quadratic_bulk_viscosity * parameters.quadratic_bulk_viscosity;
  const Lanes undamped = 2.0 / stiffness.frequency;
  const Lanes closing = dilatation.min(0.0);
  const Lanes damping = linear - quadratic * undamped * closing;
  step.stable_step = undamped * ((1.0 + damping * damping).sqrt() - damping);
  const Lanes length = undamped * stiffness.wave_speed;
  const Lanes stress = motion.mass / middle.volume * length *
                       (linear * stiffness.wave_speed * dilatation - quadratic * length * closing * closing);
  step.viscous_work = stress * dilatation * middle.volume * motion.dt;
  return stress;
}

/// Brings the elastic hourglass forces to the end of the step; returns them with the viscous ones.
PatternVectors update_hourglass(const Stiffness& stiffness, const HexParameters& parameters,
                                const HexMotion& motion, const MiddleOfStep& middle, PatternVectors& elastic,
                                HexStep& step) {
  PatternVectors forces = hourglass_rates(motion, middle);
  const Lanes viscosity = parameters.hourglass_viscosity * (motion.mass * stiffness.hourglass).sqrt();
  step.hourglass_work.setZero();
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      const Lanes rate = forces[i][k], growth = motion.dt * stiffness.hourglass * rate;
      elastic[i][k] += growth;
      step.hourglass_work += motion.dt * rate * (elastic[i][k] - 0.5 * growth + viscosity * rate);
      forces[i][k] = elastic[i][k] + viscosity * rate;
    }
  }
  return forces;
}

}  // namespace

template <class Law>
HexStep advance_hex8(const Law& law, const HexParameters& parameters, const HexMotion& motion,
                     HexState<Law>& state) {
  HexStep step;
  const MiddleOfStep middle(motion);
  const StepMotion split = split_motion(scaled(middle.velocity_gradient, motion.dt));
  state.stress = turned(state.stress, split.rotation);
  turn_state<Law>(split.rotation, state.material);
  law.update(split.strain, motion.dt, state.stress, state.material);

  const Stiffness stiffness(law.moduli, parameters, motion, middle);
  SymmetricLanes stress = state.stress;
  const Lanes viscous =
      viscous_stress(stiffness, parameters, motion, middle, trace(split.strain) / motion.dt, step);
  for (std::size_t i = 0; i < 3; ++i) stress[i] += viscous;
  turn(split.rotation, state.hourglass);
  const PatternVectors hourglass =
      update_hourglass(stiffness, parameters, motion, middle, state.hourglass, step);
  set_forces(stress, hourglass, motion.x, step);
  return step;
}

template HexStep advance_hex8(const ElasticLaw&, const HexParameters&, const HexMotion&,
                              HexState<ElasticLaw>&);
template HexStep advance_hex8(const PlasticLaw<LinearHardening>&, const HexParameters&, const HexMotion&,
                              HexState<PlasticLaw<LinearHardening>>&);
template HexStep advance_hex8(const PlasticLaw<PowerHardening>&, const HexParameters&, const HexMotion&,
                              HexState<PlasticLaw<PowerHardening>>&);
template HexStep advance_hex8(const PlasticLaw<JohnsonCookHardening>&, const HexParameters&, const HexMotion&,
                              HexState<PlasticLaw<JohnsonCookHardening>>&);

}  // namespace contactsim
