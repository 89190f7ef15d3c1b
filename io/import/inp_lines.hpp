// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "io/import/text_words.hpp"

namespace contactsim {

/// The cells between commas of a line, without blanks around them; a comma at its end adds none.
std::vector<std::string> split_cells(std::string_view line);

/// A keyword line of an input file and the data lines behind it.
struct InpKeyword {
  std::string name;                               ///< upper case, without the star: "ELEMENT"
  std::map<std::string, std::string> parameters;  ///< names in upper case, values as written
  int line = 0;

  bool has(const std::string& parameter) const { return parameters.contains(parameter); }
  /// The value of a parameter, "" when it is not given.
  std::string value(const std::string& parameter) const;
};

/// Goes through an input file keyword by keyword.
class InpLines {
 public:
  explicit InpLines(const std::string& path);

  /// Whether there is another keyword; data lines that nobody has asked for are passed over.
  bool next_keyword(InpKeyword& keyword);
  /// Whether there is another data line of the keyword.
  bool next_data(std::vector<std::string>& cells);

  /// For its messages.
  const TextWords& words() const { return words_; }

 private:
  /// Reads on to a line that is neither empty nor a comment.
  bool peek();

  TextWords words_;
  std::string waiting_;
  bool is_waiting_ = false;
};

}  // namespace contactsim
