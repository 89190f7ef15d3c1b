// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/optional_index.hpp"

#include <vector>

#include "core/base/state_archive.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a position is absent until it is given", "[core][optional_index]") {
  OptionalIndex<std::uint32_t> index;
  CHECK(!index);
  CHECK(index == std::nullopt);
  index = 0;
  CHECK(index.has_value());
  CHECK(*index == 0);
  CHECK(index == 0u);
  CHECK(index != OptionalIndex<std::uint32_t>(1));
  index = std::nullopt;
  CHECK(!index.has_value());
}

TEST_CASE("a restart brings positions back, absent ones too", "[core][optional_index]") {
  std::vector<OptionalIndex<std::uint32_t>> positions{3, std::nullopt, 0}, restored;
  StateArchive saving;
  saving.list("positions", positions);
  const SavedState saved = saving.take();
  StateArchive restoring(saved);
  restoring.list("positions", restored);
  CHECK(restored == positions);
}
