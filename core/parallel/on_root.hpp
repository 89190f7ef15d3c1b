// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/errors.hpp"
#include "core/parallel/ranks.hpp"

namespace contactsim {

/// Has each rank do what another may fail in: write a file of its own. Where that throws FileError on any
/// rank all throw one.
template <class Work>
void on_each(Ranks& ranks, const Work& work) {
  if (!ranks.are_several()) return work();
  std::exception_ptr problem;
  std::vector<char> text;
  try {
    work();
  } catch (const FileError& error) {
    problem = std::current_exception();
    const std::string_view what = error.what();
    text.assign(what.begin(), what.end());
    text.push_back('\n');
  }
  const std::vector<char> all = ranks.join(text);
  if (problem) std::rethrow_exception(problem);
  if (all.empty()) return;
  const std::string_view first(all.data(), all.size());
  throw FileError("on another rank", std::string(first.substr(0, first.find('\n'))));
}

/// Has rank 0 alone do what all would do alike. Where that throws FileError all ranks do.
template <class Work>
void on_root(Ranks& ranks, const Work& work) {
  on_each(ranks, [&] {
    if (ranks.is_root()) work();
  });
}

}  // namespace contactsim
