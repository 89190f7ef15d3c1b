// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/elastic_constants.hpp"

#include <algorithm>

#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("constants of a model are those that it gives, twice the shear modulus by half",
          "[core][materials]") {
  ParameterValues values(elastic_parameters());
  CHECK(elastic_constants_of(values).n_given() == 0);
  values.set("youngs modulus", 200.0);
  values.set("lambda", -3.0);
  ElasticConstants constants = elastic_constants_of(values);
  CHECK(constants.n_given() == 2);
  CHECK(constants.youngs_modulus == 200.0);
  CHECK(constants.lambda == -3.0);
  CHECK_FALSE(constants.poissons_ratio);
  values.set("poissons ratio", 0.25);
  values.set("shear modulus", 80.0);
  values.set("bulk modulus", 160.0);
  constants = elastic_constants_of(values);
  CHECK(constants.n_given() == 5);
  CHECK(constants.poissons_ratio == 0.25);
  CHECK(constants.shear_modulus == 80.0);
  CHECK(constants.bulk_modulus == 160.0);
  const auto twice = std::ranges::find(elastic_parameters(), std::string("two mu"), &Parameter::phrase);
  REQUIRE(twice != elastic_parameters().end());
  CHECK(twice->stands_for == "shear modulus");
  CHECK(twice->factor == 0.5);
}
