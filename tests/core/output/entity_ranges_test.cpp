// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/entity_ranges.hpp"

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const ConditionLabel label{"the user output", {}};

/// Ranges of the sample run as block, first, count; errors make `errors` longer.
struct Ranges {
  using Rows = std::vector<std::array<std::size_t, 3>>;

  Rows nodes(const EntitySet& set) { return rows(find_node_ranges(set, label, scope)); }
  Rows elements(const EntitySet& set) { return rows(find_element_ranges(set, label, scope, run.model)); }
  static Rows rows(const std::vector<EntityRange>& ranges) {
    Rows rows;
    for (const EntityRange& range : ranges) rows.push_back({range.block, range.first, range.count});
    return rows;
  }

  SampleRun run;
  SimulationDefinition definition;
  Region region;
  Diagnostics errors;
  ConditionScope scope{definition, region, {}, run.mesh, errors};
};

EntitySet elements_of(const std::vector<std::int64_t>& ids) {
  EntitySet set;
  for (const std::int64_t id : ids) set.elements.push_back({id, {}});
  return set;
}

}  // namespace

TEST_CASE("a set that names nothing is the whole", "[core][output]") {
  Ranges ranges;
  CHECK(ranges.nodes({}) == Ranges::Rows{{0, 0, ranges.run.mesh.n_nodes()}});
  CHECK(ranges.elements({}) == Ranges::Rows{{0, 0, 9}, {1, 0, 2}});
}

TEST_CASE("neighbours are one range, blocks are not joined", "[core][output]") {
  Ranges ranges;
  CHECK(ranges.elements(elements_of({103, 101, 102, 109, 110})) ==
        Ranges::Rows{{0, 0, 3}, {0, 8, 1}, {1, 0, 1}});
  EntitySet nodes;
  for (const std::int64_t id : {1006, 1003, 1002}) nodes.nodes.push_back({id, {}});
  CHECK(ranges.nodes(nodes) == Ranges::Rows{{0, 1, 2}, {0, 5, 1}});
}

TEST_CASE("blocks are added and removed", "[core][output]") {
  Ranges ranges;
  EntitySet set;
  set.blocks = {{"hard", {}}};
  CHECK(ranges.elements(set) == Ranges::Rows{{1, 0, 2}});
  set.blocks.clear();
  set.removed_blocks = {{"hard", {}}};
  CHECK(ranges.elements(set) == Ranges::Rows{{0, 0, 9}});
  CHECK(ranges.errors.empty());
}

TEST_CASE("nodes and node sets hold no elements", "[core][output]") {
  Ranges ranges;
  EntitySet set;
  set.node_sets = {{"wall", {}}};
  ranges.elements(set);
  set.node_sets.clear();
  set.nodes = {{1001, {}}};
  ranges.elements(set);
  REQUIRE(ranges.errors.error_count() == 2);
  CHECK(ranges.errors.all()[0].text == "the user output: the node set wall holds no elements");
  CHECK(ranges.errors.all()[1].text == "the user output: nodes hold no elements");
}
