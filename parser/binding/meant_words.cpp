// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/meant_words.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

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
    MeantWord{"results output", "interval", "AT TIME <time> INCREMENT = <time> says it"},
    MeantWord{"results output", "output interval", "AT TIME <time> INCREMENT = <time> says it"},
    MeantWord{"results output", "time increment", "AT TIME <time> INCREMENT = <time> says it"},
};

bool begin_with(std::span<const Word> words, std::string_view phrase) {
  return match_phrase(split_phrase(phrase), words) > 0;
}

}  // namespace

std::string find_meaning(std::span<const Word> words, std::span<const Word> title, const TableText& table) {
  for (const MeantWord& meant : meant_words) {
    if (begin_with(title, meant.block) && begin_with(words, meant.words)) return std::string(meant.hint);
  }
  for (const RowText& row : table.rows) {
    if (row.is_block && row.support == Support::supported && row.contents &&
        row.contents().commands.find(words))
      return fmt::format("it belongs into BEGIN {}", upper(row.phrase));
  }
  return "";
}

}  // namespace contactsim
