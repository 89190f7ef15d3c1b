// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/request_parts.hpp"

#include <array>

#include "core/base/errors.hpp"
#include "support/asked_model.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

// Columns count from 1: in "contact surface s contains x" x stands in column 28.

using namespace contactsim;
using namespace contactsim::test;

namespace {

std::string errors_of_parts(const std::string& lines) {
  return resolve(asked_model().build(), lines).messages;
}

constexpr std::array any_kind{EntityKind::block, EntityKind::side_set, EntityKind::node_set,
                              EntityKind::assembly};

/// Requests of parts of asked_model().
struct AskedParts {
  Mesh mesh = asked_model().build();
  Diagnostics diagnostics;
  RegionNames names{{}, {}, {1, 3}};
  RequestParts parts{names, mesh, diagnostics};

  SurfaceRequest add(const std::vector<std::string>& items, SurfaceKind kind) {
    SurfaceRequest request = make_request("s", kind, "CONTACT SURFACE", {});
    for (const std::string& item : items) parts.add_item({item, {}}, any_kind, request);
    return request;
  }
};

using Positions = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("side sets of edges and nodes are no surfaces", "[contact][request]") {
  const std::string edge =
      "error: side set 'edge' holds side 4 of element 2 (SHELL4), which is an edge and no contact face\n";
  CHECK(errors_of_parts("contact surface s contains edge\n") == "c.i:1:28: " + edge);
  CHECK(errors_of_parts("begin contact surface s\n block = skin\n remove surface = edge\nend\n") ==
        "c.i:3:19: " + edge);
  CHECK(errors_of_parts("contact surface s contains tip\n") ==
        "c.i:1:28: error: side set 'tip' holds side 1 of element 3 (BEAM2), which is an edge and no contact "
        "face\n");
  CHECK(errors_of_parts("contact surface s contains skin\n").empty());
}

TEST_CASE("the sides of bars are nodes and no surfaces", "[contact][request]") {
  MeshBuilder b;
  b.add_bars({.id = 1});
  b.add_side_set(2, "", {{{0}, 2}});
  CHECK(resolve(b.build(), "contact surface s contains surface_2\n").messages ==
        "c.i:1:28: error: side set 'surface_2' holds side 2 of element 1 (BAR2), which is a node and no "
        "contact "
        "face\n");
}

TEST_CASE("assemblies must hold what the command takes", "[contact][request]") {
  CHECK(errors_of_parts("contact surface s contains points\n") ==
        "c.i:1:28: error: assembly 'points' holds node set 'corners', which CONTACT SURFACE cannot take\n");
  CHECK(errors_of_parts("begin contact surface s\n assembly = points\nend\n") ==
        "c.i:2:13: error: assembly 'points' holds node set 'corners', which BEGIN CONTACT SURFACE cannot "
        "take\n");
  CHECK(
      errors_of_parts("skin all blocks = on exclude tops\n") ==
      "c.i:1:30: error: assembly 'tops' holds side set 'plate', which SKIN ALL BLOCKS EXCLUDE cannot take\n");
  CHECK(errors_of_parts("contact surface s contains nothing\n") ==
        "c.i:1:28: error: assembly 'nothing' holds nothing that CONTACT SURFACE can take\n");
  CHECK(errors_of_parts("contact node set s contains points tops\n").empty());
}

TEST_CASE("a new request has its name, kind, command and place, and asks for nothing", "[contact][request]") {
  DeckLocation place;
  place.line = 7;
  const SurfaceRequest request = make_request("Top", SurfaceKind::node, "CONTACT NODE SET", place);
  CHECK(request.name == "Top");
  CHECK(request.kind == SurfaceKind::node);
  CHECK(request.command == "CONTACT NODE SET");
  CHECK(request.location.line == 7);
  CHECK(request.blocks.empty());
  CHECK(request.side_sets.empty());
  CHECK_FALSE(request.is_block_form);
  CHECK(request.surfaces().size() == 1);
}

TEST_CASE("names of mesh parts go to the list of their kind, assemblies opened", "[contact][request]") {
  AskedParts asked;
  const SurfaceRequest request =
      asked.add({"skin", "surface_10", "corners", "mixed", "tops"}, SurfaceKind::node);
  CHECK(messages(asked.diagnostics).empty());
  CHECK(request.blocks == Positions{1, 0, 3});
  CHECK(request.side_sets == Positions{0, 0});
  CHECK(request.node_sets == Positions{0});
}

TEST_CASE("sides that are no faces go into surfaces of nodes alone", "[contact][request]") {
  AskedParts faces, nodes;
  CHECK(faces.add({"edge", "surface_10"}, SurfaceKind::face).side_sets == Positions{0});
  CHECK(faces.diagnostics.has_errors());
  CHECK(nodes.add({"edge", "surface_10"}, SurfaceKind::node).side_sets == Positions{1, 0});
  CHECK_FALSE(nodes.diagnostics.has_errors());
}

TEST_CASE("blocks without a size are known", "[contact][request]") {
  const AskedParts asked;
  CHECK_FALSE(asked.parts.is_sizeless(0));
  CHECK(asked.parts.is_sizeless(1));
  CHECK_FALSE(asked.parts.is_sizeless(2));
  CHECK(asked.parts.is_sizeless(3));
}

TEST_CASE("elements of an unknown type are an error of the file, also through a side set",
          "[contact][request]") {
  MeshParts strange = asked_model().parts();
  strange.blocks[0].shape = Shape::unknown;
  strange.blocks[0].type_name = "PYRAMID13";
  strange.blocks[0].nodes.clear();
  const Mesh mesh(std::move(strange));
  Diagnostics diagnostics;
  const RegionNames names{{}, {}};
  RequestParts parts(names, mesh, diagnostics);
  SurfaceRequest request;
  CHECK_THROWS_AS(parts.add_block(0, {}, request), FileError);
  CHECK_THROWS_AS(parts.add_item({"surface_10", {}}, any_kind, request), FileError);
  parts.add_block(1, {}, request);
  CHECK(request.blocks == Positions{1});
}
