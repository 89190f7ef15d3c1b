// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "core/mesh/mesh.hpp"
#include "core/mesh/output_field.hpp"
#include "io/exodus/results_writer.hpp"
#include "io/netcdf/netcdf_file.hpp"
#include "support/exodus_times.hpp"

namespace contactsim::test {

/// Fields of every location on a mesh, each value telling its field, entity, component and step: the vector
/// displ and the scalar mass on nodes, the tensor stress in every block, eqps in the last block, and two
/// globals.
class SampleResults {
 public:
  explicit SampleResults(Mesh mesh);

  const Mesh& mesh() const { return mesh_; }
  void set_step(int step);
  std::vector<OutputField> fields() const;
  /// The values of the step that was set last.
  ResultsWriter::Values values() const;

  /// Whether the file holds the very values of a step in that record.
  bool is_step(const NetcdfFile& file, std::size_t step) const;

 private:
  struct Values {
    OutputField field;
    std::vector<std::string> variables;  ///< on the file, n_components; empty for globals and empty blocks
    std::vector<double> values;
  };

  void add(OutputField field, std::size_t n_entities, std::vector<std::string> variables);

  Mesh mesh_;
  std::vector<Values> values_;
};

}  // namespace contactsim::test
