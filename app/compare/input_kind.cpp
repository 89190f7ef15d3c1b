// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/input_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string_view>

#include "core/base/errors.hpp"
#include "core/base/names.hpp"

namespace contactsim {

namespace {

constexpr const char* facet_header = "surface,block,element,side,kind,area";

InputKind find_json_kind(const std::string& path, const std::string& text) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text);
  } catch (const nlohmann::json::parse_error& error) {
    throw FileError(path, fmt::format("no whole JSON, wrong at byte {} of {}", error.byte, text.size()));
  }
  const std::string schema =
      json.contains("schema") && json["schema"].is_string() ? json["schema"].get<std::string>() : "";
  if (schema == "contactsim-surfaces/1") return InputKind::surfaces_json;
  if (schema == "contactsim-summary/1") return InputKind::summary;
  if (schema.empty()) throw FileError(path, "JSON without a schema of contactsim");
  throw FileError(path, fmt::format("JSON of the schema '{}', which cannot be compared", schema));
}

/// The first line that says something; SPYHIS files begin with a comment.
std::string_view first_line(std::string_view text) {
  while (text.starts_with('%')) text.remove_prefix(std::min(text.find('\n'), text.size() - 1) + 1);
  std::string_view line = text.substr(0, text.find('\n'));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

}  // namespace

std::string describe(InputKind kind) {
  switch (kind) {
    case InputKind::surfaces_json:
      return "an ownership table (JSON of --surfaces-json)";
    case InputKind::surfaces_csv:
      return "a list of facets (CSV of --surfaces-csv)";
    case InputKind::summary:
      return "a summary (JSON of --summary)";
    case InputKind::heartbeat:
      return "a heartbeat (CSV)";
    default:
      return "a deck";
  }
}

InputKind find_input_kind(const std::string& path, const std::string& text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == std::string::npos) throw FileError(path, "the file is empty");
  if (text[begin] == '{') return find_json_kind(path, text);
  const std::string_view line = first_line(text);
  if (line == facet_header) return InputKind::surfaces_csv;
  const std::string_view title = line.substr(0, line.find_first_of(", \t"));
  if (fold(title) == "time") return InputKind::heartbeat;
  const std::string folded = fold(text.substr(0, std::size_t{1} << 16));
  for (const char* word : {"begin_", "contact_", "skin_all", "include"}) {
    if (folded.find(word) != std::string::npos && text.find('\0') == std::string::npos)
      return InputKind::deck;
  }
  throw FileError(path, "neither a table of surfaces, a summary, a heartbeat in CSV nor a deck");
}

}  // namespace contactsim
