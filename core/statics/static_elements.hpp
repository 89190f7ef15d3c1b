// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/dynamics/model.hpp"

namespace contactsim {

/// Makes the elements of a model ready for load steps, before there is a state: takes off what resists rates,
/// and has shells resist drilling, which inertia does in dynamics, where their section does not say how much.
void make_static(Model& model);

}  // namespace contactsim
