// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "core/definition/output_variable.hpp"
#include "core/mesh/mesh_piece.hpp"
#include "core/output/variable_selection.hpp"

namespace contactsim {

/// What a results file is asked to hold.
struct FieldRequests {
  std::span<const VariableRequest> variables;
  std::span<const DeckName> included,
      excluded;                 ///< blocks that element variables are for; none included: all
  std::string separator = "_";  ///< between the names of variables and components
};

/// Values of a run as they go to a file.
class RequestedFields {
 public:
  /// A variable under its name on the file.
  struct Field {
    VariableSelection selection;
    EntityRange range;
    OutputField field;
  };

  RequestedFields() = default;
  explicit RequestedFields(std::vector<Field> fields) : fields_(std::move(fields)) {}

  std::size_t size() const { return fields_.size(); }
  const VariableSelection& selection(std::size_t field) const { return fields_[field].selection; }
  /// Whose values it has.
  const EntityRange& range(std::size_t field) const { return fields_[field].range; }
  /// Whether some are globals that are found from all nodes or elements.
  bool read_all() const;
  /// Names and places of all fields.
  std::vector<OutputField> fields() const;

  /// The values of one field at a time, good until the next call: a run has room for one field, not for
  /// all. Changes nothing in the run.
  std::span<const double> evaluate(std::size_t field, const OutputContext& context);
  /// Those of a piece of the mesh; it may have nodes beyond those of the model, which are left out.
  std::span<const double> evaluate(std::size_t field, const OutputContext& context, const MeshPiece& piece);

 private:
  std::vector<Field> fields_;
  std::vector<double> values_;  // of the field that was evaluated last
};

/// A field of a variable for a range of its entities.
///   name  on the file, without components
RequestedFields::Field make_field(const VariableSelection& selection, const Model& model,
                                  const EntityRange& range, const std::string& name);

/// The name on the file, without the components that the field will have: the alias, else the variable's
/// name with the one component and the integration point that are asked for.
std::string field_name(const VariableRequest& request, const VariableSelection& selection,
                       const std::string& separator);

/// The fields of a results file: what the deck asks for, then the energies and the momentum, which every file
/// has. What is not known or cannot be is left out with a warning. The variables must outlive the fields.
///   block_names  [n mesh blocks] all that the deck may call each
/// Source: Sierra/SM 5.22, 9.1; 5.20, global energy reporting.
RequestedFields make_requested_fields(const OutputVariables& variables, const FieldRequests& requests,
                                      std::span<const std::vector<std::string>> block_names,
                                      Diagnostics& diagnostics);

}  // namespace contactsim
