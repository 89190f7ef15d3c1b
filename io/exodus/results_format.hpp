// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>

#include "core/mesh/mesh.hpp"
#include "core/mesh/output_field.hpp"
#include "io/exodus/exodus_draft.hpp"

namespace contactsim {

/// The sizes that decide how a results file is stored.
struct ResultsSizes {
  std::size_t n_variable_bytes = 0;  ///< of the largest variable, or of one record of it
  std::int64_t largest_id = 0;
  std::size_t longest_name = 0;
};

/// The sizes of a mesh and of the fields that will be written with it.
ResultsSizes find_results_sizes(const Mesh& mesh, std::span<const OutputField> fields);

/// CDF-2 as long as it can hold the file, CDF-5 beyond.
ExodusFormat choose_format(const ResultsSizes& sizes);

}  // namespace contactsim
