// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <utility>

#include "core/base/diagnostics.hpp"

namespace contactsim {

/// How the program ends; scripts read it.
enum class ExitCode { done = 0, our_bug = 1, deck = 2, file = 3, solve = 4, stopped = 5 };

/// The deck (or the command line) is wrong. Carries every problem that was found.
class DeckError : public std::runtime_error {
 public:
  explicit DeckError(Diagnostics diagnostics)
      : std::runtime_error("the deck has errors"), diagnostics_(std::move(diagnostics)) {}
  const Diagnostics& diagnostics() const { return diagnostics_; }

 private:
  Diagnostics diagnostics_;
};

/// A mesh or results file cannot be read or written: "mesh.g: block_2: ...".
class FileError : public std::runtime_error {
 public:
  FileError(const std::string& path, const std::string& what) : std::runtime_error(path + ": " + what) {}
};

/// A run cannot go on: "time 0.001: element 17 ...".
class SolveError : public std::runtime_error {
 public:
  /// time  at which it happened [time]
  SolveError(double time, const std::string& what)
      : std::runtime_error(fmt::format("time {}: {}", time, what)), time_(time) {}
  double time() const { return time_; }

 private:
  double time_;
};

}  // namespace contactsim
