// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/elastic_moduli.hpp"

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("every pair of elastic constants gives the same two moduli", "[core][materials]") {
  // Young's modulus 180, Poisson's ratio 0.25: shear 72, bulk 120, lambda 72; and an auxetic one.
  for (const double nu : {0.25, -0.3}) {
    const double e = 180.0, shear = e / (2.0 * (1.0 + nu)), bulk = e / (3.0 * (1.0 - 2.0 * nu));
    const double lambda = bulk - 2.0 / 3.0 * shear;
    const std::array<double, 5> all{e, nu, shear, bulk, lambda};
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t k = 0; k < i; ++k) {
        ElasticConstants constants;
        const std::array<std::optional<double>*, 5> places{
            &constants.youngs_modulus, &constants.poissons_ratio, &constants.shear_modulus,
            &constants.bulk_modulus, &constants.lambda};
        *places[i] = all[i];
        *places[k] = all[k];
        CHECK(constants.n_given() == 2);
        const ElasticModuli moduli = make_elastic_moduli(constants);
        INFO(i << " " << k << " " << nu);
        CHECK(moduli.bulk == Approx(bulk).epsilon(1e-12));
        CHECK(moduli.shear == Approx(shear).epsilon(1e-12));
      }
    }
  }
  const ElasticModuli moduli{120.0, 72.0};
  CHECK(moduli.youngs() == Approx(180.0));
  CHECK(moduli.lambda() == Approx(72.0));
  CHECK(moduli.p_wave() == Approx(216.0));
}

TEST_CASE("constants without a stable rest are refused with the moduli that they give", "[core][materials]") {
  const auto refusal = [](const ElasticConstants& constants) -> std::string {
    try {
      make_elastic_moduli(constants);
    } catch (const std::invalid_argument& problem) {
      return problem.what();
    }
    return "";
  };
  CHECK(refusal({100.0, {}, 20.0, {}, {}}) ==
        "the elastic constants give a bulk modulus of -16.666666666666668 and a shear modulus of 20; both "
        "must be "
        "positive");
  CHECK(refusal({{}, {}, {}, 1.0, 2.0}) ==
        "the elastic constants give a bulk modulus of 1 and a shear modulus of -1.5; both must be positive");
  CHECK(refusal({9.0, {}, {}, 1.0, {}}) != "");   // an infinite shear modulus
  CHECK(refusal({{}, 0.0, {}, {}, 0.0}) != "");   // which says nothing of the size
  CHECK(refusal({9.0, {}, {}, {}, -1.0}) == "");  // auxetic, but stable
}
