// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/diagnostics.hpp"
#include "parser/text/source.hpp"

namespace contactsim {

/// A stretch [begin, end) of a source's text.
struct TextRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

struct ApreproNode;

/// One of the ways on of an if or a switch.
struct ApreproBranch {
  enum class Test { is_true, is_defined, is_undefined, equals, otherwise };
  Test test = Test::is_true;
  TextRange condition;  ///< the expression in parentheses; empty for `otherwise`
  std::vector<ApreproNode> body;
};

/// A piece of a deck as Aprepro sees it.
struct ApreproNode {
  enum class Kind {
    text,         ///< copied
    expression,   ///< {expr}
    silent,       ///< {{expr}}
    unclosed,     ///< a brace that nothing closes
    conditional,  ///< if, elseif, else: branches
    choice,       ///< switch, case, default: branches; `range` is what they are compared with
    loop,         ///< `range` holds the arguments; body
    include,      ///< `range` holds the argument
    optional_include,
    echo_on,
    echo_off,
    immutable_on,
    immutable_off,
    glued_mark,  ///< a comment mark without blank before a control line: it comes to hide the next line
    joined_text  ///< text behind an if or a case, `range` being the control group: it is joined to the next
                 ///< line
  };
  Kind kind = Kind::text;
  TextRange range;
  std::size_t at = 0;      ///< the opening brace, or the mark
  bool ends_line = false;  ///< of an include: it took the line end with it
  bool is_glued = false;   ///< of an include: a comment mark stands before it without blank
  std::vector<ApreproBranch> branches = {};
  std::vector<ApreproNode> body = {};
};

/// Takes a text apart at its braces. Control lines that do not fit together are reported.
/// Source: SEACAS Aprepro, conditionals, switch statements, loops, ECHO, VERBATIM, IMMUTABLE.
std::vector<ApreproNode> read_aprepro_structure(const Source& source, Diagnostics& diagnostics);

/// The control words, for suggestions.
const std::vector<std::string>& aprepro_control_words();

}  // namespace contactsim
