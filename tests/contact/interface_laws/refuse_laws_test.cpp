// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/refuse_laws.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/friction_law.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

SurfacePair pair_with(const FrictionLaw& law, int line) {
  static const auto deck = std::make_shared<SourceFile>(SourceFile{"c.i", ""});
  SurfacePair pair;
  pair.law = share(law);
  pair.location = {deck, line, 1, nullptr};
  return pair;
}

}  // namespace

TEST_CASE("nothing is held to a plane", "[contact][friction]") {
  SurfaceList surfaces(1);
  surfaces[{0}].name = "floor";
  surfaces[{0}].analytic_planes = {0};
  const auto refused = [&](const FrictionLaw& law) {
    Diagnostics found;
    refuse_laws(SurfacePairs{pair_with(law, 3)}, surfaces, {}, found);
    return messages(found);
  };
  CHECK(refused(coulomb(0.1)).empty());
  CHECK(refused(friction_law("pv dependent", {{"reference pressure", 1.0}})).empty());
  const std::string cannot = "c.i:3:1: error: 'floor' and 'floor' cannot be ",
                    why = ": one is an analytic plane; nothing is held to planes\n";
  CHECK(refused(friction_law("tied")) == cannot + "tied" + why);
  CHECK(refused(friction_law("glued")) == cannot + "glued" + why);
  CHECK(refused(friction_law("surface weld", {{"normal capacity", 1.0}, {"tangential capacity", 1.0}})) ==
        cannot + "surface weld" + why);
  CHECK(refused(friction_law("hybrid", {{"initially far", DeckName{"tied", {}}}})) ==
        cannot + "hybrid" + why);
}
