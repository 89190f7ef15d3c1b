// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <utility>

#include "core/diagnostics.hpp"

namespace contactsim {

/// How the program ends; scripts read it.
enum class ExitCode { done = 0, our_bug = 1, deck = 2, file = 3, solve = 4 };

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

/// A run cannot go on: a step vanishes, an element turns inside out, a number is not finite.
class SolveError : public std::runtime_error {
 public:
  /// The message begins with "step <step>, time <time>: ".
  SolveError(std::int64_t step, double time, const std::string& what);
};

}  // namespace contactsim
