// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/results_pieces.hpp"

#include <filesystem>
#include <memory>
#include <utility>

#include "app/run/file_clashes.hpp"
#include "core/mesh/mesh_piece.hpp"
#include "core/parallel/on_root.hpp"
#include "io/decompose/split_file.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

std::vector<std::uint32_t> in_order_of_file(const Mesh& mesh, std::span<const std::uint32_t> piece_of) {
  std::vector<std::uint32_t> by_place(piece_of.size());
  for (std::uint32_t element = 0; element < piece_of.size(); ++element)
    by_place[mesh.element_place({element})] = piece_of[element];
  return by_place;
}

/// Makes all pieces without a step: of the whole file, which is there for that alone.
void make_pieces(const PieceFiles& files, const ResultsFile& file, const Mesh& mesh, const ResultsText& text,
                 std::span<const OutputField> fields, std::span<const std::uint32_t> piece_of) {
  for (std::size_t piece = 0; piece < files.count; ++piece)
    refuse_to_replace(files.path(piece), file.overwrites);
  const std::string whole = files.path(0) + ".whole";
  { const ResultsWriter without_steps(whole, mesh, text, fields); }
  try {
    split_file(whole, files, in_order_of_file(mesh, piece_of));
  } catch (...) {
    std::error_code ignored;
    fs::remove(whole, ignored);
    throw;
  }
  fs::remove(whole);
}

}  // namespace

PieceFiles name_results_pieces(const ResultsPieces& pieces, const ResultsFile& file) {
  return name_pieces(file.path, static_cast<std::size_t>(pieces.ranks.count()));
}

OutputWriters::OpenResults open_results_piece(const ResultsPieces& pieces, const ResultsFile& file,
                                              const Mesh& mesh, const ResultsText& text,
                                              std::span<const OutputField> fields) {
  Ranks& ranks = pieces.ranks;
  const PieceFiles files = name_results_pieces(pieces, file);
  const std::vector<std::uint32_t> piece_of = pieces.pieces_of(mesh);
  on_root(ranks, [&] { make_pieces(files, file, mesh, text, fields, piece_of); });
  const auto rank = static_cast<std::uint32_t>(ranks.rank());
  const auto piece = std::make_shared<const MeshPiece>(find_piece(mesh, piece_of, rank));
  std::shared_ptr<ResultsWriter> writer;
  std::shared_ptr<FileLock> lock;
  on_each(ranks, [&] {
    lock = lock_output(files.path(rank));
    writer = std::make_shared<ResultsWriter>(files.path(rank), *piece, mesh, fields);
  });
  return {[&ranks, writer, lock](double time, const OutputWriters::FieldValues& values) {
            on_each(ranks, [&] { writer->write_step(time, values); });
          },
          piece};
}

}  // namespace contactsim
