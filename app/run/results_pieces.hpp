// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
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
  /// [n_elements] the rank that has each element of the run's mesh
  std::shared_ptr<const std::vector<std::uint32_t>> piece_of;

  ResultsPieces(Ranks& of, std::vector<std::uint32_t> ranks_of_elements)
      : ranks(of),
        piece_of(std::make_shared<const std::vector<std::uint32_t>>(std::move(ranks_of_elements))) {}
  /// The same of a mesh with more elements, which are of the first piece.
  std::vector<std::uint32_t> pieces_of(const Mesh& mesh) const {
    std::vector<std::uint32_t> pieces = *piece_of;
    pieces.resize(mesh.n_elements(), 0);
    return pieces;
  }
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
