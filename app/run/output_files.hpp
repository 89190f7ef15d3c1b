// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ctime>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/run/results_pieces.hpp"
#include "core/output/output_writers.hpp"
#include "io/heartbeat/heartbeat_writer.hpp"

namespace contactsim {

/// What output files say about their run.
struct OutputFileSettings {
  std::string mesh_path;  ///< whose QA records go before ours; "" for none
  std::string command_line;
  std::vector<std::string> deck_lines;  ///< after Aprepro
  TextSink log;                         ///< for heartbeats to cout, cerr, log, ...
  std::function<std::time_t()> clock = [] { return std::time(nullptr); };
  std::optional<ResultsPieces> pieces = std::nullopt;  ///< of results files with a mesh
};

/// The writers of `io`, as an output plan calls them. Of results in pieces all ranks call them alike.
OutputWriters make_output_writers(OutputFileSettings settings);

/// The style of a format with what the deck says otherwise. Source: Sierra/SM 5.22, 9.8.
HeartbeatStyle heartbeat_style(const HeartbeatOutput& form);

}  // namespace contactsim
