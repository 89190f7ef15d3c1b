// SPDX-License-Identifier: BSD-3-Clause
#include "io/import/inp_lines.hpp"

namespace contactsim {

namespace {

std::string_view trim(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  const std::size_t begin = text.find_first_not_of(blanks);
  if (begin == std::string_view::npos) return "";
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string upper_of(std::string_view text) {
  std::string upper;
  for (const char c : trim(text)) upper += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
  return upper;
}

}  // namespace

std::vector<std::string> split_cells(std::string_view line) {
  std::vector<std::string> cells;
  while (!trim(line).empty()) {
    const std::size_t comma = line.find(',');
    cells.emplace_back(trim(line.substr(0, comma)));
    if (comma == std::string_view::npos) break;
    line.remove_prefix(comma + 1);
  }
  return cells;
}

std::string InpKeyword::value(const std::string& parameter) const {
  const auto found = parameters.find(parameter);
  return found == parameters.end() ? "" : found->second;
}

InpLines::InpLines(const std::string& path) : words_(path) {}

bool InpLines::peek() {
  while (!is_waiting_) {
    if (words_.is_at_end()) return false;
    waiting_ = words_.rest_of_line();
    is_waiting_ = !waiting_.empty() && !waiting_.starts_with("**");
  }
  return true;
}

bool InpLines::next_keyword(InpKeyword& keyword) {
  while (peek() && !waiting_.starts_with('*')) is_waiting_ = false;
  if (!peek()) return false;
  std::string line = waiting_;
  keyword = {"", {}, words_.line_number()};
  is_waiting_ = false;
  // A comma at the end of a keyword line goes on with the next.
  while (line.ends_with(',') && peek() && !waiting_.starts_with('*')) {
    line += waiting_;
    is_waiting_ = false;
  }
  const std::vector<std::string> cells = split_cells(line);
  keyword.name = upper_of(std::string_view(cells[0]).substr(1));
  for (std::size_t i = 1; i < cells.size(); ++i) {
    const std::size_t equals = cells[i].find('=');
    std::string value(equals == std::string::npos ? "" : trim(std::string_view(cells[i]).substr(equals + 1)));
    if (value.size() >= 2 && value.front() == '"' && value.back() == '"')
      value = value.substr(1, value.size() - 2);
    keyword.parameters[upper_of(cells[i].substr(0, equals))] = value;
  }
  return true;
}

bool InpLines::next_data(std::vector<std::string>& cells) {
  if (!peek() || waiting_.starts_with('*')) return false;
  cells = split_cells(waiting_);
  is_waiting_ = false;
  return true;
}

}  // namespace contactsim
