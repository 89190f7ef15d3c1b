// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/law_kind.hpp"

#include <array>
#include <string_view>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A law that has only what all must have: a stress along x that grows by its factor a step.
struct PlainLaw {
  ElasticModuli moduli;
  double factor = 1.0;
  static constexpr std::size_t n_tensors = 0, n_state = 1;
  static constexpr std::array<StateVariable, 1> variables{StateVariable{"steps", 0, 1, "number of steps"}};

  void start(std::span<Lanes> state) const { state[0].setConstant(5.0); }
  LaneModuli update(const StrainStep&, SymmetricLanes& stress, std::span<Lanes> state) const {
    stress[0] += factor;
    state[0] += 1.0;
    return {Lanes::Constant(3.0), Lanes::Constant(2.0)};
  }
};

/// A law that has all that laws may have.
struct FullLaw : PlainLaw {
  static constexpr std::size_t n_vectors = 2;
  static constexpr std::string_view failure = "steps";
  static constexpr bool adds_stress = true;

  void update_plane(const PlaneStep&, PlaneLanes& stress, std::span<Lanes>) const { stress[1] += factor; }
  void update_fibre(const FibreStep&, FibreLanes& stress, std::span<Lanes>) const { stress[2] += factor; }
  Lanes plane_thinning(std::span<const Lanes> state) const { return 1.0 * state[0]; }
  Lanes plane_stiffening(std::span<const Lanes> state) const { return 2.0 * state[0]; }
  Lanes fibre_thinning(std::span<const Lanes> state) const { return 3.0 * state[0]; }
  Lanes fibre_stiffening(std::span<const Lanes> state) const { return 4.0 * state[0]; }
};

}  // namespace

TEST_CASE("a law's kind calls the law that it is given", "[core][law_kind]") {
  constexpr LawKind kind = LawKind::of<PlainLaw>();
  CHECK(kind.n_state == 1);
  CHECK(kind.n_tensors == 0);
  REQUIRE(kind.variables.size() == 1);
  CHECK(kind.variables[0].name == "steps");
  for (const double factor : {1.0, 7.0}) {
    const PlainLaw law{{}, factor};
    std::array<Lanes, 1> state;
    kind.start(&law, state);
    CHECK((state[0] == 5.0).all());
    SymmetricLanes stress = SymmetricLanes::zero();
    const LaneModuli moduli = kind.update(&law, {}, stress, state);
    CHECK((stress[0] == factor).all());
    CHECK((state[0] == 6.0).all());
    CHECK((moduli.bulk == 3.0).all());
    CHECK((moduli.shear == 2.0).all());
  }
}

TEST_CASE("a law's kind lacks what the law lacks", "[core][law_kind]") {
  const LawKind& kind = law_kind<PlainLaw>;
  CHECK(kind.n_vectors == 0);
  CHECK(kind.failure.empty());
  CHECK_FALSE(kind.adds_stress);
  CHECK(kind.update_plane == nullptr);
  CHECK(kind.update_fibre == nullptr);
  CHECK(kind.plane_thinning == nullptr);
  CHECK(kind.plane_stiffening == nullptr);
  CHECK(kind.fibre_thinning == nullptr);
  CHECK(kind.fibre_stiffening == nullptr);
}

TEST_CASE("a law's kind has what the law may have, each in its place", "[core][law_kind]") {
  const LawKind& kind = law_kind<FullLaw>;
  CHECK(kind.n_vectors == 2);
  CHECK(kind.failure == "steps");
  CHECK(kind.adds_stress);
  const FullLaw law{{{}, 6.0}};
  std::array<Lanes, 1> state{Lanes::Constant(10.0)};
  PlaneLanes plane;
  for (Lanes& component : plane) component.setZero();
  kind.update_plane(&law, {}, plane, state);
  CHECK((plane[1] == 6.0).all());
  FibreLanes fibre;
  for (Lanes& component : fibre) component.setZero();
  kind.update_fibre(&law, {}, fibre, state);
  CHECK((fibre[2] == 6.0).all());
  CHECK((kind.plane_thinning(&law, state) == 10.0).all());
  CHECK((kind.plane_stiffening(&law, state) == 20.0).all());
  CHECK((kind.fibre_thinning(&law, state) == 30.0).all());
  CHECK((kind.fibre_stiffening(&law, state) == 40.0).all());
}
