// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/base/errors.hpp"
#include "parser/aprepro/aprepro.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"

namespace contactsim {

/// Files that a deck includes: texts by their paths.
using Files = std::map<std::string, std::string>;

/// What Aprepro makes of a deck, and what it says about it.
struct Expanded {
  Diagnostics diagnostics;
  Source source;
};

/// Expands a text as the deck "a.i".
inline Expanded expand(const std::string& text, const Files& files = {},
                       const std::vector<std::string>& overrides = {}) {
  const auto read_file = [&](const std::string& path) -> TextFile {
    const auto found = files.find(path);
    if (found != files.end()) return {found->second};
    return {"", "there is no such file", TextFile::Failure::missing};
  };
  Expanded expanded;
  try {
    expanded.source = run_aprepro(make_source("a.i", text), {overrides, read_file}, expanded.diagnostics);
  } catch (const DeckError&) {
    // What it carries is among the diagnostics already.
  }
  return expanded;
}

/// The expanded text, without any complaint.
inline std::string expanded_text(const std::string& text, const Files& files = {}) {
  const Expanded expanded = expand(text, files);
  CHECK(messages(expanded.diagnostics) == "");
  return expanded.source.text();
}

/// What is said of a text.
inline std::string expansion_problems(const std::string& text, const Files& files = {}) {
  return messages(expand(text, files).diagnostics);
}

}  // namespace contactsim
