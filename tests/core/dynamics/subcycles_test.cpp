// SPDX-License-Identifier: BSD-3-Clause
#include "core/dynamics/subcycles.hpp"

#include <algorithm>

#include "core/conditions/condition_scope.hpp"
#include "core/definition/region.hpp"
#include "core/definition/simulation.hpp"
#include "core/dynamics/discrete_steps.hpp"
#include "core/dynamics/model.hpp"
#include "support/catch.hpp"
#include "support/graded_rod.hpp"
#include "support/material_model.hpp"
#include "support/mesh_builder.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A row of cubes, then flat ones, then cubes: blocks left, flat, right.
Mesh row_of_cubes(int n_left = 80, int n_right = 80) {
  return MeshBuilder()
      .add_hexes({.id = 1, .name = "left", .cells = {n_left, 1, 1}, .size = {1.0 * n_left, 1, 1}})
      .add_hexes(
          {.id = 2, .name = "flat", .cells = {2, 1, 1}, .origin = {1.0 * n_left, 0, 0}, .size = {0.2, 1, 1}})
      .add_hexes({.id = 3,
                  .name = "right",
                  .cells = {n_right, 1, 1},
                  .origin = {n_left + 0.2, 0, 0},
                  .size = {1.0 * n_right, 1, 1}})
      .build();
}

/// What a line of the deck makes of a mesh of steel.
struct Asked {
  Asked(Mesh of, std::vector<std::string> names) : mesh(std::move(of)) {
    const MaterialModel elastic =
        material_model("elastic", {{"youngs modulus", 200e9}, {"poissons ratio", 0.0}});
    definition.materials.push_back({{"steel", {}}, 7800.0, {elastic}});
    BlockParameters parameters;
    parameters.includes_all_blocks = true;
    parameters.material = DeckName{"steel", {}};
    parameters.model = DeckName{"elastic", {}};
    definition.finite_element_models.push_back({{"fem", {}}, {}, {}, {parameters}, {}});
    for (std::string& name : names) region.subcycle_blocks.push_back({std::move(name), {}});
    model = make_model(definition, region, mesh, diagnostics);
    set_subcycles({definition, region, {}, mesh, diagnostics}, model);
  }
  bool said(std::string_view part) const {
    return std::ranges::any_of(diagnostics.all(), [&](const Diagnostic& d) {
      return d.id == part || d.text.find(part) != std::string::npos;
    });
  }
  /// Elements of subcycled chunks.
  std::size_t n_in_chunks() const {
    std::size_t n = 0;
    for (const ModelBlock& block : model.blocks) {
      for (const BatchChunk& chunk : block.chunks) {
        if (!chunk.is_subcycled) continue;
        n += std::min(block.n_elements, n_lanes * (chunk.first_batch + chunk.n_batches)) -
             n_lanes * chunk.first_batch;
      }
    }
    return n;
  }

  SimulationDefinition definition;
  Region region;
  Mesh mesh;
  Diagnostics diagnostics;
  Model model;
};

}  // namespace

TEST_CASE("three layers around small elements are subcycled, by whole batches", "[core][subcycles]") {
  const GradedRod rod({.n_large = 40, .n_small = 2});
  const SubcycledSet set(rod.model, rod.steps, 1.0);
  // Elements 38 to 40 of the first block are in its last batch of eight, 1 to 3 of the third in its first.
  CHECK(set.batches()[0] == std::vector<std::uint8_t>{0, 0, 0, 0, 1});
  CHECK(set.batches()[1] == std::vector<std::uint8_t>{1});
  CHECK(set.batches()[2] == std::vector<std::uint8_t>{1, 0, 0, 0, 0});
  CHECK(set.sums().n_elements == 18);
  CHECK(set.sums().n_others == 64);
  CHECK(set.sums().nodes.size() == 4 * 19);
  CHECK(std::ranges::is_sorted(set.sums().nodes));
  CHECK(set.sums().n_parts == 10);
  CHECK(set.sums().saving() == Approx(820.0 / (64 + 180)));
  // Three layers, not two or four: small ones three elements before a batch ends reach just into it.
  GradedRod other({.n_large = 40, .n_small = 2});
  std::fill(other.steps.begin(), other.steps.end(), 1.0);
  other.steps[10] = 0.5;
  const auto batches_with = [&] { return SubcycledSet(other.model, other.steps, 1.0).batches()[0]; };
  CHECK(batches_with() == std::vector<std::uint8_t>{1, 1, 0, 0, 0});  // 7 to 13
  std::swap(other.steps[10], other.steps[11]);
  CHECK(batches_with() == std::vector<std::uint8_t>{0, 1, 0, 0, 0});  // 8 to 14
  std::swap(other.steps[11], other.steps[13]);
  CHECK(batches_with() == std::vector<std::uint8_t>{0, 1, 1, 0, 0});  // 10 to 16
}

TEST_CASE("round-off makes no element small", "[core][subcycles]") {
  GradedRod rod({});
  std::fill(rod.steps.begin(), rod.steps.end(), 1.0 - 1e-9);
  CHECK(SubcycledSet(rod.model, rod.steps, 1.0).sums().empty());
}

TEST_CASE("small elements of named blocks are subcycled in the step of all others", "[core][subcycles]") {
  const Asked asked(row_of_cubes(), {"flat"});
  CHECK(asked.diagnostics.empty());
  CHECK(asked.model.subcycles.n_elements == 18);
  CHECK(asked.model.subcycles.n_others == 144);
  CHECK(asked.model.subcycles.n_parts == 10);
  CHECK(asked.n_in_chunks() == 18);
  // A node of small elements alone has no place in the sums of a step.
  const auto& sums = asked.model.blocks[1].sums;
  CHECK(sums.nodes().empty());
  CHECK_FALSE(asked.model.blocks[0].sums.nodes().empty());
}

TEST_CASE("ALL finds the small elements by itself", "[core][subcycles]") {
  for (const char* all : {"all", "ALL"}) {
    const Asked asked(row_of_cubes(), {all});
    CHECK(asked.diagnostics.empty());
    CHECK(asked.model.subcycles.n_elements == 18);
    CHECK(asked.model.subcycles.n_parts == 10);
  }
}

TEST_CASE("without the line nothing is subcycled", "[core][subcycles]") {
  const Asked asked(row_of_cubes(), {});
  CHECK(asked.model.subcycles.empty());
  CHECK(asked.n_in_chunks() == 0);
}

TEST_CASE("what subcycling cannot win is told", "[core][subcycles]") {
  SECTION("no element of the named blocks is small") {
    const Asked asked(row_of_cubes(), {"left"});
    CHECK(asked.said("subcycling-idle"));
    CHECK(asked.said("no element of these blocks has a smaller stable step"));
    CHECK(asked.model.subcycles.empty());
    CHECK_FALSE(asked.diagnostics.has_errors());
  }
  SECTION("all sizes are alike") {
    const Asked asked(MeshBuilder().add_hexes({.cells = {80, 1, 1}, .size = {80, 1, 1}}).build(), {"all"});
    CHECK(asked.said("leave nothing to win"));
    CHECK(asked.model.subcycles.empty());
  }
  SECTION("small elements are nearly all there is") {
    const Asked asked(row_of_cubes(3, 3), {"flat"});
    CHECK(asked.said("farther than three layers"));
    CHECK(asked.model.subcycles.empty());
  }
  SECTION("few elements are left") {
    const Asked asked(row_of_cubes(16, 8), {"flat"});
    CHECK(asked.model.subcycles.n_others == 8);  // 10 (8 + 18) / (8 + 180) = 1.4
    CHECK_FALSE(asked.said("subcycling-idle"));
  }
}

TEST_CASE("naming all blocks leaves no step to take", "[core][subcycles]") {
  const Asked asked(row_of_cubes(), {"left", "flat", "right"});
  CHECK(asked.diagnostics.has_errors());
  CHECK(asked.said("names every block that has a stable step"));
}

TEST_CASE("a block that the mesh does not have is an error", "[core][subcycles]") {
  const Asked asked(row_of_cubes(), {"falt"});
  CHECK(asked.diagnostics.has_errors());
  CHECK(asked.model.subcycles.empty());
}
