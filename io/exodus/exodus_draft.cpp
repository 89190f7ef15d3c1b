// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/exodus_draft.hpp"

#include <algorithm>
#include <utility>

namespace contactsim {

int ExodusDraft::add_dimension(const std::string& name, std::size_t length) {
  lengths_[name] = length;
  return dimensions_[name] = file_.define_dimension(name, length);
}

int ExodusDraft::add_integers(const std::string& name, const std::vector<int>& dimensions,
                              std::function<std::vector<std::int32_t>()> make) {
  const int variable = file_.define_variable(name, NetcdfType::int32, dimensions);
  writes_.push_back([this, variable, make = std::move(make)] { file_.write(variable, make()); });
  return variable;
}

int ExodusDraft::add_ids(const std::string& name, int dimension,
                         std::function<std::vector<std::int64_t>()> make) {
  const NetcdfType type = format_.has_wide_ids ? NetcdfType::int64 : NetcdfType::int32;
  const int variable = file_.define_variable(name, type, {dimension});
  // netCDF narrows them.
  writes_.push_back([this, variable, make = std::move(make)] { file_.write(variable, make()); });
  return variable;
}

int ExodusDraft::add_reals(const std::string& name, const std::vector<int>& dimensions,
                           std::function<std::vector<double>()> make) {
  const int variable = file_.define_variable(name, NetcdfType::float64, dimensions);
  writes_.push_back([this, variable, make = std::move(make)] { file_.write(variable, make()); });
  return variable;
}

int ExodusDraft::add_texts(const std::string& name, std::vector<int> dimensions, const std::string& width,
                           std::vector<std::string> texts) {
  const std::size_t n_characters = lengths_.at(width);
  for (std::string& text : texts) text.resize(std::min(text.size(), n_characters - 1));
  dimensions.push_back(dimension(width));
  const int variable = file_.define_variable(name, NetcdfType::text, dimensions);
  writes_.push_back([this, variable, n_characters, texts = std::move(texts)] {
    file_.write(variable, n_characters, texts);
  });
  return variable;
}

void ExodusDraft::add_id_rows(const std::string& count, const std::string& prefix, const IdRows& rows) {
  if (rows.ids.empty()) return;
  const int n_rows = add_dimension(count, rows.ids.size());
  add_integers(prefix + "_status", {n_rows}, [status = rows.status] { return status; });
  const int ids = add_ids(prefix + "_prop1", n_rows, [ids = rows.ids] { return ids; });
  file_.set_text(ids, "name", "ID");
  add_texts(prefix + "_names", {n_rows}, "len_name", rows.names);
}

void ExodusDraft::write() {
  file_.end_definitions();
  for (const auto& write : writes_) write();
}

}  // namespace contactsim
