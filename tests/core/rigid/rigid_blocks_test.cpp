// SPDX-License-Identifier: BSD-3-Clause
#include "core/rigid/rigid_blocks.hpp"

#include <algorithm>

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace {

DeckName named(const std::string& text) { return {text, {}}; }

/// Blocks "one", "two" and "three", of which "one" and "three" have a section that is a part of Body.
struct Parts {
  Parts() {
    for (const int id : {1, 2, 3}) {
      static const char* const names[] = {"", "one", "two", "three"};
      builder.add_hexes({.id = id, .name = names[id], .origin = {0, 0, 2.0 * id}});
    }
    definition.sections.push_back({named("stiff"), named("Body"), SolidSection{}});
    definition.sections.push_back({named("soft"), std::nullopt, SolidSection{}});
    FiniteElementModel model;
    model.name = named("m");
    model.block_parameters = {parameters("one", "STIFF"), parameters("two", "soft"),
                              parameters("three", "stiff")};
    definition.finite_element_models.push_back(model);
    body.name = named("BODY");
  }
  static BlockParameters parameters(const std::string& block, const std::string& section) {
    BlockParameters made;
    made.names = {named(block)};
    made.section = named(section);
    return made;
  }
  std::vector<std::uint32_t> find() const {
    return find_rigid_blocks(definition, Region{}, builder.build(), body);
  }

  test::MeshBuilder builder;
  SimulationDefinition definition;
  RigidBodyDefinition body;
};

using Blocks = std::vector<std::uint32_t>;

}  // namespace

TEST_CASE("blocks whose section names a rigid body are its parts, in the order of the mesh",
          "[core][rigid]") {
  Parts parts;
  CHECK(parts.find() == Blocks{0, 2});
  std::ranges::reverse(parts.definition.finite_element_models[0].block_parameters);
  CHECK(parts.find() == Blocks{0, 2});
  parts.body.name.text = "other";
  CHECK(parts.find().empty());
}

TEST_CASE("blocks without a section, or without parameters, are no parts of a rigid body", "[core][rigid]") {
  Parts parts;
  auto& parameters = parts.definition.finite_element_models[0].block_parameters;
  parameters[0].section.reset();
  CHECK(parts.find() == Blocks{2});
  parameters.pop_back();
  CHECK(parts.find().empty());
  parts.definition.finite_element_models.clear();
  CHECK(parts.find().empty());
}

TEST_CASE("an alias of a block stands for it where parts of a rigid body are named", "[core][rigid]") {
  Parts parts;
  FiniteElementModel& model = parts.definition.finite_element_models[0];
  model.aliases.push_back({named("two"), named("second")});
  model.block_parameters[1] = Parts::parameters("second", "stiff");
  CHECK(parts.find() == Blocks{0, 1, 2});
}
