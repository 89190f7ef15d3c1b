// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "parser/binding/table.hpp"
#include "parser/commands/readers.hpp"

/// The functions that make the rows of commands, in which the tables are written.
namespace contactsim {

/// A T as it is before any command.
template <class T>
const T& defaults() {
  static const T value{};
  return value;
}

/// What a field holds before any command sets it, as text: the default that `explain` prints.
template <class V, class F>
std::string default_of(const Reader<V>& reader, const F& field) {
  if constexpr (std::is_same_v<F, std::optional<V>>) {
    return field ? reader.show(*field) : "none";
  } else if constexpr (std::is_same_v<F, V>) {
    return reader.show(field);
  } else {
    return "none";  // a list that commands add to
  }
}

template <class F>
inline constexpr bool is_list = false;
template <class E>
inline constexpr bool is_list<std::vector<E>> = true;

/// Whether a second value replaces the first in a field; lists grow.
template <class V, class F>
inline constexpr bool replaces = std::is_assignable_v<F&, V> && !is_list<F>;

/// Puts a value into a field: sets it, or adds it to a list of such values.
template <class V, class F>
void store(V value, F& field) {
  if constexpr (replaces<V, F>) {
    field = std::move(value);
  } else if constexpr (std::is_same_v<V, F>) {
    field.insert(field.end(), value.begin(), value.end());
  } else {
    field.push_back(std::move(value));
  }
}

/// A command with one value that goes into a field. The default shown is the field's own unless one is given
/// (a field that is NaN or empty by default should give one, "critical step", or be required()).
template <class T, class V, class F>
Row<T> row(std::string_view phrase, const Reader<V>& reader, F T::*field, std::string_view help,
           std::string_view default_text = "") {
  RowText text{std::string(phrase), "= " + reader.syntax, std::string(help),
               default_text.empty() ? default_of(reader, defaults<T>().*field) : std::string(default_text)};
  text.is_single = replaces<V, F>;
  if (reader.references) text.references.push_back(*reader.references);
  return {std::move(text), [read_value = reader.read, field](Arguments& arguments, T& target) {
            store(read_value(arguments), target.*field);
          }};
}

/// A command with a shape of its own.
template <class T>
Row<T> row(std::string_view phrase, std::string_view syntax, std::function<void(Arguments&, T&)> read_command,
           std::string_view help, std::string_view default_text) {
  return {{std::string(phrase), std::string(syntax), std::string(help), std::string(default_text)},
          std::move(read_command)};
}

/// The lines of a table: those that begin with a number.
template <class T>
Row<T> numbers(std::string_view syntax, std::function<void(Arguments&, T&)> read_line,
               std::string_view help) {
  return {{"", std::string(syntax), std::string(help), "none", Support::supported, RowText::Matches::numbers},
          std::move(read_line)};
}

/// The lines of an opaque block: those that no other row knows.
template <class T>
Row<T> anything(std::string_view syntax, std::function<void(Arguments&, T&)> read_line,
                std::string_view help) {
  return {
      {"", std::string(syntax), std::string(help), "none", Support::supported, RowText::Matches::anything},
      std::move(read_line)};
}

/// A command without arguments that switches a field on.
template <class T>
Row<T> flag(std::string_view phrase, bool T::*field, std::string_view help) {
  return {{std::string(phrase), "", std::string(help), "off"},
          [field](Arguments&, T& target) { target.*field = true; }};
}

/// A command that is read and has no effect; `help` says why.
template <class T>
Row<T> ignored(std::string_view phrase, std::string_view syntax, std::string_view help) {
  return {{std::string(phrase), std::string(syntax), std::string(help), "none", Support::ignored}};
}

/// A command that contactsim does not do and that would change the answer; `help` says what to do instead.
template <class T>
Row<T> refused(std::string_view phrase, std::string_view syntax, std::string_view help) {
  return {{std::string(phrase), std::string(syntax), std::string(help), "none", Support::refused}};
}

}  // namespace contactsim
