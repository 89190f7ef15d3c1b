// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim::test {

enum class FileFormat : std::uint8_t { cdf1, cdf2, cdf5, netcdf4, netcdf4_classic };

/// Which of the many ways to write the same mesh.
struct ExodusLayout {
  FileFormat format = FileFormat::cdf2;
  bool wide_integers = false;         ///< 64-bit; cdf5 and netcdf4 only
  bool single_precision = false;      ///< 4-byte reals
  bool combined_coordinates = false;  ///< coord(num_dim, num_nodes)
  bool with_names = true;             ///< eb_names and so on
  bool with_status = true;            ///< eb_status and so on
  bool deflate = false;               ///< netcdf4 only
  std::size_t name_length = 32;
};

/// Writes a mesh with plain netCDF calls, apart from all code under test. Number maps are written when the
/// mesh has them. Blocks of Shape::unknown are written when they have nodes.
void write_exodus(const std::string& path, const Mesh& mesh, const ExodusLayout& layout = {});

/// Changes single things in a netCDF file, mostly for the worse.
class ExodusEditor {
 public:
  explicit ExodusEditor(const std::string& path);
  ~ExodusEditor();
  ExodusEditor(const ExodusEditor&) = delete;
  ExodusEditor& operator=(const ExodusEditor&) = delete;

  /// Overwrites one value; `position` counts from 0 through the whole variable.
  ExodusEditor& set_value(const std::string& variable, std::size_t position, double value);
  ExodusEditor& set_text(const std::string& variable, std::size_t row, const std::string& text);
  ExodusEditor& rename_variable(const std::string& name, const std::string& new_name);
  ExodusEditor& rename_dimension(const std::string& name, const std::string& new_name);
  ExodusEditor& add_dimension(const std::string& name, std::size_t length);
  /// A new variable over dimensions that exist.
  ExodusEditor& add_integers(const std::string& name, const std::vector<std::string>& dimensions,
                             const std::vector<long long>& values);
  ExodusEditor& add_reals(const std::string& name, const std::vector<std::string>& dimensions,
                          const std::vector<double>& values);
  /// A new list of texts over a dimension that exists, 32 characters and a zero each.
  ExodusEditor& add_texts(const std::string& name, const std::string& dimension,
                          const std::vector<std::string>& texts);
  /// A new variable over the record dimension, one value per record.
  ExodusEditor& add_records(const std::string& name, const std::vector<std::string>& dimensions,
                            const std::vector<double>& values);
  /// A new netCDF-4 variable without values, of which the file therefore holds nothing.
  ExodusEditor& declare_reals(const std::string& name, const std::vector<std::string>& dimensions,
                              bool chunked);
  /// Attributes of a variable, or global ones when `variable` is "".
  ExodusEditor& remove_attribute(const std::string& variable, const std::string& name);
  ExodusEditor& set_attribute(const std::string& variable, const std::string& name, const std::string& text);
  ExodusEditor& set_attribute(const std::string& variable, const std::string& name, double value);
  ExodusEditor& add_group(const std::string& name);

 private:
  int find_variable(const std::string& name) const;
  /// Leaves the file in define mode.
  int define_variable(const std::string& name, int type, const std::vector<std::string>& dimensions);
  std::vector<std::size_t> index_of(int variable, std::size_t position) const;

  int id_ = -1;
};

}  // namespace contactsim::test
