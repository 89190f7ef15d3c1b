// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace contactsim {

/// The information records of an Exodus file, in which ResultsWriter stores the command line and the deck: a
/// record of full length and the one after it are one line again. None when the file has none. Throws
/// FileError.
std::vector<std::string> read_info_lines(const std::string& path);

/// The global variables of an Exodus file.
struct GlobalHistory {
  std::vector<std::string> names;
  std::vector<double> times;                 ///< [time]
  std::vector<std::vector<double>> columns;  ///< [n names] each [n times]
};

/// Reads them; empty when there are none. Throws FileError when their shape is not that of the names and
/// times. Source: Schoof & Yarberry, EXODUS II: A Finite Element Data Model, SAND92-2137 (1994), global
/// variables.
GlobalHistory read_global_history(const std::string& path);

}  // namespace contactsim
