// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/shell_settings.hpp"

#include <cmath>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// The mean of place^power over the thickness.
double moment(const std::vector<ShellLayer>& layers, int power) {
  double sum = 0.0;
  for (const ShellLayer& layer : layers) sum += layer.weight * std::pow(layer.place, power);
  return sum;
}

}  // namespace

TEST_CASE("rules of integration are exact for the powers that theory says they are", "[core][shells]") {
  for (std::int64_t n = 1; n <= 9; ++n) {
    INFO(n << " points");
    for (int power = 0; power <= 2 * n - 1; ++power)
      CHECK(moment(make_layers("gauss", n), power) ==
            Approx(power % 2 == 0 ? 1.0 / (power + 1.0) : 0.0).margin(1e-14));
    for (int power = 0; n > 1 && power <= 2 * n - 3; ++power)
      CHECK(moment(make_layers("Lobatto", n), power) ==
            Approx(power % 2 == 0 ? 1.0 / (power + 1.0) : 0.0).margin(1e-14));
    if (n < 3) continue;
    CHECK(moment(make_layers("trapezoid", n), 0) == Approx(1.0));
    CHECK(moment(make_layers("trapezoid", n), 2) == Approx(1.0 / 3.0));
    if (n % 2 == 1) CHECK(moment(make_layers("simpsons", n), 2) == Approx(1.0 / 3.0));
  }
}

TEST_CASE("layers stand from bottom to top; what a rule does not have is empty", "[core][shells]") {
  for (const std::string_view rule : layer_rules()) {
    const auto layers = make_layers(rule, 5);
    REQUIRE(layers.size() == 5);
    for (std::size_t i = 0; i + 1 < 5; ++i) CHECK(layers[i].place < layers[i + 1].place);
    for (std::size_t i = 0; i < 5; ++i) {
      CHECK(layers[i].weight > 0.0);
      CHECK(layers[i].place == Approx(-layers[4 - i].place).margin(1e-15));
    }
  }
  const auto trapezoid = make_layers("trapezoid", 3);
  CHECK(trapezoid[0].weight == Approx(1.0 / 6.0));  // Simpson's
  CHECK(make_layers("lobatto", 1).empty());
  CHECK(make_layers("simpsons", 4).empty());
  CHECK(make_layers("gauss", 0).empty());
  CHECK(make_layers("user", 3).empty());
}
