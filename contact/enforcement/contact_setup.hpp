// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "contact/mesh/contact_model.hpp"
#include "core/definition/contact.hpp"
#include "core/definition/declarations.hpp"
#include "core/definition/function.hpp"
#include "core/definition/time_control.hpp"
#include "core/dynamics/model.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// What contact is made of in a run.
struct ContactSetup {
  const ContactDefinition& definition;
  const ContactModel& contact;
  const Model& model;
  std::span<const TimeSteppingBlock> time_stepping_blocks;  ///< the periods of the procedure
  std::span<const FunctionDefinition> functions = {};       ///< that friction models name
  Ranks& ranks = one_rank();                                ///< which detect contact points together

  /// Of load steps, which no mass has a part in.
  bool is_static() const { return definition.enforcement.is_static; }
};

}  // namespace contactsim
