// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace contactsim {

/// A value over time.
struct Curve {
  std::string name;
  std::vector<double> values;  ///< [n_times]
};

/// Curves of one dimension that are drawn together.
struct CurveChart {
  std::string title;
  std::string source;         ///< the file that it is from; "" of the run itself
  std::string dimension;      ///< "energy"; "" when it is not known
  std::vector<double> times;  ///< rising [time]
  std::vector<Curve> curves;
};

/// Columns over time as a file has them.
struct ColumnTable {
  std::string source;                        ///< the file, for titles
  std::vector<std::string> names;            ///< of the columns, without the time
  std::vector<std::string> dimensions;       ///< of the columns, or empty
  std::vector<double> times;                 ///< [time]
  std::vector<std::vector<double>> columns;  ///< [n names] each [n times]
};

/// Charts of columns: energies together, components of a vector together, every other column alone. Of many
/// times 1000 are kept, evenly chosen, the last one always.
std::vector<CurveChart> make_charts(const ColumnTable& table);

/// The columns of a heartbeat in CSV, with the dimensions of its line of units. Throws FileError naming the
/// line that is not as it should be.
ColumnTable read_heartbeat_columns(const std::string& path, const std::string& text);

/// The global variables of an Exodus file. Throws FileError.
ColumnTable read_global_columns(const std::string& path);

}  // namespace contactsim
