// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace contactsim {

/// The words of a text file, one after the other, with the lines that they stand in.
class TextWords {
 public:
  /// Reads the whole file. Throws FileError.
  explicit TextWords(const std::string& path);

  bool is_at_end();
  /// The next word. Throws FileError at the end.
  std::string_view word();
  /// The next word as a number. Throws FileError when it is none.
  std::int64_t integer();
  double real();
  /// The rest of the line, without its end; "" where there is none.
  std::string_view rest_of_line();

  const std::string& path() const { return path_; }
  int line_number() const { return line_; }
  /// Throws FileError "path: line 17: what".
  [[noreturn]] void fail(const std::string& what) const;

 private:
  void skip_blanks();

  std::string path_, text_;
  std::size_t at_ = 0;
  int line_ = 1;  ///< of the word that was read last
};

/// A whole text as a number. Throws what `words` fails with.
std::int64_t integer_of(std::string_view text, const TextWords& words);
double real_of(std::string_view text, const TextWords& words);

}  // namespace contactsim
