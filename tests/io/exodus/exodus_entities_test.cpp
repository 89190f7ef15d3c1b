// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_entities.hpp"

#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("entities are described by id and, when it says more, by name", "[io][entities]") {
  CHECK(describe(EntityKind::block, 3, "lower") == "block 3 (lower)");
  CHECK(describe(EntityKind::block, 3, "") == "block 3");
  CHECK(describe(EntityKind::side_set, 3, "Surface_3") == "side set 3");
}

TEST_CASE("ids that repeat or are negative are refused, kind by kind", "[io][entities]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) { file.set_value("eb_prop1", 1, 10); }) ==
        "block 10 (upper): numbers 1 and 2 of the file's block list have the same id");
  CHECK(refusal(mesh, [](auto& file) { file.set_value("ss_prop1", 0, -4); }) ==
        "side set -4 (top): negative id");
  CHECK(refusal(mesh, [](auto& file) { file.set_value("ns_prop1", 0, 1); }).empty());
  CHECK(refusal(mesh, [](auto& file) { file.rename_variable("eb_prop1", "ids"); }) ==
        "has 2 blocks but no ids (variable eb_prop1)");
  CHECK(refusal(mesh, [](auto& file) {
          file.rename_variable("eb_prop1", "ids").add_integers("eb_prop1", {"num_dim"}, {1, 2, 3});
        }) == "variable eb_prop1 should have 2 values");
}

TEST_CASE("names that repeat within a kind are refused, between kinds they are legal", "[io][entities]") {
  const Mesh mesh = two_hexes().build();
  CHECK(refusal(mesh, [](auto& file) { file.set_text("eb_names", 1, "LOWER"); }) ==
        "block 20 (LOWER): block 10 has the same name");
  CHECK(refusal(mesh, [](auto& file) { file.set_text("ss_names", 0, "lower"); }).empty());
}

TEST_CASE("the default name of another id is dropped with a warning", "[io][entities]") {
  const auto change = [](ExodusEditor& file) { file.set_text("eb_names", 1, "block_10"); };
  const Mesh mesh = two_hexes().build();
  CHECK(warnings_of(mesh, change) ==
        "warning: block 20 is stored under the name 'block_10', which belongs to another id; it is block_20 "
        "[mesh-name-ignored]\n");
  CHECK(reread(mesh, change).find(EntityKind::block, "block_10") == 0u);
}

TEST_CASE("an entity declared and never written is left out", "[io][entities]") {
  MeshBuilder builder = two_hexes();
  builder.add_block(30, "", Shape::null, {});
  const auto change = [](ExodusEditor& file) { file.set_value("eb_prop1", 2, -1); };
  CHECK(warnings_of(builder.build(), change) ==
        "warning: block number 3 was declared and never written [mesh-entity-undefined]\n");
  CHECK(reread(builder.build(), change).blocks().size() == 2);
}

TEST_CASE("names longer than 32 characters survive", "[io][entities]") {
  const std::string name = "the_third_bolt_of_the_second_flange_from_the_left";
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .name = name}).add_assembly(9, name + "_and_more", EntityKind::block, {1});
  const Mesh found = reread(builder.build(), [](auto&) {}, {.name_length = 80});
  CHECK(found.find(EntityKind::block, name) == 0u);
  CHECK(found.find(EntityKind::assembly, name + "_AND_MORE") == 0u);
}

TEST_CASE("lists of names of the wrong shape are refused", "[io][entities]") {
  CHECK(refusal(two_hexes().build(), [](auto& file) {
          file.rename_variable("eb_names", "old").add_integers("eb_names", {"num_el_blk"}, {1, 2});
        }) == "variable eb_names is not a list of texts");
}
