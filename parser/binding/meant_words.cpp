// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/meant_words.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

/// A word that people write in a block, and what says it here.
struct MeantWord {
  std::string_view block, words, hint;
};

constexpr std::string_view friction_hint =
    "friction is a model: BEGIN CONSTANT FRICTION MODEL <name> with FRICTION COEFFICIENT in the contact "
    "definition, and "
    "FRICTION MODEL = <name> here";
constexpr std::string_view value_hint =
    "FUNCTION = <function> times SCALE FACTOR says it; sierra_constant_function_one is 1 at all times";

constexpr std::string_view variable_hint = "NODAL <variable> or ELEMENT <variable> asks for it";

constexpr std::array meant_words{
    MeantWord{"interaction", "friction", friction_hint},
    MeantWord{"interaction", "coefficient", friction_hint},
    MeantWord{"contact definition", "friction coefficient",
              "it belongs into BEGIN CONSTANT FRICTION MODEL <name>"},
    MeantWord{"initial velocity", "velocity", "MAGNITUDE says it, along COMPONENT or DIRECTION"},
    MeantWord{"initial velocity", "value", "MAGNITUDE says it, along COMPONENT or DIRECTION"},
    MeantWord{"prescribed", "magnitude", value_hint},
    MeantWord{"prescribed", "value", value_hint},
    MeantWord{"prescribed", "velocity", value_hint},
    MeantWord{"prescribed", "displacement", value_hint},
    MeantWord{"pressure", "magnitude", value_hint},
    MeantWord{"pressure", "value", value_hint},
    MeantWord{"pressure", "pressure", value_hint},
    MeantWord{"gravity", "acceleration", "GRAVITATIONAL CONSTANT says it"},
    MeantWord{"gravity", "magnitude", "GRAVITATIONAL CONSTANT says it"},
    MeantWord{"gravity", "g", "GRAVITATIONAL CONSTANT says it"},
    MeantWord{"parameters for model", "e", "YOUNGS MODULUS says it"},
    MeantWord{"parameters for model", "nu", "POISSONS RATIO says it"},
    MeantWord{"finite element model", "mesh", "DATABASE NAME says it"},
    MeantWord{"finite element model", "file", "DATABASE NAME says it"},
    MeantWord{"results output", "displacement", variable_hint},
    MeantWord{"results output", "velocity", variable_hint},
    MeantWord{"results output", "stress", variable_hint},
    MeantWord{"results output", "von mises", variable_hint},
    MeantWord{"results output", "every", "AT TIME <time> INCREMENT = <time> says it"},
    MeantWord{"results output", "interval", "AT TIME <time> INCREMENT = <time> says it"},
    MeantWord{"results output", "output interval", "AT TIME <time> INCREMENT = <time> says it"},
    MeantWord{"results output", "time increment", "AT TIME <time> INCREMENT = <time> says it"},
};

bool begin_with(std::span<const Word> words, std::string_view phrase) {
  return match_phrase(split_phrase(phrase), words) > 0;
}

}  // namespace

std::string find_inner_place(std::span<const Word> words, bool is_block, const TableText& table) {
  for (const RowText& row : table.rows) {
    if (!row.is_block || row.support != Support::supported || !row.contents) continue;
    const TableText& inside = row.contents();
    if ((is_block ? inside.blocks : inside.commands).find(words))
      return fmt::format("it belongs into BEGIN {}", upper(row.phrase));
  }
  return "";
}

std::string find_meaning(std::span<const Word> words, bool is_block, std::span<const Word> title,
                         const TableText& table) {
  for (const MeantWord& meant : meant_words) {
    if (!is_block && begin_with(title, meant.block) && begin_with(words, meant.words))
      return std::string(meant.hint);
  }
  for (const RowText& row : table.rows) {
    const bool is_its_end = row.is_block && is_block && !words.empty() && row.support == Support::supported &&
                            row.phrase.ends_with(" " + fold(words.front().text));
    if (is_its_end) return fmt::format("did you mean 'begin {}'?", row.phrase);
  }
  return "";
}

}  // namespace contactsim
