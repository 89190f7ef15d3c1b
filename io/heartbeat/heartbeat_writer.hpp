// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <fstream>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace contactsim {

/// How the lines of a heartbeat look; as it is, those of a CSV file.
/// Source: Sierra/SM 5.22, 9.8; SEACAS, Ioss heartbeat database.
struct HeartbeatStyle {
  bool is_spyhis = false;          ///< begins as SPYHIS files do
  int n_digits = 6;                ///< of a number, >= 1
  bool has_labels = false;         ///< name=value in place of the value
  bool has_legend = true;          ///< the names on top
  bool has_time = true;            ///< the time as first value
  std::string separator = ", ";    ///< between values
  std::vector<std::string> units;  ///< of the values besides the time, under the names; empty: no such line
  std::string timestamp_format;    ///< of the clock in front of each line, as strftime takes it; "" for none
};

/// The style of the format ORIGINAL: names in the lines, the clock before them.
HeartbeatStyle original_heartbeat_style();

/// Where the lines of a heartbeat go.
using TextSink = std::function<void(std::string_view)>;

/// A sink into a file that is flushed after each text. Throws FileError, also when called, when the file
/// cannot be written.
///   appends  to what the file holds; else it begins anew
TextSink make_file_sink(const std::string& path, bool appends);

/// Values over time as lines of text.
class HeartbeatWriter {
 public:
  ///   names  of the values besides the time
  ///   clock  the time of day; of the legend's line in SPYHIS, of each line's timestamp
  HeartbeatWriter(TextSink sink, HeartbeatStyle style, std::vector<std::string> names,
                  std::function<std::time_t()> clock);

  /// Writes a line, before the first the legend.
  ///   time    [time]
  ///   values  in the order of the names
  void write(double time, std::span<const double> values);

 private:
  void write_legend();
  void write_units();
  std::string timestamp() const;

  TextSink sink_;
  HeartbeatStyle style_;
  std::vector<std::string> names_;
  std::function<std::time_t()> clock_;
  bool has_begun_ = false;
};

}  // namespace contactsim
