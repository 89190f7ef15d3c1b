// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

#include "app/report/stored_names.hpp"
#include "core/mesh/stored_variables.hpp"

namespace contactsim {

/// A stored value to colour the mesh by.
struct ReportField {
  std::string name;      ///< on the file
  std::string variable;  ///< as contactsim calls it
  bool is_nodal = true;  ///< else of elements
  /// At a stored time, by its position: [n_nodes] or [n_elements], NaN where there is none. Throws FileError.
  std::function<std::vector<double>(std::size_t time)> read;
};

/// What a report shows of the stored variables.
struct ReportFields {
  /// At a stored time [3 x n_nodes] [length]; empty when no displacement is stored.
  std::function<Eigen::Matrix3Xd(std::size_t time)> displacement;
  std::vector<ReportField> fields;    ///< contact pressure and von Mises stress first
  std::vector<std::string> left_out;  ///< names of stored variables beyond the first eight
  std::vector<std::string>
      not_found;  ///< what is not stored, and the deck line that would: one sentence each
};

/// Chooses them: scalars, norms of vectors; von Mises stress also from a stored stress.
///   stored  must outlive the functions
///   names   what variables are called on the file
ReportFields choose_report_fields(const StoredVariables& stored, const StoredNames& names);

}  // namespace contactsim
