// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/elastic_moduli.hpp"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace contactsim {

namespace {

/// Young's modulus and another constant.
ElasticModuli from_youngs(double e, const ElasticConstants& c) {
  if (c.poissons_ratio)
    return {e / (3.0 * (1.0 - 2.0 * *c.poissons_ratio)), e / (2.0 * (1.0 + *c.poissons_ratio))};
  if (c.shear_modulus) return {e * *c.shear_modulus / (3.0 * (3.0 * *c.shear_modulus - e)), *c.shear_modulus};
  if (c.bulk_modulus) return {*c.bulk_modulus, 3.0 * *c.bulk_modulus * e / (9.0 * *c.bulk_modulus - e)};
  const double lambda = *c.lambda;
  const double root = std::sqrt(e * e + 9.0 * lambda * lambda + 2.0 * e * lambda);
  return {(e + 3.0 * lambda + root) / 6.0, (e - 3.0 * lambda + root) / 4.0};
}

/// Poisson's ratio and another constant, not Young's modulus.
ElasticModuli from_poissons(double nu, const ElasticConstants& c) {
  if (c.shear_modulus)
    return {2.0 * *c.shear_modulus * (1.0 + nu) / (3.0 * (1.0 - 2.0 * nu)), *c.shear_modulus};
  if (c.bulk_modulus) return {*c.bulk_modulus, 3.0 * *c.bulk_modulus * (1.0 - 2.0 * nu) / (2.0 * (1.0 + nu))};
  return {*c.lambda * (1.0 + nu) / (3.0 * nu), *c.lambda * (1.0 - 2.0 * nu) / (2.0 * nu)};
}

ElasticModuli convert(const ElasticConstants& c) {
  if (c.youngs_modulus) return from_youngs(*c.youngs_modulus, c);
  if (c.poissons_ratio) return from_poissons(*c.poissons_ratio, c);
  if (!c.bulk_modulus) return {*c.lambda + 2.0 / 3.0 * *c.shear_modulus, *c.shear_modulus};
  if (!c.shear_modulus) return {*c.bulk_modulus, 1.5 * (*c.bulk_modulus - *c.lambda)};
  return {*c.bulk_modulus, *c.shear_modulus};
}

}  // namespace

ElasticModuli make_elastic_moduli(const ElasticConstants& constants) {
  const ElasticModuli moduli = convert(constants);
  const auto is_positive = [](double modulus) { return std::isfinite(modulus) && modulus > 0.0; };
  if (is_positive(moduli.bulk) && is_positive(moduli.shear)) return moduli;
  throw std::invalid_argument(fmt::format(
      "the elastic constants give a bulk modulus of {} and a shear modulus of {}; both must be positive",
      moduli.bulk, moduli.shear));
}

}  // namespace contactsim
