// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/smoothing_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using Eigen::Vector3d;

namespace {

const std::string surfaces =
    "contact surface a contains b1\ncontact surface b contains b2\ncontact surface c contains b3\n";

}  // namespace

TEST_CASE("a surface smoothing has regions, a shape behind each", "[parser][smoothing]") {
  const BoundContact bound = bound_contact(
      surfaces +
      "begin surface smoothing s\nsurface = a b\ncircumferential axis = 0 0 0 0 0 1\nsurface = c\nspherical "
      "centre = 1 2 3\nend\nbegin interaction\nsurfaces = a b\nsmoothing = s\nend\n");
  CHECK(bound.messages == "");
  REQUIRE(bound.contact.smoothings.size() == 1);
  const SurfaceSmoothing& smoothing = bound.contact.smoothings[0];
  CHECK(smoothing.name.text == "s");
  REQUIRE(smoothing.regions.size() == 2);
  CHECK(joined_names(smoothing.regions[0].surfaces) == "a b");
  const auto& axis = std::get<CircumferentialShape>(*smoothing.regions[0].shape).axis;
  CHECK_FALSE(axis.axis);
  CHECK(std::get<Vector3d>((*axis.points)[1]) == Vector3d::UnitZ());
  CHECK(std::get<Vector3d>(std::get<SphericalShape>(*smoothing.regions[1].shape).center) ==
        Vector3d(1, 2, 3));
  REQUIRE(bound.contact.interactions[0].pair.smoothing);
  CHECK(bound.contact.interactions[0].pair.smoothing->kind == SmoothingChoice::Kind::named);
  CHECK(bound.contact.interactions[0].pair.smoothing->name.text == "s");
}

TEST_CASE("a torus has an axis and the radius of its circle", "[parser][smoothing]") {
  const BoundContact bound = bound_contact(
      surfaces +
      "begin surface smoothing s\nsurface = a\ntoroidal axis = 0 0 0 1 0 0 radius = 3\nend\n"
      "begin interaction defaults\nsmoothing = auto\nend\nbegin interaction\nsurfaces = a b\nsmoothing = "
      "off\nend\n");
  CHECK(bound.messages == "");
  const auto& shape = std::get<ToroidalShape>(*bound.contact.smoothings[0].regions[0].shape);
  CHECK(shape.radius == 3.0);
  CHECK(bound.contact.interaction_defaults->pair.smoothing->kind == SmoothingChoice::Kind::automatic);
  CHECK(bound.contact.interactions[0].pair.smoothing->kind == SmoothingChoice::Kind::off);
}

TEST_CASE("what a surface smoothing lacks, or says twice, is reported", "[parser][smoothing]") {
  const auto messages = [](const std::string& lines) {
    return contact_name_messages(surfaces + "begin surface smoothing s\n" + lines +
                                 "end\nbegin interaction\nsurfaces = a b\nsmoothing = s\nend\n");
  };
  CHECK(messages("").find("has no SURFACE") != std::string::npos);
  CHECK(messages("surface = a\n").find("has a SURFACE line without a shape") != std::string::npos);
  CHECK(messages("spherical center = 0 0 0\n").find("stands behind the SURFACE line") != std::string::npos);
  CHECK(messages("surface = a\nspherical center = 0 0 0\nspherical center = 0 0 1\n")
            .find("have a shape already") != std::string::npos);
  CHECK(messages("surface = a\nspherical center = 0 0 0\nsurface = a\nspherical center = 0 0 1\n")
            .find("names the surface 'a' twice") != std::string::npos);
  CHECK(messages("surface = all\nspherical center = 0 0 0\nsurface = a\nspherical center = 0 0 1\n")
            .find("has ALL beside other surfaces") != std::string::npos);
  CHECK(messages("surface = a\ntoroidal axis = 0 0 0 1 0 0\n").find("radius") != std::string::npos);
  CHECK(messages("surface = a\ntoroidal axis = 0 0 0 1 0 0 radius = -1\n").find("greater than 0") !=
        std::string::npos);
}

TEST_CASE("a smoothing that is not there is an error with the nearest name", "[parser][smoothing]") {
  const std::string messages = contact_name_messages(surfaces +
                                                     "begin surface smoothing round\nsurface = a\nspherical "
                                                     "center = 0 0 0\nend\nbegin interaction\nsurfaces = a "
                                                     "b\nsmoothing = rund\nend\n");
  CHECK(messages.find("'rund'") != std::string::npos);
  CHECK(messages.find("round") != std::string::npos);
}
