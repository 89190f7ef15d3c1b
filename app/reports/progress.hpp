// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// Whether somebody looks at a standard stream as it is written. mpirun gives its processes terminals of its
/// own, whatever the output goes to.
bool is_terminal(int stream);

/// A line at the closest point of a terminal that says how far a run is and how long it will take. Where
/// standard output is no terminal there is none of it.
class Progress {
 public:
  /// The times of the run [time].
  Progress(double start, double end);
  /// Wipes the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// Draws the line anew, a few times per second at most.
  void show(double time);
  /// Makes room for other text.
  void wipe();

 private:
  double start_, end_, begun_, shown_ = 0.0;
  bool is_terminal_, is_drawn_ = false;
};

/// "  42 % [########............]  0:17 left".
///   share    that is done, 0 to 1
///   elapsed  since the start [s]
std::string progress_line(double share, double elapsed);

}  // namespace contactsim
