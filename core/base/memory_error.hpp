// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <new>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace contactsim {

/// There was not enough memory: "out of memory while reading the mesh plate.g".
class MemoryError : public std::runtime_error {
 public:
  explicit MemoryError(std::string_view doing)
      : std::runtime_error("out of memory while " + std::string(doing)) {}
};

/// What is being done, for whom no exception reaches: those that leave a loop on threads end the process.
class WorkInMemory {
 public:
  explicit WorkInMemory(std::string_view doing) : before_(std::exchange(doing_, doing)) {}
  ~WorkInMemory() { doing_ = before_; }
  WorkInMemory(const WorkInMemory&) = delete;
  WorkInMemory& operator=(const WorkInMemory&) = delete;

  /// Completes "out of memory while"; empty: nothing in particular.
  static std::string_view now() { return doing_; }
  /// Whether memory has run out, which end_without_memory() cannot see otherwise.
  static bool lacks_memory() { return lacks_memory_; }
  /// Throws std::bad_alloc, and notes it.
  [[noreturn]] static void throw_bad_alloc() {
    lacks_memory_ = true;
    throw std::bad_alloc();
  }

 private:
  static inline std::string_view doing_;
  static inline std::atomic<bool> lacks_memory_ = false;
  std::string_view before_;
};

/// Does some work and returns what it returns. Where memory runs out in it throws MemoryError; of work inside
/// work the innermost is reported.
///   doing  completes "while": "reading the mesh plate.g"
template <class Work>
auto tell_lack_of_memory(std::string_view doing, const Work& work) {
  try {
    const WorkInMemory working(doing);
    return work();
  } catch (const std::bad_alloc&) {
    throw MemoryError(doing);
  }
}

}  // namespace contactsim
