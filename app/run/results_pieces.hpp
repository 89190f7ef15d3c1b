// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

#include "core/output/output_writers.hpp"
#include "core/parallel/ranks.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/pieces/piece_files.hpp"

namespace contactsim {

/// How the ranks of a run write results in pieces, each its own.
struct ResultsPieces {
  Ranks& ranks;
  std::vector<std::uint32_t> piece_of;  ///< [n_elements] the rank that has each element of the run's mesh

  ResultsPieces(Ranks& of, std::vector<std::uint32_t> ranks_of_elements)
      : ranks(of), piece_of(std::move(ranks_of_elements)) {}
};

/// The names of the pieces of a results file, <path>.P.r.
PieceFiles name_results_pieces(const ResultsPieces& pieces, const ResultsFile& file);

/// Makes the pieces of a results file, which replace older ones, and opens that of this rank. All ranks call
/// it and append alike.
///   mesh  that of the run, to which elements may be added: they are of the first piece
/// Throws FileError, on all ranks.
OutputWriters::OpenResults open_results_piece(const ResultsPieces& pieces, const ResultsFile& file,
                                              const Mesh& mesh, const ResultsText& text,
                                              std::span<const OutputField> fields);

}  // namespace contactsim
