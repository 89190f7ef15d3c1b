// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/netcdf/netcdf_file.hpp"
#include "io/pieces/joined_pieces.hpp"

namespace contactsim {

/// The pieces that are read for a path: the decomposition that it names a piece of. Absent of a file that is
/// whole, whatever its name. Throws FileError when it cannot be read.
std::optional<PieceFiles> find_pieces(const std::string& path);

/// An Exodus file, open for reading: one file, or the pieces that it is decomposed into as if they were one.
/// Every member throws FileError with the path of the file that is damaged.
class ExodusFile {
 public:
  /// Opens a file, or all pieces of the decomposition that the path names one of. Where there is no such file
  /// but pieces of it, these. Whether a single file is Exodus at all is not looked at.
  ///   n_ranks  of several decompositions, which to prefer: see find_exodus_path
  explicit ExodusFile(const std::string& path, std::size_t n_ranks = 0);
  ExodusFile(const ExodusFile&) = delete;
  ExodusFile& operator=(const ExodusFile&) = delete;

  /// Of the file, or of the first piece.
  const std::string& path() const;
  [[noreturn]] void fail(const std::string& what) const;
  /// Absent of a file that is whole.
  std::optional<std::size_t> n_pieces() const;
  NetcdfLayout layout() const;

  // What follows is as in NetcdfFile.
  std::size_t dimension(const std::string& name) const;
  std::optional<NetcdfVariable> find_variable(const std::string& name) const;
  std::vector<std::string> variable_names(std::string_view prefix) const;
  int n_groups() const;
  std::optional<double> find_global_number(const std::string& name) const;
  std::optional<std::string> find_global_text(const std::string& name) const;
  std::optional<std::int64_t> find_integer(const NetcdfVariable& variable,
                                           const std::string& attribute) const;
  std::optional<std::string> find_text(const NetcdfVariable& variable, const std::string& attribute) const;
  std::size_t rows_per_read(const NetcdfVariable& variable) const;
  [[nodiscard]] bool read_int32(const NetcdfVariable& variable, Rows rows,
                                std::span<std::int32_t> values) const;
  void read_double(const NetcdfVariable& variable, Rows rows, std::span<double> values) const;
  void read_int64(const NetcdfVariable& variable, std::span<std::int64_t> values) const;
  void read_double(const NetcdfVariable& variable, std::span<double> values) const;
  std::vector<std::string> read_texts(const NetcdfVariable& variable) const;
  std::vector<std::string> read_stored_texts(const NetcdfVariable& variable) const;
  /// Rows of any variable.
  NetcdfValues read_values(const NetcdfVariable& variable, NetcdfType type, Rows rows) const;

 private:
  // One of them is there.
  std::optional<NetcdfFile> whole_;
  std::optional<JoinedPieces> pieces_;
};

}  // namespace contactsim
