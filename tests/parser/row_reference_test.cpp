// SPDX-License-Identifier: BSD-3-Clause
#include "parser/row_reference.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

const TreeRow& find_row(const std::string& block, const std::string& phrase) {
  return *std::find_if(command_tree().begin(), command_tree().end(), [&](const TreeRow& entry) {
    return entry.row->phrase == phrase && !entry.around.empty() && entry.around.back()->phrase == block;
  });
}

}  // namespace

TEST_CASE("a row's reference has its form, place, dimension, default and choice", "[parser][rows]") {
  const TreeRow& friction = find_row("constant friction model", "friction coefficient");
  const RowReference row = reference_of(friction);
  CHECK(row.form == "FRICTION COEFFICIENT = <real >= 0>");
  CHECK(row.help.substr(0, 19) == "Coulomb coefficient");
  CHECK(row.dimension == "1");
  CHECK(row.default_text == "0");
  CHECK(row.support == "supported");
  CHECK(place_of(friction) ==
        "sierra > presto procedure > presto region > contact definition > constant friction model");
  const RowReference periods = reference_of(find_row("contact definition", "active periods"));
  CHECK(periods.choice == "at most one of ACTIVE PERIODS or INACTIVE PERIODS");
  CHECK(periods.names == std::vector<std::string>{"a time stepping block"});
}
