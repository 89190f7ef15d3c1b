// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/compare_files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>

#include "app/compare/compare_heartbeats.hpp"
#include "app/compare/compare_ownership.hpp"
#include "app/compare/compare_summaries.hpp"
#include "app/compare/ownership_table.hpp"
#include "core/base/errors.hpp"

namespace contactsim {

namespace {

OwnershipTable read_table(const ComparedFile& file) {
  OwnershipTable table;
  if (file.kind == InputKind::surfaces_json) {
    read_surfaces_json(file.path, file.text, table);
  } else {
    read_surfaces_csv(file.path, file.text, table);
  }
  return table;
}

const char* name_of_kind(InputKind kind) {
  if (kind == InputKind::summary) return "summary";
  return kind == InputKind::heartbeat ? "heartbeat" : "ownership";
}

}  // namespace

ComparedFile read_compared_file(const std::string& path) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) throw FileError(path, "this is a directory, not a file");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path, "cannot be read (" + std::generic_category().message(errno) + ")");
  std::string text{std::istreambuf_iterator<char>(file), {}};
  const InputKind kind = find_input_kind(path, text);
  return {path, std::move(text), kind};
}

FileComparison compare_files(const ComparedFile& first, const ComparedFile& second,
                             const ComparisonSettings& settings) {
  if (first.kind != second.kind)
    throw FileError(second.path, fmt::format("this is {}, but {} is {}", describe(second.kind), first.path,
                                             describe(first.kind)));
  if (settings.lists_faces && first.kind != InputKind::surfaces_csv)
    throw FileError(first.path, fmt::format("--faces needs lists of facets (CSV of --surfaces-csv) or decks, "
                                            "but this is {}",
                                            describe(first.kind)));
  FileComparison comparison{name_of_kind(first.kind), first.path, second.path, {}};
  if (first.kind == InputKind::summary) {
    comparison.differences =
        compare_summaries({first.path, first.text}, {second.path, second.text}, settings.tolerance);
  } else if (first.kind == InputKind::heartbeat) {
    comparison.differences = compare_heartbeats(read_heartbeat(first.path, first.text),
                                                read_heartbeat(second.path, second.text), settings.tolerance);
  } else {
    comparison.differences =
        compare_ownership(read_table(first), read_table(second), settings.tolerance, settings.lists_faces);
  }
  return comparison;
}

}  // namespace contactsim
