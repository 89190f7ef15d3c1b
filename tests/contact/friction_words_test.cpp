// SPDX-License-Identifier: BSD-3-Clause
#include "contact/friction_words.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

SurfacePair pair_with(const FrictionLaw& law, int line) {
  static const auto deck = std::make_shared<SourceFile>(SourceFile{"c.i", ""});
  SurfacePair pair;
  pair.law = law;
  pair.location = {deck, line, 1, nullptr};
  return pair;
}

}  // namespace

TEST_CASE("laws are described in words", "[contact][friction]") {
  CHECK(describe_law(Frictionless{}) == "frictionless");
  CHECK(describe_law(ConstantFriction{0.3}) == "friction 0.3");
  CHECK(describe_law(Tied{}) == "tied");
  CHECK(describe_law(Glued{}) == "glued");
  CHECK(describe_law(SurfaceWeld{}) == "surface weld");
  SurfaceWeld area_weld;
  area_weld.is_per_area = true;
  CHECK(describe_law(area_weld) == "area weld");
  CHECK(describe_law(CohesiveZone{}) == "cohesive zone");
}

TEST_CASE("a run takes four laws and refuses the others once per interaction", "[contact][friction]") {
  Diagnostics fine, wrong;
  refuse_laws(std::vector<SurfacePair>{pair_with(Frictionless{}, 1), pair_with(ConstantFriction{0.1}, 2),
                                       pair_with(Tied{}, 3), pair_with(Glued{}, 4)},
              std::vector<ContactSurface>(2), fine);
  CHECK(fine.empty());
  refuse_laws(std::vector<SurfacePair>{pair_with(Adhesion{}, 3), pair_with(Adhesion{}, 3),
                                       pair_with(HybridFriction{}, 9)},
              std::vector<ContactSurface>(2), wrong);
  CHECK(messages(wrong) ==
        "c.i:3:1: error: the friction model 'adhesion' is not supported in a run yet; frictionless, constant "
        "friction, tied and glued are\n"
        "c.i:9:1: error: the friction model 'hybrid' is not supported in a run yet; frictionless, constant "
        "friction, tied and glued are\n");
}

TEST_CASE("nothing is tied or glued to a plane", "[contact][friction]") {
  std::vector<ContactSurface> surfaces(1);
  surfaces[0].name = "floor";
  surfaces[0].analytic_planes = {0};
  Diagnostics fine, wrong;
  refuse_laws(std::vector<SurfacePair>{pair_with(ConstantFriction{0.1}, 2)}, surfaces, fine);
  CHECK(fine.empty());
  refuse_laws(std::vector<SurfacePair>{pair_with(Tied{}, 3), pair_with(Glued{}, 4)}, surfaces, wrong);
  CHECK(messages(wrong) ==
        "c.i:3:1: error: 'floor' and 'floor' cannot be tied: one is an analytic plane; planes only push\n"
        "c.i:4:1: error: 'floor' and 'floor' cannot be glued: one is an analytic plane; planes only push\n");
}
