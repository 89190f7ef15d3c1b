// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace contactsim::test {

/// The numbers of a column, by its place from 0, under the head of a CSV text.
inline std::vector<double> csv_column(const std::string& text, std::size_t place) {
  std::vector<double> values;
  std::istringstream lines(text);
  std::string line;
  std::getline(lines, line);
  while (std::getline(lines, line)) {
    std::istringstream words(line);
    std::string word;
    for (std::size_t i = 0; i <= place; ++i) std::getline(words, word, ',');
    values.push_back(std::stod(word));
  }
  return values;
}

}  // namespace contactsim::test
