// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/split_file.hpp"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>
#include <utility>

#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"
#include "io/decompose/file_layout.hpp"
#include "io/decompose/piece_layout.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/files/open_file_limit.hpp"
#include "io/netcdf/netcdf_output.hpp"

namespace contactsim {

namespace {

void check_can_be_divided(const ExodusFile& file, const Mesh& mesh, std::size_t n_pieces) {
  constexpr std::array<std::pair<const char*, const char*>, 4> undivided{{{"num_ed_blk", "edge blocks"},
                                                                          {"num_fa_blk", "face blocks"},
                                                                          {"num_edge_sets", "edge sets"},
                                                                          {"num_face_sets", "face sets"}}};
  for (const auto& [dimension, what] : undivided) {
    if (const std::size_t n = file.dimension(dimension); n > 0)
      file.fail(fmt::format("has {} {}, which cannot be divided", n, what));
  }
  if (n_pieces < 1 || (n_pieces > 1 && n_pieces > mesh.n_elements()))
    file.fail(fmt::format("has {}, which cannot be divided among {} pieces",
                          pluralize(mesh.n_elements(), "element"), n_pieces));
}

PieceFiles name_new_pieces(const ExodusFile& file, std::size_t n_pieces) {
  const auto old = find_pieces(file.path());
  PieceFiles files = name_pieces(old ? old->base : file.path(), n_pieces);
  std::error_code ignored;
  for (std::size_t piece = 0; piece < n_pieces; ++piece) {
    if (std::filesystem::exists(files.path(piece), ignored))
      throw FileError(files.path(piece), "is there already; remove the pieces of before first");
  }
  return files;
}

/// One piece as it is written.
struct NewPiece {
  PieceLayout layout;
  std::unique_ptr<NetcdfOutput> output;

  NewPiece(const WholeFile& whole, const std::string& path, std::uint32_t piece)
      : layout(make_piece_layout(whole, piece)),
        output(std::make_unique<NetcdfOutput>(path, needs_large_file(layout.layout))) {
    output->define(layout.layout);
    output->end_definitions();
  }

  bool takes(const std::string& variable) const {
    return !layout.made.contains(variable) && find(variable).has_value();
  }

  std::optional<int> find(const std::string& variable) const {
    const NetcdfDefinition* found = layout.layout.find_variable(variable);
    return found == nullptr ? std::nullopt
                            : std::optional(static_cast<int>(found - layout.layout.variables.data()));
  }

  void write(const std::string& variable, std::optional<std::size_t> record, const NetcdfValues& values) {
    if (const auto id = find(variable)) output->write(*id, record, values);
  }
};

/// Rows of texts in another width, which is not smaller.
NetcdfValues widen_texts(const NetcdfValues& values, std::size_t from, std::size_t to) {
  const auto& rows = std::get<std::vector<char>>(values);
  std::vector<char> wide(rows.size() / from * to, '\0');
  for (std::size_t i = 0; i < rows.size(); ++i) wide[i / from * to + i % from] = rows[i];
  return wide;
}

void write_part(const WholeFile& whole, const NetcdfDefinition& variable, std::optional<std::size_t> record,
                NetcdfValues values, NewPiece& piece) {
  if (variable.type == NetcdfType::text && !variable.dimensions.empty()) {
    const std::string& width = variable.dimensions.back();
    const std::size_t here = piece.layout.layout.length(width), there = whole.layout.length(width);
    // Names of further maps may need more room than names had.
    if (width == "len_name" && here != there) values = widen_texts(values, there, here);
  }
  piece.write(name_in_piece(variable), record, values);
}

void write_variable(const WholeFile& whole, const NetcdfDefinition& variable, std::vector<NewPiece>& pieces) {
  const std::string name = name_in_piece(variable);
  const bool has_records = is_record(whole.layout, variable);
  read_in_parts(whole.file, variable, has_records,
                [&](std::optional<std::size_t> record, const NetcdfValues& values) {
                  for (std::uint32_t piece = 0; piece < pieces.size(); ++piece) {
                    if (pieces[piece].takes(name))
                      write_part(whole, variable, record,
                                 take_part(whole, variable, has_records, values, piece), pieces[piece]);
                  }
                });
}

void commit_all(std::vector<NewPiece>& pieces, const PieceFiles& files) {
  std::size_t n_done = 0;
  try {
    for (; n_done < pieces.size(); ++n_done) pieces[n_done].output->commit();
  } catch (...) {
    std::error_code ignored;
    for (std::size_t piece = 0; piece < n_done; ++piece) std::filesystem::remove(files.path(piece), ignored);
    throw;
  }
}

std::vector<WrittenPiece> write_pieces(const ExodusFile& file, const MeshDivision& division,
                                       const PieceFiles& files) {
  const auto n_pieces = static_cast<std::uint32_t>(files.count);
  const WholeFile whole{file, make_writable(file.layout()), division, n_pieces};
  allow_open_files(n_pieces);
  std::vector<NewPiece> pieces;
  for (std::uint32_t piece = 0; piece < n_pieces; ++piece)
    pieces.emplace_back(whole, files.path(piece), piece);
  for (NewPiece& piece : pieces) {
    for (const auto& [variable, values] : piece.layout.made) piece.write(variable, std::nullopt, values);
  }
  for (const NetcdfDefinition& variable : whole.layout.variables) write_variable(whole, variable, pieces);
  commit_all(pieces, files);
  std::vector<WrittenPiece> written;
  for (std::size_t piece = 0; piece < n_pieces; ++piece)
    written.push_back({files.path(piece), pieces[piece].layout.layout.length("num_nodes"),
                       pieces[piece].layout.layout.length("num_elem")});
  return written;
}

/// The mesh of a file that is divided, if its elements are known. Warnings of what a run leaves out are
/// dropped: pieces have all.
Mesh read_whole_mesh(const ExodusFile& file) {
  Diagnostics discarded;
  Mesh mesh = read_mesh(file.path(), discarded);
  for (const ElementBlock& block : mesh.blocks()) {
    if (block.shape == Shape::unknown && block.n_elements > 0)
      file.fail(fmt::format("block {}: elements of type '{}' cannot be divided", block.id, block.type_name));
  }
  return mesh;
}

}  // namespace

std::vector<WrittenPiece> split_file(const std::string& path, std::size_t n_pieces) {
  const ExodusFile file(path);
  const Mesh mesh = read_whole_mesh(file);
  check_can_be_divided(file, mesh, n_pieces);
  const auto n = static_cast<std::uint32_t>(n_pieces);
  const MeshDivision division = divide_mesh(mesh, file, bisect_elements(mesh, n), n);
  return write_pieces(file, division, name_new_pieces(file, n_pieces));
}

void split_file(const std::string& path, const PieceFiles& files, std::span<const std::uint32_t> piece_of) {
  const ExodusFile file(path);
  const Mesh mesh = read_whole_mesh(file);
  std::vector<std::uint32_t> pieces(piece_of.begin(), piece_of.end());
  pieces.resize(mesh.n_elements(), 0);
  const auto n = static_cast<std::uint32_t>(files.count);
  write_pieces(file, divide_mesh(mesh, file, std::move(pieces), n), files);
}

}  // namespace contactsim
