// SPDX-License-Identifier: BSD-3-Clause
#include "contact/mesh/pair_lists.hpp"
#include "contact/interface_laws/pair_rules.hpp"

#include <random>

#include "support/catch.hpp"
#include "support/moving_boxes.hpp"

using namespace contactsim;

namespace {

template <class Lists, class Row>
concept CanAskRow = requires(const Lists& lists, Row row) {
  lists.of(row);
};
template <class Set, class First, class Second>
concept CanHold = requires(Set& set, First first, Second second) {
  set.add(first, second);
};

// Rows and partners of two kinds do not mix, nor do the two of a pair.
static_assert(CanAskRow<NodeFaceLists, SurfaceNodeIndex>);
static_assert(!CanAskRow<NodeFaceLists, FaceIndex>);
static_assert(!CanAskRow<EdgePairLists, std::uint32_t>);
static_assert(std::same_as<std::ranges::range_value_t<IndexView<FaceIndex>>, FaceIndex>);
static_assert(!std::convertible_to<FacePairLists, EdgePairLists>);
static_assert(CanHold<PairSet<PairIndex, EdgeIndex>, PairIndex, EdgeIndex>);
static_assert(!CanHold<PairSet<PairIndex, EdgeIndex>, EdgeIndex, PairIndex>);
static_assert(!CanHold<PairSet<PairIndex, EdgeIndex>, PairIndex, FaceIndex>);
static_assert(std::is_invocable_v<decltype(&PairRules::of_node), PairRules, PairIndex, SurfaceNodeIndex>);
static_assert(!std::is_invocable_v<decltype(&PairRules::of_node), PairRules, PairIndex, FaceIndex>);
static_assert(
    !std::is_invocable_v<decltype(&PairRules::of_faces), PairRules, FaceIndex, PairIndex, FaceIndex>);
static_assert(!std::is_invocable_v<decltype(&PairRules::find), PairRules, PairIndex, SurfaceIndex>);

}  // namespace

TEST_CASE("pairs are listed by row, partners ascending, rows without partners empty",
          "[contact][pair_lists]") {
  const std::vector<FoundPairs> parts = {
      {{{3, 1}, {0, 7}}, 0, 0}, {{}, 0, 0}, {{{3, 0}, {0, 2}, {3, 5}}, 0, 0}};
  PairTable lists;
  list_pairs(parts, 5, lists);
  CHECK(lists.begin == std::vector<std::uint32_t>{0, 2, 2, 2, 5, 5});
  CHECK(lists.partners == std::vector<std::uint32_t>{2, 7, 0, 1, 5});
  CHECK(lists.n_rows() == 5);
  CHECK(std::vector<std::uint32_t>(lists.of(3).begin(), lists.of(3).end()) ==
        std::vector<std::uint32_t>{0, 1, 5});
  CHECK(lists.of(4).empty());
}

TEST_CASE("lists forget what they held", "[contact][pair_lists]") {
  PairTable lists;
  list_pairs(std::vector<FoundPairs>{{{{0, 1}, {1, 2}}, 0, 0}}, 2, lists);
  list_pairs({}, 1, lists);
  CHECK(lists.begin == std::vector<std::uint32_t>{0, 0});
  CHECK(lists.partners.empty());
}

TEST_CASE("100,000 pairs come out as a sort has them", "[contact][pair_lists]") {
  std::mt19937 random(1);
  std::vector<FoundPairs> parts(7);
  std::vector<RowPartner> all;
  for (std::uint32_t i = 0; i < 100000; ++i) {
    const RowPartner pair{static_cast<std::uint32_t>(random() % 1000), i};
    parts[random() % parts.size()].pairs.push_back(pair);
    all.push_back(pair);
  }
  PairTable lists;
  list_pairs(parts, 1000, lists);
  const PairTable expected = test::in_rows(all, 1000);
  CHECK(lists.begin == expected.begin);
  CHECK(lists.partners == expected.partners);
}

TEST_CASE("lists of positions give partners by their row", "[contact][pair_lists]") {
  const auto visit = [](const auto& take) {
    take(SurfaceNodeIndex{2}, FaceIndex{4});
    take(SurfaceNodeIndex{0}, FaceIndex{7});
    take(SurfaceNodeIndex{2}, FaceIndex{9});
  };
  const auto lists = list_by_row<SurfaceNodeIndex, FaceIndex>(3, visit);
  CHECK(std::ranges::equal(lists.of({2}), std::vector<FaceIndex>{{4}, {9}}));
  CHECK(lists.of({1}).empty());
  CHECK(lists.position({2}, {9}) == 2);
  CHECK(lists.partner(lists.first_pair({0})) == FaceIndex{7});
  CHECK(lists.end_pair({2}) == 3);
  std::vector<SurfaceNodeIndex> rows;
  for (const SurfaceNodeIndex row : lists.rows()) rows.push_back(row);
  CHECK(rows == std::vector<SurfaceNodeIndex>{{0}, {1}, {2}});
}

TEST_CASE("a set of pairs goes over to other positions", "[contact][pair_set]") {
  PairSet<PairIndex, FaceIndex> set;
  CHECK(set.add({1}, {0}));
  CHECK(set.add({1}, {2}));
  CHECK(!set.add({1}, {2}));
  NewPositions<FaceIndex> faces(3);  // the first two are gone
  faces[{2}] = FaceIndex{0};
  set.remap(Unchanged{}, faces);
  CHECK(set.has({1}, {0}));
  CHECK(!set.has({1}, {2}));
  set.remove({1}, {0});
  CHECK(!set.has({1}, {0}));
}

TEST_CASE("lists of positions go over to others", "[contact][contact_remap]") {
  FacePairLists lists;  // rows 0 and 1 with 1, 2 and with 2
  lists.begin = {0, 2, 3, 3};
  lists.partners = {1, 2, 2};
  NewPositions<FaceIndex> faces(3);
  faces[{0}] = FaceIndex{1};
  faces[{2}] = FaceIndex{3};
  std::vector<std::size_t> before;
  const auto after = transferred(lists, faces, faces, 4, before);
  CHECK(after.begin == std::vector<std::uint32_t>{0, 0, 1, 1, 1});
  CHECK(after.partners == std::vector<std::uint32_t>{3});
  CHECK(before == std::vector<std::size_t>{1});
  CHECK(*number_after(faces, 2) == 3);
  CHECK(!number_after(faces, 1));
}
