// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/smoothing_warnings.hpp"

#include "core/definition/contact.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/flying_cube.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// A cube before another one, of whose pair "lower" is smoothed as these lines say.
struct SmoothedCube : FlyingCube {
  explicit SmoothedCube(const std::string& shape, const std::string& pair = "")
      : FlyingCube({.contact = "begin surface smoothing ball\nsurface = lower\n" + shape +
                               "end\nbegin interaction\nsurfaces = lower upper\nsmoothing = ball\n" + pair +
                               "end\n"}) {
    run(0);
  }
  const ContactForce& force() { return *simulation.contact_force(); }
  std::string said() {
    Diagnostics warnings;
    warn_of_smoothings(force(), contact, mesh, warnings);
    return messages(warnings);
  }
  /// What is said of a cube that is stretched along x by this factor.
  std::string said_of_stretch(double factor) {
    Diagnostics warnings;
    State state = simulation.state();
    state.coordinates = mesh.coordinates();
    state.coordinates.row(0) *= factor;
    warn_of_strain(force(), contact, mesh, state, warnings);
    return messages(warnings);
  }
};

}  // namespace

TEST_CASE("faces that lean on their round shape are counted", "[app][smoothing]") {
  // About the middle of a cube each quarter of a side looks away by 35 degrees; about one far off all do.
  CHECK_THAT(
      SmoothedCube("spherical center = 0.5 0.5 0.5\n").said(),
      Contains("warning: 24 of 24 faces of 'lower' lean by more than 15 degrees on the shape that the "
               "smoothing 'ball' gives them; the axis or centre may be another one [smoothing-askew]\n"));
}

TEST_CASE("smoothing of what only ties is reported to do nothing", "[app][smoothing]") {
  CHECK_THAT(
      SmoothedCube("spherical center = 0.5 0.5 0.5\n", "friction model = tied\n").said(),
      Contains("warning: 'lower' and 'upper': ties hold faces as they find them, with or without SMOOTHING "
               "[smoothing-without-effect]\n"));
}

TEST_CASE("edges of a smoothed surface that change by more than a tenth are reported once",
          "[app][smoothing]") {
  SmoothedCube cube("spherical center = 0.5 0.5 0.5\n");
  CHECK(cube.said_of_stretch(1.0) == "");
  CHECK(cube.said_of_stretch(1.09) == "");
  CHECK(cube.said_of_stretch(0.91) == "");
  CHECK(cube.said_of_stretch(1.25) ==
        "warning: edges of 'lower' have changed their length by 25 %, and its round shape is that of the "
        "start; "
        "smoothing is for small strains; SMOOTHING = OFF takes the faces as they are [smoothing-strained]\n");
  CHECK_THAT(cube.said_of_stretch(0.8), Contains("by 20 %"));
}
