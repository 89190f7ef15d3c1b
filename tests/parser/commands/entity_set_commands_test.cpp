// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/entity_set_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// The set of a FIXED DISPLACEMENT that has these lines.
EntitySet set_of(const std::string& lines) {
  const BoundRegion bound = bound_region("begin fixed displacement\n" + lines + "end\n");
  CHECK(bound.messages == "");
  return bound.region.fixed_conditions.at(0).set;
}

}  // namespace

TEST_CASE("every kind of mesh part can be added and the lines of one kind add up", "[parser][entity_set]") {
  const EntitySet set = set_of(
      "node set = n1 n2\nnode set n3\nsurface = s1, s2\nblock = b1 b2\nblock is b3\nassembly = a1\nrigid "
      "body = rb\n"
      "node = 3 4\nelement = 17\n");
  CHECK(joined_names(set.node_sets) == "n1 n2 n3");
  CHECK(joined_names(set.side_sets) == "s1 s2");
  CHECK(joined_names(set.blocks) == "b1 b2 b3");
  CHECK(joined_names(set.assemblies) == "a1");
  CHECK(joined_names(set.rigid_bodies) == "rb");
  REQUIRE(set.nodes.size() == 2);
  CHECK(set.nodes[1].id == 4);
  CHECK(to_string(set.nodes[1].location) == "a.i:9:10");
  REQUIRE(set.elements.size() == 1);
  CHECK(set.elements[0].id == 17);
  CHECK_FALSE(set.includes_all_blocks);
}

TEST_CASE("node sets and side sets have several spellings", "[parser][entity_set]") {
  CHECK(joined_names(set_of("nodeset = a\nnode_set = b\nNODE SET = c\n").node_sets) == "a b c");
  CHECK(joined_names(set_of("sideset = a\nside set = b\nside_set = c\nsurface d\n").side_sets) == "a b c d");
}

TEST_CASE("parts are taken away again", "[parser][entity_set]") {
  const EntitySet set = set_of(
      "include all blocks\nremove block = b1 b2\nremove node set = n\nremove nodeset = m\nremove surface = "
      "s\n"
      "remove sideset = t\n");
  CHECK(set.includes_all_blocks);
  CHECK(joined_names(set.removed_blocks) == "b1 b2");
  CHECK(joined_names(set.removed_node_sets) == "n m");
  CHECK(joined_names(set.removed_side_sets) == "s t");
}

TEST_CASE("a set that only removes names nothing", "[parser][entity_set]") {
  CHECK_FALSE(set_of("remove block = b\n").names_something());
  CHECK(set_of("node = 1\n").names_something());
  CHECK(set_of("rigid body = rb\n").names_something());
  CHECK(set_of("include all blocks\n").names_something());
}

TEST_CASE("an id must be a whole number from 1", "[parser][entity_set]") {
  CHECK(bound_region("begin fixed displacement\n node = 0\n element = x\n node =\nend\n").messages ==
        "a.i:2:9: error: 'node' must be at least 1, found '0'\n"
        "a.i:3:12: error: expected an integer for 'element', found 'x'\n"
        "a.i:4:2: error: expected an integer after 'node', found the end of the line\n");
}
