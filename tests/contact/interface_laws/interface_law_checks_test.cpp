// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/interface_law_checks.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

SurfacePair pair_with(const FrictionLaw& law, int line) {
  static const auto deck = std::make_shared<SourceFile>(SourceFile{"c.i", ""});
  SurfacePair pair;
  pair.law = share_law(law);
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

TEST_CASE("nothing is held to a plane", "[contact][friction]") {
  std::vector<ContactSurface> surfaces(1);
  surfaces[0].name = "floor";
  surfaces[0].analytic_planes = {0};
  const auto refused = [&](const FrictionLaw& law) {
    Diagnostics found;
    refuse_laws(std::vector<SurfacePair>{pair_with(law, 3)}, surfaces, {}, found);
    return messages(found);
  };
  CHECK(refused(ConstantFriction{0.1}).empty());
  CHECK(refused(PressureVelocityFriction{}).empty());
  const std::string cannot = "c.i:3:1: error: 'floor' and 'floor' cannot be ",
                    why = ": one is an analytic plane; nothing is held to planes\n";
  CHECK(refused(Tied{}) == cannot + "tied" + why);
  CHECK(refused(Glued{}) == cannot + "glued" + why);
  CHECK(refused(SurfaceWeld{}) == cannot + "surface weld" + why);
  HybridFriction hybrid;
  hybrid.initially_far = DeckName{"tied", {}};
  CHECK(refused(hybrid) == cannot + "hybrid" + why);
}
