// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "support/catch.hpp"
#include "support/sample_run.hpp"

namespace contactsim::test {

/// What a row fills a range with; numbers that it leaves are NaN.
inline std::vector<double> values_of(const SampleRun& run, const OutputRow& row, const EntityRange& range) {
  std::vector<double> values(range.count * static_cast<std::size_t>(row.n_components()), std::nan(""));
  row.fill(run.context(), range, values);
  return values;
}

/// The same of the row with a name.
inline std::vector<double> values_of(const SampleRun& run, FieldLocation location, const std::string& name,
                                     const EntityRange& range = {}) {
  for (const auto rows : {global_output_rows(), nodal_output_rows(), element_output_rows()}) {
    for (const OutputRow& row : rows) {
      if (row.name == name && row.location == location) return values_of(run, row, range);
    }
  }
  FAIL(name);
  return {};
}

inline std::vector<double> global(const SampleRun& run, const std::string& name) {
  return values_of(run, FieldLocation::global, name);
}

inline std::vector<double> nodal(const SampleRun& run, const std::string& name, std::size_t node) {
  return values_of(run, FieldLocation::node, name, {0, node, 1, {}});
}

inline std::vector<double> element(const SampleRun& run, const std::string& name, std::size_t i,
                                   std::size_t block = 0) {
  return values_of(run, FieldLocation::element, name, {block, i, 1, {}});
}

inline void check_close(const std::vector<double>& found, const std::vector<double>& expected) {
  REQUIRE(found.size() == expected.size());
  for (std::size_t i = 0; i < found.size(); ++i) CHECK(found[i] == Approx(expected[i]).margin(1e-12));
}

}  // namespace contactsim::test
