// SPDX-License-Identifier: BSD-3-Clause
#include "parser/region_names.hpp"

namespace contactsim {

void resolve_region_names(const Region&, OutsideNames&, Diagnostics&) {}

}  // namespace contactsim
