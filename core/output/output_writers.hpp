// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/definition/output.hpp"
#include "core/mesh/mesh.hpp"
#include "core/mesh/mesh_piece.hpp"
#include "core/mesh/output_field.hpp"

namespace contactsim {

/// An Exodus file that grows step by step.
struct ResultsFile {
  std::string path;
  bool overwrites = true;  ///< an older file of the name; else that is an error
  bool has_mesh = true;    ///< or holds single values over time alone
  std::string title;
};

/// A file of lines of text, or the log.
struct HeartbeatFile {
  std::string path;                          ///< "" for the log
  HeartbeatOutput form;                      ///< format, digits, legend as the deck has them
  std::vector<std::string> dimensions = {};  ///< of the values, in the order of their names
};

/// What a file that grows step by step takes [bytes].
struct OutputBytes {
  std::uint64_t start = 0;  ///< before the first step
  std::uint64_t step = 0;   ///< of each step or line
};

/// What an output plan writes through: it decides what is written and when, these know files.
struct OutputWriters {
  /// The values of a field by its position, [n_entities x n_components], good until the next call. Of a file
  /// that is one of several pieces those of the piece's entities, in its order.
  using FieldValues = std::function<std::span<const double>(std::size_t field)>;
  /// Appends a state: its time [time], and the fields' values, which are asked for one after the other.
  using AppendStep = std::function<void(double time, const FieldValues& values)>;
  /// Appends a line: its time [time] and values in the order of the names.
  using AppendLine = std::function<void(double time, std::span<const double> values)>;

  struct OpenResults {
    AppendStep append;
    std::shared_ptr<const MeshPiece> piece = nullptr;  ///< what the file has of the mesh; null for all
  };

  /// Makes a file with its mesh and room for the fields. Throws FileError, also when called.
  std::function<OpenResults(const ResultsFile&, const Mesh&, std::span<const OutputField>)> open_results;
  /// Makes a file, or goes on with an older one. Throws FileError, also when called.
  std::function<AppendLine(const HeartbeatFile&, std::vector<std::string> names)> open_heartbeat;
  /// The paths of the files that open_results makes.
  std::function<std::vector<std::string>(const ResultsFile&)> name_results = [](const ResultsFile& file) {
    return std::vector{file.path};
  };
  /// What open_results would write, without a file.
  std::function<OutputBytes(const ResultsFile&, const Mesh&, std::span<const OutputField>)> measure_results =
      {};
  /// What open_heartbeat would write, within the width of signs.
  std::function<OutputBytes(const HeartbeatFile&, std::vector<std::string> names)> measure_heartbeat = {};
};

}  // namespace contactsim
