// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/explain_variables.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/manual/variable_rows.hpp"
#include "core/base/names.hpp"

namespace contactsim {

std::string explain_variables(std::span<const std::string> words) {
  std::string wanted = fold(fmt::format("{}", fmt::join(words, "_")));
  if (wanted == "output_variables") wanted.clear();
  std::string text;
  for (const VariableText& row : output_variables()) {
    if (row.name.find(wanted) == std::string::npos) continue;
    const std::string size = row.n_components < 2 ? "" : fmt::format("({})", row.n_components);
    text += fmt::format("  {:<8} {:<34} {}\n", row.location, row.name + size, row.help);
  }
  return text.empty() ? "" : "output variables, the number of components in parentheses\n" + text;
}

}  // namespace contactsim
