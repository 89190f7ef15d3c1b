// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/compare/comparison.hpp"
#include "app/compare/input_kind.hpp"

namespace contactsim {

/// A file that is to be compared.
struct ComparedFile {
  std::string path, text;
  InputKind kind;
};

/// Reads a file and sees what it is. Throws FileError.
ComparedFile read_compared_file(const std::string& path);

/// How to compare.
struct ComparisonSettings {
  Tolerance tolerance;
  bool lists_faces = false;  ///< tell each facet of another owner
};

/// What differs between two files of one kind, decks aside. Throws FileError when one is not as it should be,
/// when they are of different kinds, or when their kind has no facets to list.
FileComparison compare_files(const ComparedFile& first, const ComparedFile& second,
                             const ComparisonSettings& settings);

}  // namespace contactsim
