// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_assemblies.hpp"

#include "io/exodus/sample_mesh.hpp"
#include "support/catch.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

// Assemblies 1 (blocks 10 and 20), 2 and 3 (of assemblies) on the two hexes.
MeshBuilder nested() {
  return two_hexes()
      .add_assembly(1, "solids", EntityKind::block, {10, 20})
      .add_assembly(2, "outer", EntityKind::assembly, {1})
      .add_assembly(3, "outermost", EntityKind::assembly, {2, 1});
}

}  // namespace

TEST_CASE("nested assemblies may stand before their members", "[io][assemblies]") {
  MeshParts parts = two_hexes().parts();
  parts.assemblies = {{5, "outer", EntityKind::assembly, {1}}, {4, "inner", EntityKind::node_set, {0, 0}}};
  const Mesh found = reread(Mesh(parts), [](auto&) {});
  CHECK(found.members(0) == std::vector<Entity>{{EntityKind::node_set, 0}});
  CHECK(found.assemblies()[1].members == std::vector<std::uint32_t>{0, 0});
}

TEST_CASE("an assembly may have the id and the name of a block", "[io][assemblies]") {
  const Mesh found =
      reread(two_hexes().add_assembly(10, "lower", EntityKind::side_set, {1}).build(), [](auto&) {});
  CHECK(found.find("lower") == std::vector<Entity>{{EntityKind::block, 0}, {EntityKind::assembly, 0}});
  CHECK(found.find("assembly_10") == std::vector<Entity>{{EntityKind::assembly, 0}});
}

TEST_CASE("members that do not exist are refused", "[io][assemblies]") {
  CHECK(refusal(nested().build(), [](auto& file) { file.set_value("assembly_entity1", 1, 4711); }) ==
        "assembly 1 (solids): its member block 4711 does not exist");
  CHECK(refusal(nested().build(), [](auto& file) { file.set_attribute("assembly_entity1", "_type", 2.0); }) ==
        "assembly 1 (solids): its member node set 10 does not exist");
}

TEST_CASE("assemblies that contain themselves are refused", "[io][assemblies]") {
  CHECK(refusal(nested().build(), [](auto& file) { file.set_value("assembly_entity2", 0, 2); }) ==
        "assembly 2 (outer) contains itself");
  CHECK(refusal(nested().build(), [](auto& file) { file.set_value("assembly_entity2", 0, 3); }) ==
        "assembly 2 (outer) contains itself through assembly 3 (outermost)");
}

TEST_CASE("kinds that are not used are kept without members", "[io][assemblies]") {
  const Mesh found =
      reread(nested().build(), [](auto& file) { file.set_attribute("assembly_entity1", "_type", 17.0); });
  CHECK(!found.assemblies()[0].member_kind);
  CHECK(found.members(2).empty());
}

TEST_CASE("assemblies without id, kind or with repeated identity are refused", "[io][assemblies]") {
  CHECK(refusal(nested().build(), [](auto& file) { file.remove_attribute("assembly_entity2", "_id"); }) ==
        "assembly assembly_entity2: no _id");
  CHECK(refusal(nested().build(), [](auto& file) { file.remove_attribute("assembly_entity2", "_type"); }) ==
        "assembly assembly_entity2: no _type");
  CHECK(refusal(nested().build(), [](auto& file) { file.set_attribute("assembly_entity2", "_id", 1.0); }) ==
        "assembly 1 (outer): numbers 1 and 2 of the file's assembly list have the same id");
  CHECK(refusal(nested().build(), [](auto& file) {
          file.set_attribute("assembly_entity2", "_name", "Solids");
        }) == "assembly 2 (Solids): assembly 1 has the same name");
}

TEST_CASE("an assembly without a name goes by its id", "[io][assemblies]") {
  const Mesh found =
      reread(nested().build(), [](auto& file) { file.remove_attribute("assembly_entity2", "_name"); });
  CHECK(found.names(EntityKind::assembly) == std::vector<std::string>{"solids", "assembly_2", "outermost"});
}
