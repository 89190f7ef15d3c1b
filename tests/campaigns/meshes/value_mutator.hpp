// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "campaigns/meshes/netcdf_model.hpp"
#include "campaigns/support/case_random.hpp"

namespace contactsim::test {

/// One value becomes hostile, or another one's, or all are one, or their order is turned.
void change_values(NetcdfValues& values, CaseRandom& random);

/// Another type; numbers stay what they are where both types have them.
void change_type(NetcdfValues& values, CaseRandom& random);

/// One attribute goes, or gets another value, type or length; a list without any gets one.
void change_attribute(std::vector<NetcdfAttribute>& attributes, CaseRandom& random);

}  // namespace contactsim::test
