// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/run_records.hpp"

#include "io/exodus/exodus_conventions.hpp"
#include "io/pieces/exodus_file.hpp"

namespace contactsim {

std::vector<std::string> read_info_lines(const std::string& path) {
  const ExodusFile file(path);
  const auto variable = file.find_variable("info_records");
  if (!variable || !variable->is_text || variable->shape.size() != 2) return {};
  std::vector<std::string> lines;
  bool continues = false;
  for (std::string& record : file.read_stored_texts(*variable)) {
    const bool is_full = record.size() + 1 >= exodus_line_length;
    if (continues) {
      lines.back() += record;
    } else {
      lines.push_back(std::move(record));
    }
    continues = is_full;
  }
  return lines;
}

GlobalHistory read_global_history(const std::string& path) {
  const ExodusFile file(path);
  const auto names = file.find_variable("name_glo_var"), values = file.find_variable("vals_glo_var"),
             times = file.find_variable("time_whole");
  if (!names || !values || !times) return {};
  GlobalHistory history;
  history.names = file.read_texts(*names);
  const std::size_t n_names = history.names.size(), n_times = times->size();
  if (values->shape != std::vector<std::size_t>{n_times, n_names} || values->is_text)
    file.fail("variable vals_glo_var does not match the names and times of its global variables");
  history.times.resize(n_times);
  file.read_double(*times, history.times);
  std::vector<double> rows(n_times * n_names);
  file.read_double(*values, rows);
  history.columns.assign(n_names, std::vector<double>(n_times));
  for (std::size_t i = 0; i < rows.size(); ++i) history.columns[i % n_names][i / n_names] = rows[i];
  return history;
}

}  // namespace contactsim
