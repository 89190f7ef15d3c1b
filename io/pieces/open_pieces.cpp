// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/open_pieces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>

#include "core/base/errors.hpp"
#include "io/files/open_file_limit.hpp"
#include "io/netcdf/read_layout.hpp"
#include "io/pieces/divided_axis.hpp"

namespace contactsim {

namespace {

/// Dimensions that the pieces of one file have in common.
constexpr std::array common_dimensions{
    "num_dim",       "num_nodes_global", "num_elems_global", "num_el_blk",  "num_node_sets", "num_side_sets",
    "num_elem_sets", "num_nod_var",      "num_elem_var",     "num_glo_var", "num_nset_var",  "num_sset_var"};

/// Lists that they have in common, where they have them.
constexpr std::array common_lists{"eb_prop1",      "ns_prop1",     "ss_prop1",      "els_prop1",
                                  "time_whole",    "name_nod_var", "name_elem_var", "name_nset_var",
                                  "name_sset_var", "name_glo_var"};

constexpr std::string_view times_variable = "time_whole";

const char* meaning_of(std::string_view list) {
  if (list == times_variable) return "its times are";
  if (list == "eb_prop1") return "the ids of its blocks are";
  if (list == "ns_prop1") return "the ids of its node sets are";
  if (list == "ss_prop1") return "the ids of its side sets are";
  if (list == "els_prop1") return "the ids of its element sets are";
  return "the names of its variables are";
}

OpenPiece open_piece(const PieceFiles& files, std::size_t piece) {
  const std::string path = files.path(piece);
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored))
    throw FileError(path, fmt::format("there is no such file; it is one of the {} pieces of {}", files.count,
                                      files.base));
  OpenPiece open{std::make_unique<const NetcdfFile>(path), {}};
  open.layout = read_layout(*open.file);
  return open;
}

/// Throws when a piece does not say what is needed to join it.
void check_says_whole(const OpenPiece& piece, const PieceFiles& files) {
  const NetcdfFile& file = *piece.file;
  if (piece.layout.length("num_nodes_global") == 0 && piece.layout.length("num_nodes") > 0)
    file.fail("is named as a piece, but does not say how many nodes the whole mesh has (num_nodes_global)");
  if (piece.layout.length("num_elems_global") == 0 && piece.layout.length("num_elem") > 0)
    file.fail(
        "is named as a piece, but does not say how many elements the whole mesh has (num_elems_global)");
  std::size_t n_pieces = piece.layout.length("num_processors");
  if (n_pieces == 0)
    n_pieces = static_cast<std::size_t>(
        std::max(0.0, first_number(find_attribute(piece.layout.attributes, "processor_info")).value_or(0.0)));
  if (n_pieces != 0 && n_pieces != files.count)
    file.fail(fmt::format("is one of {} pieces, but its name says one of {}", n_pieces, files.count));
  if (piece.layout.length("num_procs_file") > 1)
    file.fail("holds the pieces of several processors in one file");
}

/// The values of a list as they are compared.
NetcdfValues read_list(const OpenPiece& piece, const NetcdfDefinition& list) {
  const NetcdfVariable variable = piece.file->find_variable(list.name).value();
  if (variable.is_text) {
    std::vector<char> all;
    for (const std::string& text : piece.file->read_texts(variable)) {
      all.insert(all.end(), text.begin(), text.end());
      all.push_back('\n');
    }
    return all;
  }
  std::vector<double> values(variable.size());
  piece.file->read_double(variable, values);
  return values;
}

/// Whether the same values are in both lists, of times as far as both have them.
bool is_same_list(NetcdfValues here, NetcdfValues there, bool is_of_times) {
  if (!is_of_times) return here == there;
  auto &times = std::get<std::vector<double>>(here), &other_times = std::get<std::vector<double>>(there);
  const std::size_t n = std::min(times.size(), other_times.size());
  times.resize(n);
  other_times.resize(n);
  return times == other_times;
}

/// A run that was killed may have ended a time in some of its pieces alone: the whole has what all have.
void keep_common_times(std::vector<OpenPiece>& pieces) {
  std::size_t n_times = std::numeric_limits<std::size_t>::max();
  for (const OpenPiece& piece : pieces) n_times = std::min(n_times, piece.layout.length(time_dimension));
  for (OpenPiece& piece : pieces) {
    const auto times = std::ranges::find(piece.layout.dimensions, time_dimension, &NetcdfDimension::name);
    if (times != piece.layout.dimensions.end()) times->length = n_times;
  }
}

void check_is_of_same(const OpenPiece& piece, const OpenPiece& first) {
  for (const char* dimension : common_dimensions) {
    const std::size_t here = piece.layout.length(dimension), there = first.layout.length(dimension);
    if (here != there)
      piece.file->fail(fmt::format("is a piece of another file than {}: {} is {}, there {}",
                                   first.file->path(), dimension, here, there));
  }
  for (const std::string_view list : common_lists) {
    const NetcdfDefinition *here = piece.layout.find_variable(list),
                           *there = first.layout.find_variable(list);
    if (here == nullptr && there == nullptr) continue;
    if (here == nullptr || there == nullptr ||
        !is_same_list(read_list(piece, *here), read_list(first, *there), list == times_variable))
      piece.file->fail(
          fmt::format("is a piece of another file than {}: {} others", first.file->path(), meaning_of(list)));
  }
}

}  // namespace

std::vector<std::int64_t> OpenPiece::integers(const std::string& variable, std::size_t length) const {
  const auto found = file->find_variable(variable);
  if (!found) return {};
  if (found->shape != std::vector{length})
    file->fail(fmt::format("variable {} should have {} values", variable, length));
  std::vector<std::int64_t> values(length);
  file->read_int64(*found, values);
  return values;
}

bool is_piece(const NetcdfFile& file) {
  return file.dimension("num_processors") > 0 || file.dimension("num_nodes_global") > 0 ||
         file.find_global_number("processor_info").value_or(1.0) > 1.0;
}

std::vector<OpenPiece> open_pieces(const PieceFiles& files) {
  allow_open_files(files.count);
  std::vector<OpenPiece> pieces;
  for (std::size_t piece = 0; piece < files.count; ++piece) {
    pieces.push_back(open_piece(files, piece));
    check_says_whole(pieces.back(), files);
    check_is_of_same(pieces.back(), pieces.front());
  }
  keep_common_times(pieces);
  return pieces;
}

}  // namespace contactsim
