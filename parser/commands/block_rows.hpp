// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parser/commands/rows.hpp"

/// The functions that make the rows of blocks, and that carry rows from one table to another.
namespace contactsim {

/// A block that is read and has no effect; `help` says why.
template <class T>
Row<T> ignored_block(std::string_view phrase, std::string_view help) {
  return {{std::string(phrase), "[<name>]", std::string(help), "none", Support::ignored,
           RowText::Matches::phrase, true}};
}

/// An ignored block whose lines `explain` can list; they are not read.
template <class T>
Row<T> ignored_block(std::string_view phrase, const std::function<const TableText&()>& contents,
                     std::string_view help) {
  Row<T> made = ignored_block<T>(phrase, help);
  made.text.contents = contents;
  return made;
}

template <class T>
Row<T> refused_block(std::string_view phrase, std::string_view help) {
  return {{std::string(phrase), "[<name>]", std::string(help), "none", Support::refused,
           RowText::Matches::phrase, true}};
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

/// A block that is added to a list.
template <class T, class Part>
Row<T> block(std::string_view phrase, Naming naming, const Table<Part>& (*table)(),
             std::vector<Part> T::*list, std::string_view help) {
  return block<T, Part>(
      phrase, naming, table, [list](T& target, Part part) { (target.*list).push_back(std::move(part)); },
      help);
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
