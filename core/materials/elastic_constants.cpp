// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/elastic_constants.hpp"

namespace contactsim {

const std::vector<Parameter>& elastic_parameters() {
  static const std::vector<Parameter> parameters{
      parameter::positive("youngs modulus", "Young's modulus [force/length^2]"),
      parameter::poissons_ratio("poissons ratio", "Poisson's ratio [1]"),
      parameter::positive("shear modulus", "Shear modulus [force/length^2]"),
      parameter::positive("bulk modulus", "Bulk modulus [force/length^2]"),
      parameter::real("lambda", "Lame's first constant [force/length^2]"),
      parameter::positive("two mu", "Twice the shear modulus [force/length^2]")
          .for_other("shear modulus", 0.5),
  };
  return parameters;
}

ElasticConstants elastic_constants_of(const ParameterValues& values) {
  return {values.find_real("youngs modulus"), values.find_real("poissons ratio"),
          values.find_real("shear modulus"), values.find_real("bulk modulus"), values.find_real("lambda")};
}

}  // namespace contactsim
