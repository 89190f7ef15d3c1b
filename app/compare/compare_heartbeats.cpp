// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_heartbeats.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/compare/read_number.hpp"
#include "app/reports/csv.hpp"
#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

double largest_of(const std::vector<double>& column) {
  double largest = 0.0;
  for (const double value : column) {
    if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  return largest;
}

/// Where two columns differ.
struct ColumnGap {
  std::size_t line = 0;  ///< the first that passes the tolerance, from 0
  double largest = 0.0;  ///< difference, of all lines that both have
  std::size_t largest_line = 0;
  bool exists = false;
};

ColumnGap find_gap(const std::vector<double>& a, const std::vector<double>& b, const Tolerance& tolerance) {
  const double scale = std::max(largest_of(a), largest_of(b));
  ColumnGap gap;
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    if (!gap.exists && tolerance.is_exceeded(a[i], b[i], scale)) {
      gap.exists = true;
      gap.line = i;
    }
    if (const double by = std::abs(b[i] - a[i]); by > gap.largest) {
      gap.largest = by;
      gap.largest_line = i;
    }
  }
  return gap;
}

Difference describe_gap(const std::string& name, const HeartbeatTable& first, const HeartbeatTable& second,
                        std::pair<std::size_t, std::size_t> columns, const ColumnGap& gap) {
  const std::vector<double>& times = first.columns.front();
  const double a = first.columns[columns.first][gap.line], b = second.columns[columns.second][gap.line];
  return {"column",
          fmt::format("{}: from time {:.6g} on, {} -> {}, by {:.3g}; at most by {:.3g}, at time {:.6g}", name,
                      times[gap.line], format_value(a), format_value(b), b - a, gap.largest,
                      times[gap.largest_line]),
          {{"name", name},
           {"time", times[gap.line]},
           {"first", a},
           {"second", b},
           {"difference", b - a},
           {"largest_difference", gap.largest},
           {"largest_difference_time", times[gap.largest_line]}}};
}

void add_lone_columns(const char* kind, const char* where, const HeartbeatTable& one,
                      const HeartbeatTable& other, std::vector<Difference>& differences) {
  for (std::size_t i = 1; i < one.names.size(); ++i) {
    if (std::ranges::find(other.names, one.names[i]) != other.names.end()) continue;
    differences.push_back(
        {kind, fmt::format("only in the {}: column {}", where, one.names[i]), {{"name", one.names[i]}}});
  }
}

void add_lone_lines(const char* kind, const char* where, const HeartbeatTable& longer,
                    std::size_t n_of_shorter, std::vector<Difference>& differences) {
  const std::size_t n = longer.n_lines() - n_of_shorter;
  const double time = longer.columns.front()[n_of_shorter];
  differences.push_back(
      {kind,
       fmt::format("only in the {}: {} from time {:.6g} on", where, pluralize(n, "line"), time),
       {{"lines", static_cast<std::int64_t>(n)}, {"time", time}}});
}

}  // namespace

HeartbeatTable read_heartbeat(const std::string& path, const std::string& text) {
  HeartbeatTable table;
  for (const auto& [number, fields] : split_csv(text)) {
    const bool is_comment = fields[0].starts_with('%');
    const bool is_units = !table.names.empty() && table.n_lines() == 0 && fields[0].starts_with('[');
    if (is_comment || is_units || fields == table.names) continue;
    if (table.names.empty()) {
      table.names = fields;
      table.columns.resize(fields.size());
      continue;
    }
    if (fields.size() != table.names.size())
      throw FileError(path, fmt::format("line {}: {} in place of {}", number,
                                        pluralize(fields.size(), "value"), table.names.size()));
    for (std::size_t i = 0; i < fields.size(); ++i) {
      const auto value = read_number(fields[i]);
      if (!value) throw FileError(path, fmt::format("line {}: '{}' is no number", number, fields[i]));
      table.columns[i].push_back(*value);
    }
  }
  return table;
}

std::vector<Difference> compare_heartbeats(const HeartbeatTable& first, const HeartbeatTable& second,
                                           const Tolerance& tolerance) {
  std::vector<Difference> differences;
  add_lone_columns("column_only_in_first", "first", first, second, differences);
  add_lone_columns("column_only_in_second", "second", second, first, differences);
  for (std::size_t i = 0; i < first.names.size(); ++i) {
    const auto found = std::ranges::find(second.names, first.names[i]);
    const bool is_there = i == 0 || found != second.names.end();
    if (!is_there) continue;
    const std::size_t j = i == 0 ? 0 : static_cast<std::size_t>(found - second.names.begin());
    const ColumnGap gap = find_gap(first.columns[i], second.columns[j], tolerance);
    if (gap.exists) differences.push_back(describe_gap(first.names[i], first, second, {i, j}, gap));
  }
  const std::size_t n = first.n_lines(), m = second.n_lines();
  if (n > m) add_lone_lines("lines_only_in_first", "first", first, m, differences);
  if (m > n) add_lone_lines("lines_only_in_second", "second", second, n, differences);
  return differences;
}

}  // namespace contactsim
