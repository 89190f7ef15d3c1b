// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/piece_files.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <filesystem>
#include <system_error>

#include "core/base/errors.hpp"
#include "core/base/file_paths.hpp"

namespace contactsim {

namespace {

namespace fs = std::filesystem;

std::size_t count_digits(std::size_t number) { return fmt::formatted_size("{}", number); }

std::optional<std::size_t> read_digits(std::string_view text) {
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

}  // namespace

std::string PieceFiles::path(std::size_t piece) const {
  return fmt::format("{}.{}.{:0{}}", base, count, piece, width);
}

PieceFiles name_pieces(const std::string& base, std::size_t count) {
  return {base, count, count_digits(count)};
}

std::optional<PieceFiles> parse_piece_path(const std::string& path) {
  const std::size_t last = path.rfind('.');
  if (last == std::string::npos || last == 0) return std::nullopt;
  const std::size_t first = path.rfind('.', last - 1);
  if (first == std::string::npos || first == 0 || path[first - 1] == '/') return std::nullopt;
  const std::string_view text(path);
  const auto count = read_digits(text.substr(first + 1, last - first - 1));
  const auto piece = read_digits(text.substr(last + 1));
  if (!count || !piece || *piece >= *count) return std::nullopt;
  const PieceFiles files{path.substr(0, first), *count, text.size() - last - 1};
  const bool is_usual = files.width == count_digits(*count) ||
                        files.width == count_digits(std::max<std::size_t>(*count, 2) - 1);
  return is_usual && files.path(*piece) == path ? std::optional(files) : std::nullopt;
}

std::vector<PieceFiles> find_decompositions(const std::string& base) {
  std::vector<PieceFiles> found;
  const std::string begin = fs::path(base).filename().string() + ".";
  std::error_code error;
  for (fs::directory_iterator entry(folder_of(base), error), end; !error && entry != end;
       entry.increment(error)) {
    const std::string name = entry->path().filename().string();
    if (!name.starts_with(begin)) continue;
    const auto files = parse_piece_path(base + "." + name.substr(begin.size()));
    if (files && files->base == base && std::ranges::find(found, *files) == found.end())
      found.push_back(*files);
  }
  std::ranges::sort(found, {}, [](const PieceFiles& files) { return std::pair(files.count, files.width); });
  return found;
}

std::string find_exodus_path(const std::string& path, std::size_t n_ranks) {
  std::error_code ignored;
  if (fs::status(path, ignored).type() != fs::file_type::not_found) return path;
  const std::vector<PieceFiles> found = find_decompositions(path);
  if (found.empty()) return path;
  if (found.size() == 1) return found.front().path(0);
  const auto of_ranks = std::ranges::find(found, n_ranks, &PieceFiles::count);
  if (of_ranks != found.end() && std::ranges::count(found, n_ranks, &PieceFiles::count) == 1)
    return of_ranks->path(0);
  std::vector<std::string> first_pieces;
  for (const PieceFiles& files : found) first_pieces.push_back(files.path(0));
  throw FileError(path,
                  fmt::format("there is no such file, but several decompositions of it: name one by its "
                              "first piece, {}",
                              fmt::join(first_pieces, " or ")));
}

}  // namespace contactsim
