// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "campaigns/support/case_random.hpp"

namespace contactsim::test {

/// Changes bytes of a netCDF file where its structure is: numbers in a classic header, what stands behind the
/// signatures of HDF5; sometimes anywhere, or its length.
void mutate_bytes(std::string& bytes, CaseRandom& random);

}  // namespace contactsim::test
