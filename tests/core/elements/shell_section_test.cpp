// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/shell_section.hpp"

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;

namespace shell_section_test {

namespace {

DeckName named(const std::string& text) { return {text, {}}; }

std::string messages_of(const Diagnostics& diagnostics) {
  std::string text;
  for (const Diagnostic& diagnostic : diagnostics.all()) text += diagnostic.text + "\n";
  return text;
}

/// Two shells with the attributes "thickness" 0.1, 0.2 and "other" 3, 0.
Mesh two_shells() {
  MeshParts parts = test::MeshBuilder().add_shells({.cells = {2, 1}}).parts();
  parts.blocks[0].attribute_names = {"other", "thickness"};
  parts.blocks[0].attributes = {3.0, 0.1, 0.0, 0.2};
  return Mesh(std::move(parts));
}

}  // namespace

TEST_CASE("a thickness comes from the section, else from the mesh, and is scaled", "[core][shells]") {
  const Mesh mesh = two_shells();
  Diagnostics diagnostics;
  ShellSection section;
  section.thickness_scale_factor = 2.0;
  CHECK(find_thicknesses(section, mesh, 0, {}, diagnostics) == std::vector<double>{0.2, 0.4});
  section.thickness = 0.5;
  CHECK(find_thicknesses(section, mesh, 0, {}, diagnostics) == std::vector<double>{1.0, 1.0});
  CHECK(diagnostics.empty());
  section.thickness.reset();
  section.thickness_mesh_variable = named("Other");
  CHECK_FALSE(find_thicknesses(section, mesh, 0, {}, diagnostics));
  section.thickness_mesh_variable = named("none");
  CHECK_FALSE(find_thicknesses(section, mesh, 0, {}, diagnostics));
  CHECK(messages_of(diagnostics) ==
        "block_1: the thickness of element 2 is 0\n"
        "block_1 has no attribute 'none' on the mesh, from which its section takes the thickness\n");
}

TEST_CASE("a section's rule, points and lofting reach the shells", "[core][shells]") {
  Diagnostics diagnostics;
  ShellSection section;
  section.integration_rule = named("Gauss");
  section.n_integration_points = 2;
  section.lofting_factor = 1.0;
  BlockParameters parameters;
  parameters.hourglass_stiffness = 0.02;
  const auto settings = make_shell_settings(section, parameters, {}, diagnostics);
  REQUIRE(settings);
  CHECK(diagnostics.empty());
  CHECK(settings->layers.size() == 2);
  CHECK(settings->offset == 0.5);
  CHECK(settings->bending_hourglass == 0.02);
  section.integration_rule = named("simpsons");
  CHECK_FALSE(make_shell_settings(section, parameters, {}, diagnostics));
  CHECK(messages_of(diagnostics) == "there is no integration rule 'simpsons' of 2 points\n");
}

}  // namespace shell_section_test
