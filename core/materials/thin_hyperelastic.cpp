// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/thin_hyperelastic.hpp"

#include <limits>

namespace contactsim::hyperelastic {

namespace {

/// The stress across at a stretch, and its slope over that.
struct Across {
  Lanes stress, slope;
};

/// Where a stress that grows with r > 0 from minus to plus infinity vanishes. Newton's steps from r = 1, the
/// stretch of the step before; those that leave the bracket are replaced by halving it.
template <class Stress>
Lanes find_root(const Stress& stress) {
  constexpr double round_off = 16.0 * std::numeric_limits<double>::epsilon();
  constexpr int max_iterations = 60;
  Lanes low = Lanes::Zero(), high = Lanes::Constant(std::numeric_limits<double>::infinity());
  Lanes r = Lanes::Ones();
  for (int i = 0; i < max_iterations; ++i) {
    const Across at = stress(r);
    low = (at.stress < 0.0).select(r, low);
    high = (at.stress < 0.0).select(high, r);
    const Lanes newton = r - at.stress / at.slope;
    const LaneMask is_done = at.stress == 0.0 || (newton - r).abs() <= round_off * r;
    const LaneMask is_inside = newton > low && newton < high;
    r = (is_inside || is_done).select(newton, 0.5 * (low + high.min(3.0 * r)));
    if (is_done.all()) break;
  }
  return r;
}

SymmetricLanes tensor_of(std::span<const Lanes> state) {
  return {{state[0], state[1], state[2], state[3], state[4], state[5]}};
}

/// tau_zz at a stretch t across the tensor b, r = t^(2/3).
struct AcrossPlane {
  Lanes shear, first, second;      ///< of the first term of the energy
  Lanes other, coupled, in_plane;  ///< of the second
  Lanes pressure, squared_volume;

  AcrossPlane(const MooneyRivlinLaw& law, const SymmetricLanes& b) {
    squared_volume = determinant(b);
    const Lanes scale = (-1.0 / 3.0 * squared_volume.log()).exp();
    shear = 2.0 / 3.0 * law.c10() * scale;
    other = 2.0 / 3.0 * law.c01 * scale * scale;
    first = 2.0 * b[2];
    second = b[0] + b[1];
    coupled = b[2] * second - b[4] * b[4] - b[5] * b[5];
    in_plane = 2.0 * (b[0] * b[1] - b[3] * b[3]);
    pressure.setConstant(0.5 * law.moduli.bulk);
  }

  Across operator()(const Lanes& r) const {
    const Lanes per_r = 1.0 / r, per_square = per_r * per_r, square = r * r;
    return {shear * (first * square - second * per_r) + other * (coupled * r - in_plane * per_square) +
                pressure * (squared_volume * square * r - 1.0),
            shear * (2.0 * first * r + second * per_square) +
                other * (coupled + 2.0 * in_plane * per_square * per_r) +
                3.0 * pressure * squared_volume * square};
  }
};

/// tau_yy = tau_zz at a stretch t along both, r = t^(2/3).
struct AcrossFibre {
  Lanes shear, along, across, squared_volume;
  double pressure;

  AcrossFibre(const NeoHookeanLaw& law, const SymmetricLanes& b)
      : along(b[0]), across(b[1]), squared_volume(determinant(b)), pressure(0.5 * law.moduli.bulk) {
    shear = law.moduli.shear / 3.0 * (-1.0 / 3.0 * squared_volume.log()).exp();
  }

  Across operator()(const Lanes& r) const {
    const Lanes per_r = 1.0 / r, per_square = per_r * per_r, cube = r * r * r;
    return {
        shear * (across * r - along * per_square) + pressure * (squared_volume * cube * cube - 1.0),
        shear * (across + 2.0 * along * per_square * per_r) + 6.0 * pressure * squared_volume * cube * r * r};
  }
};

/// Of the shear across, which turns what it shears: L : L is twice D : D.
Lanes shear_ratio(const Response& now, const ElasticModuli& moduli) {
  return (2.0 * now.bounds.shear - now.mean) / moduli.shear;
}

}  // namespace

void update_plane(const MooneyRivlinLaw& law, const PlaneStep& step, PlaneLanes& stress,
                  std::span<Lanes> state) {
  const auto& [xx, yy, xy, yz, zx] = step.strain;
  const Lanes zero = Lanes::Zero(), half = 0.5 * xy;
  const TensorLanes gradient{{{xx, half, zx}, {half, yy, yz}, {zero, zero, zero}}};
  SymmetricLanes b = transformed(tensor_of(state), deformation_of(gradient));
  const Lanes root = find_root(AcrossPlane(law, b)), stretch = root * root.sqrt();
  b[2] *= stretch * stretch;
  b[4] *= stretch;
  b[5] *= stretch;
  for (std::size_t i = 0; i < 6; ++i) state[i] = b[i];
  const Response response = law.at(b);
  for (std::size_t i = 0; i < 5; ++i) stress[i] = response.stress[plane_places[i]];
}

Lanes plane_stiffening(const MooneyRivlinLaw& law, std::span<const Lanes> state) {
  const Response now = law.at(tensor_of(state));
  const Lanes lambda = now.bounds.lambda(), &shear = now.bounds.shear;
  const Lanes across = 2.0 * shear * lambda / (lambda + 2.0 * shear);
  const PlaneModuli at_rest(law.moduli);
  const Lanes direct = (across + shear) / (std::max(at_rest.across, 0.0) + at_rest.shear);
  return law.plane_thinning(state) * direct.max(shear_ratio(now, law.moduli));
}

void update_fibre(const NeoHookeanLaw& law, const FibreStep& step, FibreLanes& stress,
                  std::span<Lanes> state) {
  const auto& [xx, xy, zx] = step.strain;
  const Lanes zero = Lanes::Zero();
  const TensorLanes gradient{{{xx, xy, zx}, {zero, zero, zero}, {zero, zero, zero}}};
  SymmetricLanes b = transformed(tensor_of(state), deformation_of(gradient));
  const Lanes root = find_root(AcrossFibre(law, b)), stretch = root * root.sqrt();
  for (const std::size_t i : {1U, 2U}) b[i] *= stretch * stretch;
  for (const std::size_t i : {3U, 5U}) b[i] *= stretch;
  for (std::size_t i = 0; i < 6; ++i) state[i] = b[i];
  const Response response = MooneyRivlinLaw{law.moduli}.at(b);
  for (std::size_t i = 0; i < 3; ++i) stress[i] = response.stress[fibre_places[i]];
}

Lanes fibre_stiffening(const NeoHookeanLaw& law, std::span<const Lanes> state) {
  const Response now = MooneyRivlinLaw{law.moduli}.at(tensor_of(state));
  const LaneModuli& bounds = now.bounds;
  const Lanes youngs = 9.0 * bounds.bulk * bounds.shear / (3.0 * bounds.bulk + bounds.shear);
  return law.fibre_thinning(state) * (youngs / law.moduli.youngs()).max(shear_ratio(now, law.moduli));
}

}  // namespace contactsim::hyperelastic
