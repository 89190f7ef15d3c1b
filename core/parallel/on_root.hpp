// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>

#include "core/base/errors.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// Has rank 0 alone do what all would do alike: write a file. Where that throws FileError all ranks do.
template <class Work>
void on_root(Ranks& ranks, const Work& work) {
  if (!ranks.are_several()) return work();
  std::exception_ptr problem;
  if (ranks.is_root()) {
    try {
      work();
    } catch (const FileError&) {
      problem = std::current_exception();
    }
  }
  if (!ranks.of_root(problem != nullptr)) return;
  if (problem) std::rethrow_exception(problem);
  throw FileError("rank 0", "has a file that it cannot write");
}

}  // namespace contactsim
