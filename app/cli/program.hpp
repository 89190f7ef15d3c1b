// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace contactsim {

/// The whole program: reads the command line, does what it asks for and tells the user everything that went
/// wrong.
///   argc, argv  as main takes them
/// Returns the exit code; throws nothing.
int run_program(int argc, const char* const* argv);

}  // namespace contactsim
