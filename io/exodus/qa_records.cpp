// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/qa_records.hpp"

#include "io/pieces/exodus_file.hpp"

namespace contactsim {

std::vector<QaRecord> read_qa_records(const std::string& path) {
  const ExodusFile file(path);
  const auto variable = file.find_variable("qa_records");
  constexpr std::size_t n_texts = 4;
  if (!variable || !variable->is_text || variable->shape.size() != 3 || variable->shape[1] != n_texts)
    return {};
  const std::vector<std::string> texts = file.read_texts(*variable);
  std::vector<QaRecord> records;
  for (std::size_t i = 0; i + n_texts <= texts.size(); i += n_texts)
    records.push_back({texts[i], texts[i + 1], texts[i + 2], texts[i + 3]});
  return records;
}

}  // namespace contactsim
