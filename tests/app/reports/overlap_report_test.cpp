// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/overlap_report.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("the table of overlap removal names pairs, moves and nodes", "[app][overlap]") {
  ContactModel model;
  for (const char* name : {"lid", "box"}) model.surfaces.surfaces.emplace_back().name = name;
  model.pairs.resize(2);
  model.pairs[{1}].second = {1};
  OverlapRemoved removed;
  CHECK(format_overlap(removed, model, {}) == "\nOverlap removal: no surfaces overlap\n");
  removed.n_passes = 1;
  removed.moves.push_back({1, 8, 0.02, 0.01, {4}, 0.0});
  const std::string text = format_overlap(removed, model, {});
  CHECK(text.starts_with("\nOverlap removal in 1 pass\n"));
  CHECK(text.ends_with(
      "\n   2  lid                   box"
      "                            8            0.02          0.01          5             0\n"));
}
