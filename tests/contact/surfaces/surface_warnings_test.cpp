// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_warnings.hpp"

#include "support/asked_model.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two surfaces, the second with a subset, and the requests that they were made by.
struct WarnedSurfaces {
  Mesh mesh = asked_model().build();
  std::vector<SurfaceRequest> requests{2};
  ContactSurfaces result;

  WarnedSurfaces() {
    requests[0].name = "low";
    requests[1].name = "high";
    requests[1].first_surface = {1};
    requests[1].subsets.resize(1);
    result.surfaces.resize(3);
    const char* names[] = {"low", "high", "high_top"};
    for (const SurfaceIndex i : indices(result.surfaces)) {
      result.surfaces[i].name = names[i.value];
      result.surfaces[i].location.line = 10 * static_cast<int>(i.value) + 1;
      result.surfaces[i].faces = {ElementSide({0}, i.value + 1)};
    }
  }
  std::string told() {
    set_surface_warnings(requests, mesh, result);
    std::string text;
    for (const SurfaceWarning& warning : result.warnings)
      text += warning.id + " " + std::to_string(warning.location.line) + " " + warning.surface + " " +
              std::to_string(warning.count) + ": " + warning.text + "\n";
    return text;
  }
};

}  // namespace

TEST_CASE("surfaces that own something and lost nothing are not warned about", "[contact][surfaces]") {
  CHECK(WarnedSurfaces().told().empty());
}

TEST_CASE("what a surface lost is told by its winner, one and many", "[contact][surfaces]") {
  WarnedSurfaces surfaces;
  surfaces.result.surfaces[{2}].lost_to = {{{0}, 1, 0, 2}, {{1}, 0, 3, 0}};
  surfaces.result.surfaces[{1}].lost_to = {{{0}, 4, 1, 1}};
  CHECK(surfaces.told() ==
        "surface-overlap 11 high 6: surface 'high': 4 faces, 1 lofted element, 1 node already in surface "
        "'low'\n"
        "surface-overlap 21 high_top 3: surface 'high_top': 1 face, 2 nodes already in surface 'low'\n"
        "surface-overlap 21 high_top 3: surface 'high_top': 3 lofted elements already in surface 'high'\n");
}

TEST_CASE("an empty surface is told, and what it lost before that", "[contact][surfaces]") {
  WarnedSurfaces surfaces;
  surfaces.result.surfaces[{1}].faces.clear();
  surfaces.result.surfaces[{1}].lost_to = {{{0}, 1, 0, 0}};
  CHECK(surfaces.told() ==
        "surface-overlap 11 high 1: surface 'high': 1 face already in surface 'low'\n"
        "surface-empty 11 high 0: surface 'high' owns nothing and takes no part in contact\n");
  for (const bool is_nodes : {false, true}) {
    WarnedSurfaces other;
    other.result.surfaces[{0}].faces.clear();
    if (is_nodes) other.result.surfaces[{0}].nodes = {{3}};
    if (!is_nodes) other.result.surfaces[{0}].analytic_planes = {0};
    CHECK(other.told().empty());
  }
}

TEST_CASE("particles that were left out are told by the names of their blocks, before what else there is",
          "[contact][surfaces]") {
  WarnedSurfaces surfaces;
  surfaces.requests[1].particle_blocks_left_out = {3, 2};
  surfaces.requests[1].location.line = 9;
  surfaces.result.surfaces[{1}].faces.clear();
  CHECK(surfaces.told() ==
        "surface-particles-left-out 9 high 2: surface 'high': INCLUDE ALL BLOCKS leaves out blocks of "
        "particles "
        "only: dust, block_3\n"
        "surface-empty 11 high 0: surface 'high' owns nothing and takes no part in contact\n");
  CHECK(surfaces.told() == surfaces.told());  // warnings are set, not added
  CHECK(surfaces.result.warnings.size() == 2);
}
