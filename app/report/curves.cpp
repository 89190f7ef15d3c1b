// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/curves.hpp"

#include <algorithm>
#include <filesystem>
#include <map>

#include "app/compare/compare_heartbeats.hpp"
#include "app/reports/csv.hpp"
#include "core/base/names.hpp"
#include "io/exodus/run_records.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_column_times = 1000;

/// The vector that a column is a component of, or its own name.
std::string base_of(const std::string& name) {
  for (const char* end : {"_x", "_y", "_z"}) {
    if (name.size() > 2 && name.ends_with(end)) return name.substr(0, name.size() - 2);
  }
  return name;
}

bool is_energy(const std::string& name) {
  static const char* const plain[] = {"kinetic", "internal", "external", "friction", "hourglass"};
  const std::string folded = fold(name);
  return folded.find("energy") != std::string::npos || std::ranges::find(plain, folded) != std::end(plain);
}

/// Positions of the times to keep.
std::vector<std::size_t> choose_times(std::size_t n) {
  std::vector<std::size_t> chosen;
  const std::size_t n_chosen = std::min(n, max_column_times);
  for (std::size_t i = 0; i < n_chosen; ++i)
    chosen.push_back(n_chosen < 2 ? 0 : i * (n - 1) / (n_chosen - 1));
  return chosen;
}

std::vector<double> pick(const std::vector<double>& values, const std::vector<std::size_t>& chosen) {
  std::vector<double> picked;
  for (const std::size_t i : chosen) picked.push_back(values[i]);
  return picked;
}

}  // namespace

std::vector<CurveChart> make_charts(const ColumnTable& table) {
  const std::vector<std::size_t> chosen = choose_times(table.times.size());
  if (chosen.empty()) return {};
  std::vector<CurveChart> charts;
  std::map<std::string, std::size_t> positions;
  for (std::size_t i = 0; i < table.names.size(); ++i) {
    const bool joins_energies = is_energy(table.names[i]);
    const std::string title = joins_energies ? "Energies" : base_of(table.names[i]);
    const auto [at, is_new] = positions.try_emplace(title, charts.size());
    if (is_new) {
      const std::string given = table.dimensions.empty() ? "" : table.dimensions[i];
      charts.push_back(
          {title, table.source, joins_energies ? "energy" : given, pick(table.times, chosen), {}});
    }
    charts[at->second].curves.push_back({table.names[i], pick(table.columns[i], chosen)});
  }
  return charts;
}

ColumnTable read_heartbeat_columns(const std::string& path, const std::string& text) {
  HeartbeatTable read = read_heartbeat(path, text);
  ColumnTable table;
  table.source = std::filesystem::path(path).filename().string();
  if (read.names.empty()) return table;
  table.times = std::move(read.columns.front());
  table.names.assign(read.names.begin() + 1, read.names.end());
  table.columns.assign(read.columns.begin() + 1, read.columns.end());
  for (const CsvLine& line : split_csv(std::string_view(text).substr(0, 100000))) {
    if (!line.fields[0].starts_with('[') || line.fields.size() != read.names.size()) continue;
    for (std::size_t i = 1; i < line.fields.size(); ++i) {
      const std::string& unit = line.fields[i];
      const bool is_bracketed = unit.size() > 1 && unit.front() == '[' && unit.back() == ']';
      table.dimensions.push_back(is_bracketed ? unit.substr(1, unit.size() - 2) : unit);
    }
    break;
  }
  return table;
}

ColumnTable read_global_columns(const std::string& path) {
  GlobalHistory history = read_global_history(path);
  ColumnTable table;
  table.source = std::filesystem::path(path).filename().string();
  table.names = std::move(history.names);
  table.times = std::move(history.times);
  table.columns = std::move(history.columns);
  return table;
}

}  // namespace contactsim
