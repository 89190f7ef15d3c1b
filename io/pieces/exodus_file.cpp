// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/exodus_file.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>

#include "core/base/errors.hpp"
#include "io/netcdf/clean_text.hpp"
#include "io/netcdf/read_layout.hpp"

namespace contactsim {

namespace {

Rows all_rows(const NetcdfVariable& variable) { return {0, variable.shape.empty() ? 1 : variable.shape[0]}; }

std::size_t count_values(const NetcdfVariable& variable, Rows rows) {
  std::size_t n = variable.shape.empty() ? 1 : rows.count;
  for (std::size_t d = 1; d < variable.shape.size(); ++d) n *= variable.shape[d];
  return n;
}

/// Whether another piece of the same name is there.
bool has_others(const PieceFiles& files, const std::string& path) {
  std::error_code ignored;
  for (std::size_t piece = 0; piece < files.count; ++piece) {
    if (files.path(piece) != path && std::filesystem::exists(files.path(piece), ignored)) return true;
  }
  return false;
}

}  // namespace

std::optional<PieceFiles> find_pieces(const std::string& path) {
  auto files = parse_piece_path(path);
  std::error_code ignored;
  // A name like a piece's may be a file's own.
  if (files && std::filesystem::exists(path, ignored) && !is_piece(NetcdfFile(path)) &&
      !has_others(*files, path))
    return std::nullopt;
  return files;
}

ExodusFile::ExodusFile(const std::string& path, std::size_t n_ranks) {
  const std::string found = find_exodus_path(path, n_ranks);
  if (const auto files = find_pieces(found)) {
    pieces_.emplace(*files);
  } else {
    whole_.emplace(found);
  }
}

const std::string& ExodusFile::path() const { return whole_ ? whole_->path() : pieces_->path(); }

void ExodusFile::fail(const std::string& what) const { throw FileError(path(), what); }

std::optional<std::size_t> ExodusFile::n_pieces() const {
  return whole_ ? std::nullopt : std::optional(pieces_->n_pieces());
}

NetcdfLayout ExodusFile::layout() const { return whole_ ? read_layout(*whole_) : pieces_->layout(); }

std::size_t ExodusFile::dimension(const std::string& name) const {
  return whole_ ? whole_->dimension(name) : pieces_->layout().length(name);
}

std::optional<NetcdfVariable> ExodusFile::find_variable(const std::string& name) const {
  return whole_ ? whole_->find_variable(name) : pieces_->find_variable(name);
}

std::vector<std::string> ExodusFile::variable_names(std::string_view prefix) const {
  if (whole_) return whole_->variable_names(prefix);
  std::vector<std::string> names;
  for (const NetcdfDefinition& variable : pieces_->layout().variables) {
    if (variable.name.starts_with(prefix)) names.push_back(variable.name);
  }
  return names;
}

int ExodusFile::n_groups() const { return whole_ ? whole_->n_groups() : 0; }

std::optional<double> ExodusFile::find_global_number(const std::string& name) const {
  return whole_ ? whole_->find_global_number(name)
                : first_number(find_attribute(pieces_->layout().attributes, name));
}

std::optional<std::string> ExodusFile::find_global_text(const std::string& name) const {
  return whole_ ? whole_->find_global_text(name)
                : whole_text(find_attribute(pieces_->layout().attributes, name));
}

std::optional<std::int64_t> ExodusFile::find_integer(const NetcdfVariable& variable,
                                                     const std::string& attribute) const {
  if (whole_) return whole_->find_integer(variable, attribute);
  const NetcdfAttribute* found = find_attribute(pieces_->definition(variable).attributes, attribute);
  const auto* integers = found == nullptr ? nullptr : std::get_if<std::vector<std::int64_t>>(&found->values);
  return integers == nullptr || integers->size() != 1 ? std::nullopt : std::optional(integers->front());
}

std::optional<std::string> ExodusFile::find_text(const NetcdfVariable& variable,
                                                 const std::string& attribute) const {
  return whole_ ? whole_->find_text(variable, attribute)
                : whole_text(find_attribute(pieces_->definition(variable).attributes, attribute));
}

std::size_t ExodusFile::rows_per_read(const NetcdfVariable& variable) const {
  return whole_ ? whole_->rows_per_read(variable) : std::max<std::size_t>(all_rows(variable).count, 1);
}

bool ExodusFile::read_int32(const NetcdfVariable& variable, Rows rows, std::span<std::int32_t> values) const {
  if (whole_) return whole_->read_int32(variable, rows, values);
  pieces_->read<std::int32_t>(variable, rows, values);
  return true;
}

void ExodusFile::read_double(const NetcdfVariable& variable, Rows rows, std::span<double> values) const {
  whole_ ? whole_->read_double(variable, rows, values) : pieces_->read<double>(variable, rows, values);
}

void ExodusFile::read_int64(const NetcdfVariable& variable, std::span<std::int64_t> values) const {
  whole_ ? whole_->read_int64(variable, values)
         : pieces_->read<std::int64_t>(variable, all_rows(variable), values);
}

void ExodusFile::read_double(const NetcdfVariable& variable, std::span<double> values) const {
  whole_ ? whole_->read_double(variable, values)
         : pieces_->read<double>(variable, all_rows(variable), values);
}

std::vector<std::string> ExodusFile::read_stored_texts(const NetcdfVariable& variable) const {
  if (whole_) return whole_->read_stored_texts(variable);
  if (!variable.is_text || variable.shape.size() < 2)
    fail("variable " + variable.name + " is not a list of texts");
  std::vector<char> all(variable.size());
  pieces_->read<char>(variable, all_rows(variable), all);
  return split_texts({all.data(), all.size()}, variable.shape.back());
}

std::vector<std::string> ExodusFile::read_texts(const NetcdfVariable& variable) const {
  std::vector<std::string> texts = read_stored_texts(variable);
  for (std::string& text : texts) text = clean_text(text);
  return texts;
}

NetcdfValues ExodusFile::read_values(const NetcdfVariable& variable, NetcdfType type, Rows rows) const {
  const std::size_t n = count_values(variable, rows);
  if (type == NetcdfType::text) {
    std::vector<char> text(n);
    whole_ ? whole_->read_text(variable, rows, text) : pieces_->read<char>(variable, rows, text);
    return text;
  }
  if (type == NetcdfType::float32 || type == NetcdfType::float64) {
    std::vector<double> reals(n);
    read_double(variable, rows, reals);
    return reals;
  }
  std::vector<std::int64_t> integers(n);
  whole_ ? whole_->read_int64(variable, rows, integers)
         : pieces_->read<std::int64_t>(variable, rows, integers);
  return integers;
}

}  // namespace contactsim
