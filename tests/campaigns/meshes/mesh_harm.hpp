// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace contactsim::test {

/// Reads a file as a mesh and, when it is one, works with it: skin, checks of elements, stored results, a
/// results file of it that is read again, contact of all its blocks, the start of a run and a step. Says
/// which of these does not hold, "" when all do: what is refused is refused by FileError, DeckError or
/// SolveError, with the path, a text and without great memory; what is read refers only to what is there; the
/// skin is that of the slow way; what is written reads as what was read.
///   scratch  folder for the results file
std::string find_mesh_harm(const std::string& path, const std::filesystem::path& scratch);

}  // namespace contactsim::test
