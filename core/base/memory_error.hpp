// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <new>
#include <stdexcept>
#include <string>
#include <string_view>

namespace contactsim {

/// There was not enough memory: "out of memory while reading the mesh plate.g".
class MemoryError : public std::runtime_error {
 public:
  explicit MemoryError(std::string_view doing)
      : std::runtime_error("out of memory while " + std::string(doing)) {}
};

/// Does some work and returns what it returns. Where memory runs out in it throws MemoryError; of work inside
/// work the innermost is told.
///   doing  completes "while": "reading the mesh plate.g"
template <class Work>
auto tell_lack_of_memory(std::string_view doing, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    throw MemoryError(doing);
  }
}

}  // namespace contactsim
