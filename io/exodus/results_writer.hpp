// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/mesh/output_field.hpp"
#include "io/exodus/qa_records.hpp"
#include "io/exodus/results_variables.hpp"
#include "io/netcdf/record_file.hpp"

namespace contactsim {

/// What a results file says about itself.
struct ResultsText {
  std::string title;                 ///< at most 80 characters are kept
  std::vector<QaRecord> qa_records;  ///< earlier programs first
  std::vector<std::string>
      info;  ///< lines of any length; those beyond 80 characters go on in the next record
};

/// An Exodus results file that grows step by step and can be read all the while. It is made under a temporary
/// name and replaces an older file of its name once the mesh is in it, at the end of the constructor; from
/// then on it holds all steps whose write_step has returned, also when the process is killed or a disk is
/// full. The same calls give the same bytes.
/// Source: Schoof & Yarberry, EXODUS II: A Finite Element Data Model, SAND92-2137 (1994).
class ResultsWriter {
 public:
  /// Writes the mesh: blocks, sets and assemblies under the names of Mesh::name, attributes, distribution
  /// factors, id maps; and defines the fields. Throws FileError when the file cannot be written, when it is
  /// the mesh's own, and for blocks whose connectivity was not read.
  /// Preconditions: the component names of one location differ (of one block for element fields).
  ResultsWriter(const std::string& path, const Mesh& mesh, const ResultsText& text,
                std::span<const OutputField> fields);

  /// Goes on with one of the pieces that such a file, without a step yet, has been divided into; write_step()
  /// takes the values of what the piece has, in its order. Throws FileError when it cannot be written.
  ///   mesh, fields  of the whole file
  ResultsWriter(const std::string& path, const MeshPiece& piece, const Mesh& mesh,
                std::span<const OutputField> fields);

  /// What such a file would take: with the mesh, and of each step. Writes nothing. Throws FileError for
  /// blocks whose connectivity was not read.
  static FileBytes measure(const Mesh& mesh, const ResultsText& text, std::span<const OutputField> fields);

  /// Gives the values of one field of the constructor.
  using Values = std::function<std::span<const double>(std::size_t field)>;

  /// Appends a step and flushes it; the values of each field are asked for when it is their turn. Throws
  /// FileError when that is not possible; the file is then closed with the earlier steps. Throws
  /// std::logic_error when there are not values for every node or element; the step does not count then.
  ///   time  [time]
  void write_step(double time, const Values& values);

  std::size_t n_steps() const { return records_->n_records(); }

 private:
  // Both are there from the end of the constructor on.
  std::optional<ResultsVariables> variables_;
  std::optional<RecordFile> records_;
};

}  // namespace contactsim
