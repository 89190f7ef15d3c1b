// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>

#include "app/run/results_pieces.hpp"
#include "core/output/output_writers.hpp"

namespace contactsim {

/// Opens a results file that rank 0 writes: each rank gives the values of its piece, and rank 0 puts them
/// together field by field. All ranks call it and append alike.
///   open  opens the file; called on rank 0
/// Throws FileError, on all ranks.
OutputWriters::OpenResults open_gathered_results(const ResultsPieces& pieces, const Mesh& mesh,
                                                 std::span<const OutputField> fields,
                                                 const std::function<OutputWriters::OpenResults()>& open);

}  // namespace contactsim
