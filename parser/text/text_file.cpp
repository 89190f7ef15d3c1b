// SPDX-License-Identifier: BSD-3-Clause
#include "parser/text/text_file.hpp"

#include <filesystem>
#include <fstream>
#include <string_view>
#include <system_error>

namespace contactsim {

namespace {

constexpr std::uintmax_t max_file_size = std::uintmax_t{64} << 20;

TextFile refuse(std::string problem, TextFile::Failure failure = TextFile::Failure::unreadable) {
  return {"", std::move(problem), failure};
}

/// What a text is when it is no deck text; "" when it may be one.
std::string find_foreign_format(std::string_view text) {
  if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "a UTF-16 text, save it as UTF-8";
  if (text.starts_with("CDF") || text.starts_with("\x89HDF")) return "a mesh (NetCDF) file, not a text";
  if (text.find('\0') != std::string_view::npos) return "a binary file, not a text";
  return "";
}

}  // namespace

TextFile read_text_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found)
    return refuse("there is no such file", TextFile::Failure::missing);
  if (error) return refuse(error.message());
  if (std::filesystem::is_directory(status)) return refuse("it is a directory");
  if (!std::filesystem::is_regular_file(status)) return refuse("it is not a regular file");
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  if (error) return refuse(error.message());
  if (size > max_file_size) return refuse("it is larger than 64 MiB, too large for a deck");

  std::ifstream file(path, std::ios::binary);
  std::string text(static_cast<std::size_t>(size), '\0');
  if (!file) return refuse("it cannot be opened");
  file.read(text.data(), static_cast<std::streamsize>(size));
  text.resize(static_cast<std::size_t>(file.gcount()));
  if (file.bad()) return refuse("it cannot be read");
  const std::string foreign = find_foreign_format(text);
  if (!foreign.empty()) return refuse("it is " + foreign, TextFile::Failure::not_text);
  return {std::move(text)};
}

TextFile read_no_file(const std::string&) { return refuse("files are not read here"); }

}  // namespace contactsim
