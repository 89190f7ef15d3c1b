// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <initializer_list>
#include <vector>

#include "parser/commands/block_rows.hpp"

/// Tables put together from lists of rows that several block types share.
namespace contactsim {

/// Several lists as one, in order.
template <class T>
std::vector<Row<T>> joined(std::initializer_list<std::vector<Row<T>>> lists) {
  std::vector<Row<T>> all;
  for (const auto& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

/// Rows of a Part, bound into that member of T.
template <class T, class Part>
std::vector<Row<T>> lift_all(const std::vector<Row<Part>>& rows_of_part, Part T::*part) {
  std::vector<Row<T>> lifted;
  lifted.reserve(rows_of_part.size());
  for (const Row<Part>& row_of_part : rows_of_part) lifted.push_back(lift(row_of_part, part));
  return lifted;
}

/// The rows as one choice.
template <class T>
std::vector<Row<T>> one_of(const Choice& choice, std::vector<Row<T>> rows) {
  for (Row<T>& row : rows) row.text.choice = choice;
  return rows;
}

/// The rows, of which the first is required.
template <class T>
std::vector<Row<T>> first_required(std::vector<Row<T>> rows) {
  rows.front() = std::move(rows.front()).required();
  return rows;
}

}  // namespace contactsim
