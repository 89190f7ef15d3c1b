// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <iterator>

#include "core/output/reduction.hpp"
#include "core/output/single_values.hpp"
#include "support/catch.hpp"
#include "support/sample_run.hpp"
#include "support/stiffened_bar.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using L = VariableLocation;

VariableRequest at(VariableRequest request, std::int64_t id) {
  request.place = SingleEntity{id, {}};
  return request;
}

}  // namespace

TEST_CASE("single values come from the ranks that know them", "[core][output]") {
  const StiffenedBar bar;
  const OutputVariables variables(bar.model);
  std::vector<VariableRequest> requests{request(L::global, "kinetic_energy"), request(L::global, "momentum")};
  for (const std::int64_t id : {1, 700, 1300, 2000}) {
    requests.push_back(at(request(L::nodal, "velocity"), id));
    requests.push_back(at(request(L::element, "von_mises"), id));
  }
  Diagnostics diagnostics;
  const State alone = bar.run(nullptr, 5);
  RequestedFields fields = make_single_values(variables, requests, "_", diagnostics);
  REQUIRE(diagnostics.all().empty());
  const std::vector<double> expected = evaluate_all(fields, {bar.model, alone});
  REQUIRE(std::ranges::count(expected, 0.0) == 0);
  constexpr int count = 3;
  std::vector<std::vector<double>> found(count);
  bool has_unknown = false;
  ThreadRanks(count).run([&](Ranks& ranks) {
    RequestedFields of_rank = make_single_values(variables, requests, "_", diagnostics);
    const RankShare share(ranks, bar.model, bar.followed_everywhere());
    const State state = bar.run(&ranks, 5, false);
    if (ranks.is_root()) has_unknown = evaluate_all(of_rank, {bar.model, state}) != expected;
    found[static_cast<std::size_t>(ranks.rank())] = evaluate_all(of_rank, {bar.model, state, &share});
  });
  CHECK(has_unknown);
  for (const std::vector<double>& of_rank : found) CHECK(of_rank == expected);
}

TEST_CASE("reductions over nodes and elements have the bits of one process", "[core][output]") {
  const StiffenedBar bar;
  const OutputVariables variables(bar.model);
  Diagnostics diagnostics;
  const State alone = bar.run(nullptr, 5);
  struct Reduced {
    VariableSelection selection;
    std::vector<EntityRange> ranges;
  };
  const auto find = [&](L location, const char* name) {
    return find_selection(variables, location, request(location, name).variable, diagnostics).value();
  };
  // Ranges that begin and end within what one rank knows, and those of all.
  const std::vector<Reduced> all{
      {find(L::nodal, "velocity"), {{0, 0, bar.mesh.n_nodes(), {}}}},
      {find(L::nodal, "velocity"), {{0, 3, 1, {}}, {0, 700, 1400, {}}}},
      {find(L::element, "von_mises"), {{0, 0, bar.model.blocks[0].n_elements, {}}, {1, 5, 800, {}}}}};
  const auto sum_up = [&](const OutputContext& context) {
    std::vector<double> results;
    for (const Reduced& one : all) {
      for (const auto kind : {OutputReduction::sum, OutputReduction::maximum, OutputReduction::variance})
        std::ranges::copy(reduce(kind, one.selection, one.ranges, context), std::back_inserter(results));
    }
    return results;
  };
  const std::vector<double> expected = sum_up({bar.model, alone});
  constexpr int count = 3;
  std::vector<std::vector<double>> found(count);
  ThreadRanks(count).run([&](Ranks& ranks) {
    const RankShare share(ranks, bar.model, bar.followed_everywhere());
    const State state = bar.run(&ranks, 5, false);
    found[static_cast<std::size_t>(ranks.rank())] = sum_up({bar.model, state, &share});
  });
  for (const std::vector<double>& of_rank : found) CHECK(of_rank == expected);
}
