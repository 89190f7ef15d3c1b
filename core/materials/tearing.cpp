// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/tearing.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace contactsim {

namespace {

/// How much faster the tearing parameter grows than the plastic strain. The largest principal stress is
/// y / 3 times the von Mises stress above the mean, y = 2 cos(acos(c) / 3), c = 27/2 det(deviator) over the
/// cube of the von Mises stress.
Lanes tearing_rate(const SymmetricLanes& stress) {
  const SymmetricLanes s = deviator(stress);
  const Lanes von_mises = (1.5 * contract(s, s)).sqrt();
  const Lanes determinant = s[0] * (s[1] * s[2] - s[4] * s[4]) - s[3] * (s[3] * s[2] - s[4] * s[5]) +
                            s[5] * (s[3] * s[4] - s[1] * s[5]);
  // Round-off may take it beyond what a cosine can be.
  const Lanes c = (13.5 * determinant / (von_mises * von_mises * von_mises)).max(-1.0).min(1.0);
  const Lanes y = 2.0 * (c.acos() / 3.0).cos();
  const Lanes rate = (2.0 / 3.0 * (1.0 + trace(stress) / (von_mises * y))).max(0.0);
  const Lanes square = rate * rate;
  // Only a moving yield surface lets material flow without a deviator, which has no largest direction.
  return (von_mises > 0.0).select(square * square, 0.0);
}

/// Gives a lane its crack, across the largest principal stress.
void start_crack(const SymmetricLanes& stress, Eigen::Index lane, std::span<Lanes> crack) {
  Eigen::Matrix3d tensor;
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = 0; j < 3; ++j) tensor(i, j) = stress[symmetric_place[i][j]](lane);
  }
  const Eigen::Vector3d normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(tensor).eigenvectors().col(2);
  for (Eigen::Index i = 0; i < 3; ++i) {
    for (Eigen::Index j = i; j < 3; ++j) crack[symmetric_place[i][j]](lane) = normal(i) * normal(j);
  }
}

/// A step of the law about that of the plastic law, which sees the stress of what is whole.
class TearingStep {
 public:
  TearingStep(const TearingLaw& law, std::span<Lanes> state)
      : law_(law), state_(state), crack_(state.subspan(6, 6)), is_torn_((damage() > 0.0).any()) {
    std::copy_n(state.begin(), 6, plastic_.begin());
    plastic_[6] = state[12];
  }

  /// What the plastic law has of the state.
  std::span<Lanes> plastic() { return plastic_; }

  /// n n^T of the crack's normal n, zero while there is none.
  ///   place  among xx, yy, zz, xy, yz, zx
  const Lanes& crack(std::size_t place) const { return crack_[place]; }

  void make_whole(std::span<Lanes> stress) const {
    if (!is_torn_) return;
    const Lanes left = 1.0 - damage();
    for (Lanes& component : stress) component = (left > 0.0).select(component / left, 0.0);
  }

  /// Opens the crack and takes from the stress what is lost. Failure begins at the end of a step.
  ///   opening  strain across the crack in the step [1]
  ///   places   of the components of the stress among xx, yy, zz, xy, yz, zx
  void finish(const Lanes& opening, std::span<const std::size_t> places, std::span<Lanes> stress) {
    const Lanes growth = plastic_[6] - state_[12];
    std::copy_n(plastic_.begin(), 6, state_.begin());
    state_[12] = plastic_[6];
    state_[14] += opening;
    state_[15] = damage().max((state_[14] / law_.critical_opening).min(1.0));
    if ((growth > 0.0).any()) {
      SymmetricLanes whole = SymmetricLanes::zero();
      for (std::size_t i = 0; i < places.size(); ++i) whole[places[i]] = stress[i];
      tear(growth, whole);
    }
    if (!is_torn_ && (damage() == 0.0).all()) return;
    for (Lanes& component : stress) component *= 1.0 - damage();
  }

 private:
  Lanes& damage() const { return state_[15]; }

  void tear(const Lanes& growth, const SymmetricLanes& stress) {
    Lanes& tearing = state_[13];
    tearing += (growth > 0.0).select(growth * tearing_rate(stress), 0.0);
    const LaneMask is_whole = crack_[0] + crack_[1] + crack_[2] == 0.0;
    const LaneMask cracks = is_whole && growth > 0.0 && tearing >= law_.critical_tearing;
    if (!cracks.any()) return;
    for (Eigen::Index lane = 0; lane < n_lanes; ++lane) {
      if (cracks(lane)) start_crack(stress, lane, crack_);
    }
  }

  const TearingLaw& law_;
  std::span<Lanes> state_, crack_;
  bool is_torn_;
  std::array<Lanes, 7> plastic_;
};

constexpr std::array<std::size_t, 6> solid_places{0, 1, 2, 3, 4, 5};

/// Takes a point through a step.
///   strain   its shear as angles [1]
///   places   of the components among xx, yy, zz, xy, yz, zx
///   advance  the plastic law, on the stress of what is whole; called with its state
template <std::size_t n, class Advance>
void step_torn(TearingStep tearing, const std::array<Lanes, n>& strain,
               const std::array<std::size_t, n>& places, std::span<Lanes> stress, const Advance& advance) {
  Lanes opening = Lanes::Zero();
  for (std::size_t i = 0; i < n; ++i) opening += tearing.crack(places[i]) * strain[i];
  tearing.make_whole(stress);
  advance(tearing.plastic());
  tearing.finish(opening, places, stress);
}

}  // namespace

LaneModuli TearingLaw::update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const {
  std::array<Lanes, 6> strain = step.strain.components;
  for (std::size_t i = 3; i < 6; ++i) strain[i] *= 2.0;
  LaneModuli moduli_now;
  step_torn({*this, state}, strain, solid_places, stress.components,
            [&](std::span<Lanes> plastic) { moduli_now = PlasticLaw::update(step, stress, plastic); });
  return moduli_now;
}

void TearingLaw::update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const {
  step_torn({*this, state}, step.strain, plane_places, stress,
            [&](std::span<Lanes> plastic) { PlasticLaw::update_plane(step, stress, plastic); });
}

void TearingLaw::update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const {
  step_torn({*this, state}, step.strain, fibre_places, stress,
            [&](std::span<Lanes> plastic) { PlasticLaw::update_fibre(step, stress, plastic); });
}

MaterialRow tearing_material() {
  return {{"ml_ep_fail"},
          "The same as multilinear_ep, torn apart by plastic strain under tension",
          joined({{yield_stress()},
                  multilinear_parameters(),
                  {parameter::positive("critical tearing parameter",
                                       "Tearing parameter at which a crack begins to open [1]")
                       .required(),
                   parameter::positive("critical crack opening strain",
                                       "Strain across the crack at which nothing is carried [1]")
                       .required()}}),
          {&law_kind<TearingLaw>},
          [](const MaterialInput& input) -> std::optional<MaterialLaw> {
            auto plastic = make_multilinear_law(input);
            if (!plastic) return std::nullopt;
            return TearingLaw{std::move(*plastic), input.values.real("critical tearing parameter"),
                              input.values.real("critical crack opening strain")};
          }};
}

}  // namespace contactsim
