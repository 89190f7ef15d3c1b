// SPDX-License-Identifier: BSD-3-Clause
// A deck of 20,000 lines with 2,000 contact surfaces, from text to definition tree.
#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "parser/deck.hpp"

namespace contactsim::bench {

namespace {

/// Per surface: the surface, a friction model and an interaction of 4 and 5 lines.
std::string make_deck(int n_surfaces) {
  std::string text = "begin contact definition\n";
  for (int i = 1; i <= n_surfaces; ++i) {
    text += fmt::format("  contact surface s{0} contains block_{0} surface_{0}  # part {0}\n", i);
    text +=
        fmt::format("  begin constant friction model mu{0}\n    friction coefficient = 0.{0}\n  end\n", i);
    text += fmt::format(
        "  begin interaction i{0}\n    surfaces = s{0} s{1}\n    friction model = mu{0}\n    normal "
        "tolerance = 1.0e-3\n"
        "    constraint formulation = face_face\n  end interaction i{0}\n",
        i, i == 1 ? 2 : i - 1);
  }
  return text + "end\n";
}

void deck_of_20000_lines(benchmark::State& state) {
  const std::string text = make_deck(2000);
  for (auto _ : state) {
    Diagnostics diagnostics;
    const SimulationDefinition definition = parse_deck_text("bench.i", text, {}, diagnostics);
    if (!diagnostics.empty()) state.SkipWithError("the deck has problems");
    benchmark::DoNotOptimize(definition.procedures.data());
  }
  state.counters["lines"] = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
}
BENCHMARK(deck_of_20000_lines)->Unit(benchmark::kMillisecond)->UseRealTime();

}  // namespace

}  // namespace contactsim::bench
