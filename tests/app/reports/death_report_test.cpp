// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/death_report.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

/// Two surfaces of which the first, with two faces of the cube, has changed.
struct Deaths {
  Mesh mesh = test::MeshBuilder().add_hexes({.id = 1, .name = "cube"}).build();
  ContactModel contact;
  DeathTally tally;
  State state;

  Deaths() {
    for (const char* name : {"lid", "box"}) contact.surfaces.surfaces.emplace_back().name = name;
    contact.surfaces.surfaces[{0}].faces = {ElementSide({0}, 1), ElementSide({0}, 2)};
    tally = {1, 3, 0, 2, SurfaceChanges(2)};
    tally.changes[{0}] = {4, 1, 7, 0, 0};
    state.step = 12;
    state.time = 0.25;
  }
  std::string report(DeathLog detail) const { return format_deaths(tally, state, detail, &contact, mesh); }
};

const std::string first_line = "Element death at step 12, time 2.500000e-01: 1 element died, 3 dead";
const std::string counts = "; contact gains 4 faces, loses 1 face, has 2 free nodes\n";

}  // namespace

TEST_CASE("deaths without contact are counted in one line", "[app][death]") {
  Deaths deaths;
  const auto line = [&] {
    return format_deaths(deaths.tally, deaths.state, DeathLog::full, nullptr, deaths.mesh);
  };
  CHECK(line() == first_line + "\n");
  deaths.tally.n_died = 0;
  deaths.tally.n_dying = 5;
  CHECK(line() == "Element death at step 12, time 2.500000e-01: 0 elements died, 3 dead, 5 dying\n");
}

TEST_CASE("of contact the faces of all surfaces are summed, and listed of those that have changed",
          "[app][death]") {
  Deaths deaths;
  CHECK(deaths.report(DeathLog::minimal) == first_line + counts);
  const std::string some = deaths.report(DeathLog::some);
  CHECK(some == first_line + counts +
                    "  surface                         gained      lost     faces      lost    lofted\n"
                    "  lid                                  4         1         2         7         0\n");
  const std::string full = deaths.report(DeathLog::full);
  CHECK(full.starts_with(some));
  CHECK_THAT(full, Catch::Contains("Contact surfaces"));
  deaths.tally.changes[{0}] = {};
  CHECK(deaths.report(DeathLog::some) ==
        first_line + "; contact gains 0 faces, loses 0 faces, has 2 free nodes\n");
}

TEST_CASE("a run ends with all that has died of what may", "[app][death]") {
  CHECK(format_death_total({1, 1, 0, 0, {}}, 8) ==
        "\nElement death\n  1 element of 8 that may die are dead, 0 dying\n");
  CHECK(format_death_total({0, 3, 2, 0, {}}, 8) ==
        "\nElement death\n  3 elements of 8 that may die are dead, 2 dying\n");
}
