// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "parser/binding/arguments.hpp"

/// How the values in commands are read and shown: one reader per kind of value.
namespace contactsim {

struct DeckExpression;

/// How one kind of value is read from a line and shown as a default.
template <class V>
struct Reader {
  std::string syntax;  ///< "<real>"
  std::function<V(Arguments&)> read;
  std::function<std::string(const V&)> show;
  std::optional<NameKind> references = {};  ///< what the names stand for that it reads
};

namespace read {
extern const Reader<double> real, positive, non_negative, share;  ///< the last from 0 to 1
extern const Reader<std::int64_t> integer, positive_integer, non_negative_integer;
extern const Reader<bool> on_off;
extern const Reader<DeckName> name;
extern const Reader<std::string> text, rest_of_line;
extern const Reader<Eigen::Vector3d> vector3;
extern const Reader<std::vector<DeckName>> names;
extern const Reader<std::vector<double>> reals;
extern const Reader<std::vector<std::int64_t>> integers;
/// A name of something that the deck defines, or that the mesh holds; or several, all that remain.
Reader<DeckName> name_of(NameKind kind);
Reader<std::vector<DeckName>> names_of(NameKind kind);
/// The same, where the word ALL need not be defined.
Reader<std::vector<DeckName>> names_of_or_all(NameKind kind);
}  // namespace read

/// EVALUATE EXPRESSION and the like: the text between quotes, or the rest of the line. A mistake in it is
/// kept.
DeckExpression read_expression(Arguments& arguments);

/// "{on|off}": how the choice of a word is written in a syntax.
std::string syntax_of_choice(const Choices& choices);

/// A reader of one of several words, in the order of the enumerators of E (from 0).
template <class E>
Reader<E> choice_of(std::vector<std::string> words) {
  const Choices choices(std::move(words));
  return {syntax_of_choice(choices),
          [choices](Arguments& arguments) { return static_cast<E>(arguments.choice(choices)); },
          [choices](const E& value) { return choices.phrases()[static_cast<std::size_t>(value)]; }};
}

}  // namespace contactsim
