// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/mesh/mesh_piece.hpp"
#include "core/mesh/output_field.hpp"
#include "io/exodus/exodus_draft.hpp"
#include "io/exodus/file_order.hpp"
#include "io/netcdf/record_file.hpp"

namespace contactsim {

/// The variables over time of an Exodus file, one for each component of each field; element fields of one
/// name are one variable, and the truth table says in which blocks.
class ResultsVariables {
 public:
  /// Adds the fields to the draft of a file, after its mesh.
  /// Preconditions: the components of one location have different names (of one block for element fields).
  ResultsVariables(const Mesh& mesh, std::span<const OutputField> fields, ExodusDraft& draft);

  std::size_t size() const { return fields_.size(); }
  /// From now on write() takes the values of a piece alone, in the order of its file.
  void take_piece(const MeshPiece& piece);

  /// Writes one field of the constructor to the record that is open. Throws std::logic_error when there are
  /// not values for every node or element, or those of the piece; nothing is written then.
  ///   values  n_entities x n_components, entity by entity
  void write(std::size_t field, std::span<const double> values, RecordFile& file) const;

 private:
  struct DefinedField {
    OutputField field;
    std::size_t n_entities = 0;          ///< nodes, elements of the block, or 1
    std::size_t first_global = 0;        ///< position of a global's first component in vals_glo_var
    std::vector<std::string> variables;  ///< n_components; empty for globals and where there are no entities
  };

  const FileOrder& order_of(const OutputField& field) const;
  std::vector<std::string> component_names(FieldLocation location) const;
  void add_globals(ExodusDraft& draft);
  void add_nodal(ExodusDraft& draft);
  void add_element(const Mesh& mesh, ExodusDraft& draft);

  FileOrder node_order_;  // that of a piece is as it has them
  std::vector<FileOrder> block_orders_;
  std::vector<DefinedField> fields_;
  int steps_ = 0;  // dimension
};

}  // namespace contactsim
