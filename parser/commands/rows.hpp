// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "parser/table.hpp"

/// The vocabulary in which the tables of commands are written: readers and the functions that make rows.
namespace contactsim {

/// How one kind of value is read from a line and shown as a default.
template <class V>
struct Reader {
  std::string syntax;  ///< "<real>"
  std::function<V(Arguments&)> read;
  std::function<std::string(const V&)> show;
};

namespace read {
extern const Reader<double> real, positive, non_negative;
extern const Reader<std::int64_t> integer, positive_integer, non_negative_integer;
extern const Reader<bool> on_off;
extern const Reader<DeckName> name;
extern const Reader<std::string> text, rest_of_line;
extern const Reader<Eigen::Vector3d> vector3;
extern const Reader<std::vector<DeckName>> names;
extern const Reader<std::vector<double>> reals;
extern const Reader<std::vector<std::int64_t>> integers;
}  // namespace read

/// A reader of one of several words, in the order of the enumerators of E (from 0).
template <class E>
Reader<E> choice_of(std::vector<std::string> words) {
  return {fmt::format("{{{}}}", fmt::join(words, "|")),
          [words](Arguments& arguments) { return static_cast<E>(arguments.choice(words)); },
          [words](const E& value) { return words[static_cast<std::size_t>(value)]; }};
}

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
constexpr bool is_list = false;
template <class E>
constexpr bool is_list<std::vector<E>> = true;

/// Whether a second value replaces the first in a field; lists grow.
template <class V, class F>
constexpr bool replaces = std::is_assignable_v<F&, V> && !is_list<F>;

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
/// (a field that is NaN or empty by default should give one: "required", "critical step").
template <class T, class V, class F>
Row<T> row(std::string_view phrase, const Reader<V>& reader, F T::*field, std::string_view help,
           std::string_view default_text = "") {
  RowText text{std::string(phrase), "= " + reader.syntax, std::string(help),
               default_text.empty() ? default_of(reader, defaults<T>().*field) : std::string(default_text)};
  text.is_single = replaces<V, F>;
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
Row<T> numbers(std::string_view syntax, std::function<void(Arguments&, T&)> read_line, std::string_view help) {
  return {{"", std::string(syntax), std::string(help), "none", Support::supported, RowText::Matches::numbers},
          std::move(read_line)};
}

/// The lines of an opaque block: those that no other row knows.
template <class T>
Row<T> anything(std::string_view syntax, std::function<void(Arguments&, T&)> read_line, std::string_view help) {
  return {{"", std::string(syntax), std::string(help), "none", Support::supported, RowText::Matches::anything},
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

template <class T>
Row<T> ignored_block(std::string_view phrase, std::string_view help) {
  return {{std::string(phrase), "[<name>]", std::string(help), "none", Support::ignored, RowText::Matches::phrase,
           true}};
}

/// An ignored block whose lines `explain` can list; they are not read.
template <class T>
Row<T> ignored_block(std::string_view phrase, std::function<const TableText&()> contents, std::string_view help) {
  Row<T> made = ignored_block<T>(std::string(phrase), std::string(help));
  made.text.contents = std::move(contents);
  return made;
}

template <class T>
Row<T> refused_block(std::string_view phrase, std::string_view help) {
  return {{std::string(phrase), "[<name>]", std::string(help), "none", Support::refused, RowText::Matches::phrase,
           true}};
}

/// A row of a shared table, lifted into a T that holds the Part it binds into.
///   part_of  finds the part of a target
template <class T, class Part>
Row<T> lift(const Row<Part>& row_of_part, std::function<Part&(T&)> part_of) {
  Row<T> lifted{row_of_part.text};
  if (row_of_part.read_command) {
    lifted.read_command = [read_part = row_of_part.read_command, part_of](Arguments& arguments, T& target) {
      read_part(arguments, part_of(target));
    };
  }
  if (row_of_part.read_block) {
    lifted.read_block = [read_part = row_of_part.read_block, part_of](
                            const Block& found, const DeckName& name, T& target, Binding& binding) {
      read_part(found, name, part_of(target), binding);
    };
  }
  return lifted;
}

/// The same for a part that is a member.
template <class T, class Part>
Row<T> lift(const Row<Part>& row_of_part, Part T::*part) {
  return lift<T, Part>(row_of_part, [part](T& target) -> Part& { return target.*part; });
}

/// Whether a block must carry a name.
enum class Naming { none, optional, required };

std::string syntax_of(Naming naming);

/// Throws ArgumentError when a block lacks a name that it must have, or has one that it may not.
void check_name(const Block& block, const DeckName& name, Naming naming);

/// A block bound into a Part. `add(target, part)` puts it where it belongs. A Part has a member `DeckName
/// name`; its location is that of the name, or of BEGIN.
///   table  function that returns the block's table, called when it is first needed
template <class T, class Part>
Row<T> block(std::string_view phrase, Naming naming, const Table<Part>& (*table)(),
             std::function<void(T&, Part)> add, std::string_view help) {
  Row<T> made{{std::string(phrase), syntax_of(naming), std::string(help), "none", Support::supported,
               RowText::Matches::phrase, true, [table]() -> const TableText& { return table().text(); }}};
  made.read_block = [naming, table, add](const Block& found, const DeckName& name, T& target,
                                         Binding& binding) {
    check_name(found, name, naming);
    Part part;
    part.name = name;
    table().bind(found, part, binding);
    add(target, std::move(part));
  };
  return made;
}

/// The same block row, whose problems count only when the definition is used: an unused definition is not
/// judged as if it were used.
///   kind  "material", the first part of the definition's use_key
template <class T>
Row<T> held(std::string kind, Row<T> row) {
  row.read_block = [kind = std::move(kind), read_block = std::move(row.read_block)](
                       const Block& found, const DeckName& name, T& target, Binding& binding) {
    bind_held(binding, use_key(kind, name.text),
              [&](Binding& inner) { read_block(found, name, target, inner); });
  };
  return row;
}

/// A block that is added to a list.
template <class T, class Part>
Row<T> block(std::string_view phrase, Naming naming, const Table<Part>& (*table)(), std::vector<Part> T::*list,
             std::string_view help) {
  return block<T, Part>(
      std::string(phrase), naming, table,
      [list](T& target, Part part) { (target.*list).push_back(std::move(part)); }, std::string(help));
}

/// A block whose commands go into a part that is there once; several such blocks add up.
template <class T, class Part>
Row<T> block(std::string_view phrase, Naming naming, const Table<Part>& (*table)(), Part T::*part,
             std::string_view help) {
  Row<T> made{{std::string(phrase), syntax_of(naming), std::string(help), "none", Support::supported,
               RowText::Matches::phrase, true, [table]() -> const TableText& { return table().text(); }}};
  made.read_block = [naming, table, part](const Block& found, const DeckName& name, T& target,
                                          Binding& binding) {
    check_name(found, name, naming);
    table().bind(found, target.*part, binding);
  };
  return made;
}

/// A block whose commands go into the definition around it.
template <class T>
Row<T> block_into(std::string_view phrase, Naming naming, const Table<T>& (*table)(), std::string_view help) {
  Row<T> made{{std::string(phrase), syntax_of(naming), std::string(help), "none", Support::supported,
               RowText::Matches::phrase, true, [table]() -> const TableText& { return table().text(); }}};
  made.read_block = [naming, table](const Block& found, const DeckName& name, T& target, Binding& binding) {
    check_name(found, name, naming);
    table().bind(found, target, binding);
  };
  return made;
}

}  // namespace contactsim
