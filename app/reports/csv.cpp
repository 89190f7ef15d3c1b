// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/csv.hpp"

#include <utility>

namespace contactsim {

namespace {

/// Cuts a text into fields and lines, a character at a time.
class CsvSplitter {
 public:
  void add(char c) {
    if (c == '\n') ++n_line_ends_;
    if (is_quoted_) {
      add_quoted(c);
    } else if (c == '"' && (field_.empty() || was_quoted_)) {
      if (was_quoted_) field_ += '"';  // the second of a doubled quote
      is_quoted_ = was_quoted_ = true;
    } else if (c == ',') {
      end_field();
    } else if (c == '\n') {
      end_line();
    } else if (c == ' ' || c == '\t' || c == '\r') {
      if (!field_.empty() && !was_quoted_) blanks_ += c;
    } else {
      field_ += std::exchange(blanks_, "") + c;
    }
  }

  std::vector<CsvLine> finish() {
    end_line();
    return std::move(lines_);
  }

 private:
  void add_quoted(char c) {
    if (c == '"') {
      is_quoted_ = false;
    } else {
      field_ += c;
    }
  }
  void end_field() {
    line_.fields.push_back(std::exchange(field_, ""));
    blanks_.clear();
    was_quoted_ = is_quoted_ = false;
  }
  void end_line() {
    const bool is_empty = line_.fields.empty() && field_.empty() && !was_quoted_;
    end_field();
    if (!is_empty) lines_.push_back(line_);
    line_ = {n_line_ends_ + 1, {}};
  }

  std::vector<CsvLine> lines_;
  CsvLine line_{1, {}};
  std::string field_, blanks_;
  bool is_quoted_ = false, was_quoted_ = false;
  int n_line_ends_ = 0;
};

}  // namespace

std::vector<CsvLine> split_csv(std::string_view text) {
  CsvSplitter splitter;
  for (const char c : text) splitter.add(c);
  return splitter.finish();
}

}  // namespace contactsim
