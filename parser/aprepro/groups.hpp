// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "parser/aprepro/control.hpp"

namespace contactsim {

/// A pair of braces and what it stands for.
struct ApreproGroup {
  enum class Word {
    none,  ///< an expression
    if_true,
    if_defined,
    if_undefined,
    else_if,
    otherwise,
    end_if,
    choose,
    one_case,
    default_case,
    end_choose,
    loop,
    end_loop,
    include,
    optional_include,
    echo_on,
    echo_off,
    immutable_on,
    immutable_off,
    verbatim_on,
    verbatim_off
  };
  Word word = Word::none;
  std::size_t at = 0;      ///< the opening brace
  std::size_t end = 0;     ///< behind the closing one; where the search for it stopped when there is none
  TextRange inside;        ///< between the braces
  TextRange argument;      ///< between the control word's parentheses
  bool is_silent = false;  ///< in double braces
  bool is_closed = true;
};

/// The end of the string that opens at `at`, or the next character when it is broken.
std::size_t skip_aprepro_string(std::string_view text, std::size_t at);

/// Reads the group whose brace stands at `at`. Braces in its strings do not count.
ApreproGroup read_aprepro_group(std::string_view text, std::size_t at);

/// The construct that the word begins, if any.
std::optional<ApreproNode::Kind> construct_begun_by(ApreproGroup::Word word);

/// The construct that the word ends, if any.
std::optional<ApreproNode::Kind> construct_ended_by(ApreproGroup::Word word);

/// The construct of which the word begins another branch, if any.
std::optional<ApreproNode::Kind> construct_split_by(ApreproGroup::Word word);

/// What decides on the branch that the word begins.
ApreproBranch::Test test_of(ApreproGroup::Word word);

}  // namespace contactsim
