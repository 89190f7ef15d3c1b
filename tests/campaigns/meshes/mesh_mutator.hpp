// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "campaigns/meshes/netcdf_model.hpp"
#include "campaigns/support/case_random.hpp"

namespace contactsim::test {

/// Changes one thing of a mesh as netCDF sees it: a dimension, a variable, its type, its shape, its values or
/// an attribute.
void mutate_model(NetcdfModel& model, CaseRandom& random);

}  // namespace contactsim::test
