// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/reduction.hpp"

#include <array>
#include <cmath>
#include <limits>

#include "support/catch.hpp"
#include "support/sample_run.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using R = OutputReduction;
constexpr std::array all_reductions{R::sum,     R::maximum, R::minimum, R::average, R::absolute_maximum,
                                    R::l2_norm, R::variance};

/// What becomes of the numbers, one of each node.
double reduced(R reduction, const std::vector<double>& numbers) {
  const SampleRun run;
  const OutputVariable variable{
      "numbers",
      FieldLocation::node,
      FieldShape::scalar,
      1,
      false,
      {},
      [&](const OutputContext&, const EntityRange& range, std::span<double> values) {
        for (std::size_t i = 0; i < range.count; ++i) values[i] = numbers[range.first + i];
      }};
  const EntityRange range{0, 0, numbers.size(), {}};
  return reduce(reduction, {&variable, {}, {}}, {&range, 1}, run.context()).at(0);
}

}  // namespace

TEST_CASE("many values become one", "[core][output]") {
  const std::vector<double> numbers{3, -5, 1, 1};
  CHECK(reduced(R::sum, numbers) == 0);
  CHECK(reduced(R::maximum, numbers) == 3);
  CHECK(reduced(R::minimum, numbers) == -5);
  CHECK(reduced(R::average, numbers) == 0);
  CHECK(reduced(R::absolute_maximum, numbers) == 5);
  CHECK(reduced(R::l2_norm, numbers) == 6);
  CHECK(reduced(R::variance, numbers) == 9);
}

TEST_CASE("the variance of values far from zero keeps its digits", "[core][output]") {
  CHECK(reduced(R::variance, {1e9 + 1, 1e9 + 2, 1e9 + 3}) == Approx(2.0 / 3.0).epsilon(1e-9));
}

TEST_CASE("of nothing the sums are 0 and the rest is no number", "[core][output]") {
  CHECK(reduced(R::sum, {}) == 0);
  CHECK(reduced(R::l2_norm, {}) == 0);
  for (const R reduction : {R::maximum, R::minimum, R::average, R::absolute_maximum, R::variance})
    CHECK(std::isnan(reduced(reduction, {})));
}

TEST_CASE("a value that is no number is not passed over, wherever it stands", "[core][output]") {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const R reduction : all_reductions) {
    CHECK(std::isnan(reduced(reduction, {nan, 1, 2})));
    CHECK(std::isnan(reduced(reduction, {1, 2, nan})));
  }
}

TEST_CASE("long ranges come in parts, blocks without the variable are left out", "[core][output]") {
  SampleRun run;
  run.model.blocks[0].n_elements = 40000;
  const OutputVariable in_first{"n",
                                FieldLocation::element,
                                FieldShape::scalar,
                                1,
                                false,
                                {1, 0},
                                [](const OutputContext&, const EntityRange& range, std::span<double> values) {
                                  for (std::size_t i = 0; i < range.count; ++i)
                                    values[i] = static_cast<double>(range.first + i);
                                }};
  const std::vector<EntityRange> ranges{{0, 5, 39995, {}}, {1, 0, 2, {}}};
  std::size_t n_visits = 0, next = 5, n_wrong = 0;
  visit_values({&in_first, {}, {}}, ranges, run.context(),
               [&](const EntityRange& part, std::span<const double> values) {
                 ++n_visits;
                 n_wrong += part.block != 0 || part.first != next || values.size() != part.count;
                 for (const double value : values) n_wrong += value != static_cast<double>(next++);
               });
  CHECK(n_wrong == 0);
  CHECK(next == 40000);
  CHECK(n_visits == 3);
}
