// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/base/index.hpp"

namespace contactsim {

/// Position of a pair of surfaces in ContactModel::pairs.
using PairIndex = Index<struct SurfacePairKind>;

}  // namespace contactsim
