// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_marks.hpp"

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// Those of the marks of now that differ from what was saved.
std::vector<RunMark> changed_since(const std::vector<RunMark>& before, const std::vector<RunMark>& now) {
  StateArchive saves;
  CHECK(archive(before, saves).empty());
  const SavedState state = saves.take();
  StateArchive restores(state);
  return archive(now, restores);
}

}  // namespace

TEST_CASE("marks that are not as they were are found, new ones are not", "[app][restart]") {
  const std::vector<RunMark> before{{"the material 'a'", {}, 1u << 20}, {"the material 'b'", {}, 2u << 20}};
  CHECK(changed_since(before, before).empty());
  const auto changed = changed_since(
      before,
      {{"the material 'a'", {}, 1u << 20}, {"the material 'b'", {}, 3u << 20}, {"new", {}, 4u << 20}});
  REQUIRE(changed.size() == 1);
  CHECK(changed.front().what == "the material 'b'");
}

TEST_CASE("pairs of the same surfaces that take turns have marks of one name", "[app][restart]") {
  const std::string pair = "the contact of 'a' and 'b'";
  const std::vector<RunMark> before{{pair, {}, 1u << 20}, {pair, {}, 2u << 20}};
  CHECK(changed_since(before, before).empty());
  const auto changed = changed_since(before, {{pair, {}, 1u << 20}, {pair, {}, 3u << 20}});
  REQUIRE(changed.size() == 1);
  CHECK(changed.front().digest == 3u << 20);
}
