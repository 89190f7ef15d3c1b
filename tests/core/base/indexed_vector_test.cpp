// SPDX-License-Identifier: BSD-3-Clause
#include "core/base/indexed_vector.hpp"

#include <concepts>

#include "core/base/contact_indices.hpp"
#include "core/base/indices.hpp"
#include "core/base/optional_index.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

using OtherIndex = Index<struct OtherKind>;
using PairNumbers = IndexedVector<PairIndex, double>;
using OtherNumbers = IndexedVector<OtherIndex, double>;

template <class Values, class AnIndex>
concept CanAsk = requires(const Values& values, AnIndex index) {
  values[index];
};
template <class A, class B>
concept CanCompare = requires(A a, B b) {
  a == b;
};

// Positions of two kinds, and numbers that are none, do not mix.
static_assert(CanAsk<PairNumbers, PairIndex>);
static_assert(!CanAsk<PairNumbers, OtherIndex>);
static_assert(!CanAsk<PairNumbers, NodeIndex>);
static_assert(!CanAsk<PairNumbers, std::uint32_t>);
static_assert(!CanAsk<PairNumbers, OptionalIndex<PairIndex>>);
static_assert(CanAsk<IndexedSpan<PairIndex, const double>, PairIndex>);
static_assert(!CanAsk<IndexedSpan<PairIndex, const double>, OtherIndex>);
static_assert(CanCompare<PairIndex, PairIndex>);
static_assert(!CanCompare<PairIndex, OtherIndex>);
static_assert(!CanCompare<PairIndex, std::uint32_t>);
static_assert(CanCompare<OptionalIndex<PairIndex>, PairIndex>);
static_assert(!CanCompare<OptionalIndex<PairIndex>, OtherIndex>);
static_assert(!std::constructible_from<PairIndex, OtherIndex>);
static_assert(!std::convertible_to<std::uint32_t, PairIndex>);
static_assert(!std::convertible_to<PairIndex, std::uint32_t>);
static_assert(!std::constructible_from<OptionalIndex<PairIndex>, OptionalIndex<OtherIndex>>);
static_assert(!std::constructible_from<PairNumbers, OtherNumbers>);
static_assert(!std::constructible_from<IndexedSpan<PairIndex, const double>, const OtherNumbers&>);
static_assert(!std::constructible_from<IndexedSpan<PairIndex, double>, const PairNumbers&>);
// They cost nothing.
static_assert(sizeof(PairIndex) == sizeof(std::uint32_t));
static_assert(sizeof(OptionalIndex<PairIndex>) == sizeof(std::uint32_t));
static_assert(sizeof(PairNumbers) == sizeof(std::vector<double>));

}  // namespace

TEST_CASE("a vector is asked by its own positions, in order", "[core][indexed_vector]") {
  PairNumbers numbers{0.5, 1.5};
  CHECK(numbers.next() == PairIndex{2});
  numbers.push_back(2.5);
  for (const PairIndex pair : indices(numbers)) {
    CHECK(numbers[pair] == 0.5 + pair.value);
    numbers[pair] = -1.0 * pair.value;
  }
  const IndexedSpan<PairIndex, const double> view = numbers;
  CHECK(view[{2}] == -2.0);
  CHECK(indices(view).size() == 3);
  CHECK(index_of(view, std::ranges::find(view, -1.0)) == PairIndex{1});
  CHECK(indices(PairNumbers()).size() == 0);
}

TEST_CASE("positions from one up to before another", "[core][indexed_vector]") {
  std::vector<PairIndex> passed;
  for (const PairIndex pair : IndexRange(PairIndex{3}, PairIndex{5})) passed.push_back(pair);
  CHECK(passed == std::vector{PairIndex{3}, PairIndex{4}});
}

TEST_CASE("a typed position may be absent", "[core][optional_index]") {
  OptionalIndex<PairIndex> pair;
  CHECK(!pair);
  pair = PairIndex{0};
  REQUIRE(pair.has_value());
  CHECK(*pair == PairIndex{0});
  CHECK(pair == PairIndex{0});
  CHECK(pair != PairIndex{1});
}
