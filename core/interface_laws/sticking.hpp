// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "core/interface_laws/interface_law_row.hpp"

namespace contactsim {

/// STICK: what touches does not slip, and parts freely: Coulomb friction without a limit that matters.
/// Source: STICK of OptiStruct's PCONT, ROUGH friction of Abaqus.
inline InterfaceLawRow sticking() {
  InterfaceLawRow row{"stick", "What touches does not slip, and parts freely"};
  row.make = [](const InterfaceLawInput& /*input*/) -> std::optional<InterfaceLaw> {
    InterfaceLaw law;
    law.friction = 1e9;  // finite, since it is multiplied by forces that may be 0
    return law;
  };
  return row;
}

}  // namespace contactsim
