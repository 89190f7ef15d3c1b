// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/candidate_filter.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two cubes: faces 0 to 5 and 6 to 11, surface nodes 0 to 7 and 8 to 15, which are those of the mesh.
struct FilteredCubes {
  ContactParts parts;
  CandidateFilter filter;

  explicit FilteredCubes(const std::string& lines = "", bool is_once = false,
                         std::span<const OptionalIndex<std::uint32_t>> body_of = {})
      : parts(TwoCubes::cubes(), general_contact(lines)),
        filter(parts.contact_mesh, parts.mesh, parts.rules, is_once, body_of) {}
};

}  // namespace

TEST_CASE("faces of different surfaces have a pair where their interaction is one of faces",
          "[contact][candidate_filter]") {
  const FilteredCubes of_faces, of_nodes("constraint formulation = node_face\n"),
      of_self("self contact = on\n");
  CHECK(of_faces.filter.pair_of_faces({0}, {6}) == OptionalIndex<PairIndex>(PairIndex{0}));
  CHECK_FALSE(of_faces.filter.pair_of_faces({0}, {1}));
  CHECK_FALSE(of_nodes.filter.pair_of_faces({0}, {6}));
  CHECK(of_self.filter.pair_of_faces({0}, {1}));
  // A node meets faces as the formulation says.
  CHECK_FALSE(of_faces.filter.node_may_meet({0}, {6}));
  CHECK(of_nodes.filter.node_may_meet({0}, {6}));
  CHECK_FALSE(of_nodes.filter.node_may_meet({0}, {0}));
}

TEST_CASE("faces of one element do not meet, of one surface either", "[contact][candidate_filter]") {
  const FilteredCubes cubes("self contact = on\n");
  const auto pair = cubes.filter.pair_of_faces({0}, {1});
  REQUIRE(pair);
  CHECK_FALSE(cubes.filter.faces_may_meet(*pair, {0}, {1}));
  CHECK(cubes.filter.faces_may_meet(*cubes.filter.pair_of_faces({0}, {6}), {0}, {6}));
}

TEST_CASE("faces have to face each other where nothing but sliding can hold them",
          "[contact][candidate_filter]") {
  const std::string rough =
      "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.3\n";
  CHECK(FilteredCubes().filter.has_to_face({0}));
  CHECK(FilteredCubes(rough).filter.has_to_face({0}));
  CHECK_FALSE(FilteredCubes("friction model = tied\n").filter.has_to_face({0}));
  CHECK_FALSE(FilteredCubes("interaction behavior = infinitesimal_sliding\n").filter.has_to_face({0}));
  // A single search has to find what comes to face something later.
  CHECK_FALSE(FilteredCubes("", true).filter.has_to_face({0}));
}

TEST_CASE("pairs with ties alone have candidates in the first search only", "[contact][candidate_filter]") {
  for (const bool is_tied : {true, false}) {
    FilteredCubes faces(is_tied ? "friction model = tied\n" : "");
    FilteredCubes nodes(std::string("constraint formulation = node_face\n") +
                        (is_tied ? "friction model = tied\n" : ""));
    CHECK(faces.filter.faces_may_meet({0}, {0}, {6}));
    CHECK(nodes.filter.node_may_meet({0}, {6}));
    faces.filter.set_first_search(false);
    nodes.filter.set_first_search(false);
    CHECK(faces.filter.faces_may_meet({0}, {0}, {6}) == !is_tied);
    CHECK(nodes.filter.node_may_meet({0}, {6}) == !is_tied);
  }
}

TEST_CASE("what belongs to one rigid body does not meet", "[contact][candidate_filter]") {
  std::vector<OptionalIndex<std::uint32_t>> body_of(16, 3u);
  const std::string lines = GENERATE("", "constraint formulation = node_face\n");
  const auto meet = [&] {
    const FilteredCubes cubes(lines, false, body_of);
    return lines.empty() ? cubes.filter.faces_may_meet({0}, {0}, {6}) : cubes.filter.node_may_meet({0}, {6});
  };
  CHECK_FALSE(meet());
  std::fill(body_of.begin() + 8, body_of.end(), 4u);
  CHECK(meet());
  // Nodes of no body are of none, even together.
  std::fill(body_of.begin(), body_of.end(), std::nullopt);
  CHECK(meet());
}
