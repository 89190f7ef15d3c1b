// SPDX-License-Identifier: BSD-3-Clause
#include <netcdf.h>

#include "support/exodus_file.hpp"
#include "support/netcdf_check.hpp"

namespace contactsim::test {

ExodusEditor::ExodusEditor(const std::string& path) { check(nc_open(path.c_str(), NC_WRITE, &id_)); }

ExodusEditor::~ExodusEditor() { nc_close(id_); }

int ExodusEditor::find_variable(const std::string& name) const {
  int variable = NC_GLOBAL;
  if (!name.empty()) check(nc_inq_varid(id_, name.c_str(), &variable));
  return variable;
}

std::vector<std::size_t> ExodusEditor::index_of(int variable, std::size_t position) const {
  int rank = 0;
  check(nc_inq_varndims(id_, variable, &rank));
  std::vector<int> dimensions(static_cast<std::size_t>(rank));
  check(nc_inq_vardimid(id_, variable, dimensions.data()));
  std::vector<std::size_t> index(dimensions.size());
  for (std::size_t i = dimensions.size(); i-- > 0;) {
    std::size_t length = 0;
    check(nc_inq_dimlen(id_, dimensions[i], &length));
    index[i] = position % length;
    position /= length;
  }
  return index;
}

ExodusEditor& ExodusEditor::set_value(const std::string& variable, std::size_t position, double value) {
  const int id = find_variable(variable);
  check(nc_put_var1_double(id_, id, index_of(id, position).data(), &value));
  return *this;
}

ExodusEditor& ExodusEditor::set_text(const std::string& variable, std::size_t row, const std::string& text) {
  const std::size_t start[] = {row, 0}, count[] = {1, text.size() + 1};
  check(nc_put_vara_text(id_, find_variable(variable), start, count, text.c_str()));
  return *this;
}

ExodusEditor& ExodusEditor::rename_variable(const std::string& name, const std::string& new_name) {
  check(nc_redef(id_));
  check(nc_rename_var(id_, find_variable(name), new_name.c_str()));
  check(nc_enddef(id_));
  return *this;
}

ExodusEditor& ExodusEditor::rename_dimension(const std::string& name, const std::string& new_name) {
  int dimension = 0;
  check(nc_inq_dimid(id_, name.c_str(), &dimension));
  check(nc_redef(id_));
  check(nc_rename_dim(id_, dimension, new_name.c_str()));
  check(nc_enddef(id_));
  return *this;
}

ExodusEditor& ExodusEditor::add_dimension(const std::string& name, std::size_t length) {
  int dimension = 0;
  check(nc_redef(id_));
  check(nc_def_dim(id_, name.c_str(), length, &dimension));
  check(nc_enddef(id_));
  return *this;
}

int ExodusEditor::define_variable(const std::string& name, int type,
                                  const std::vector<std::string>& dimensions) {
  std::vector<int> ids(dimensions.size());
  for (std::size_t i = 0; i < ids.size(); ++i) check(nc_inq_dimid(id_, dimensions[i].c_str(), &ids[i]));
  int variable = 0;
  check(nc_redef(id_));
  check(nc_def_var(id_, name.c_str(), type, static_cast<int>(ids.size()), ids.data(), &variable));
  return variable;
}

ExodusEditor& ExodusEditor::add_integers(const std::string& name, const std::vector<std::string>& dimensions,
                                         const std::vector<long long>& values) {
  const int variable = define_variable(name, NC_INT, dimensions);
  check(nc_enddef(id_));
  check(nc_put_var_longlong(id_, variable, values.data()));
  return *this;
}

ExodusEditor& ExodusEditor::add_reals(const std::string& name, const std::vector<std::string>& dimensions,
                                      const std::vector<double>& values) {
  const int variable = define_variable(name, NC_DOUBLE, dimensions);
  check(nc_enddef(id_));
  check(nc_put_var_double(id_, variable, values.data()));
  return *this;
}

ExodusEditor& ExodusEditor::add_records(const std::string& name, const std::vector<std::string>& dimensions,
                                        const std::vector<double>& values) {
  const std::size_t start = 0, count = values.size();
  const int variable = define_variable(name, NC_DOUBLE, dimensions);
  check(nc_enddef(id_));
  check(nc_put_vara_double(id_, variable, &start, &count, values.data()));
  return *this;
}

ExodusEditor& ExodusEditor::add_texts(const std::string& name, const std::string& dimension,
                                      const std::vector<std::string>& texts) {
  const std::string width = "len_" + name;
  add_dimension(width, 33);
  define_variable(name, NC_CHAR, {dimension, width});
  check(nc_enddef(id_));
  for (std::size_t row = 0; row < texts.size(); ++row) set_text(name, row, texts[row]);
  return *this;
}

ExodusEditor& ExodusEditor::declare_reals(const std::string& name, const std::vector<std::string>& dimensions,
                                          bool chunked) {
  const int variable = define_variable(name, NC_DOUBLE, dimensions);
  check(nc_def_var_chunking(id_, variable, chunked ? NC_CHUNKED : NC_CONTIGUOUS, nullptr));
  check(nc_enddef(id_));
  return *this;
}

ExodusEditor& ExodusEditor::remove_attribute(const std::string& variable, const std::string& name) {
  check(nc_redef(id_));
  check(nc_del_att(id_, find_variable(variable), name.c_str()));
  check(nc_enddef(id_));
  return *this;
}

ExodusEditor& ExodusEditor::set_attribute(const std::string& variable, const std::string& name,
                                          const std::string& text) {
  check(nc_redef(id_));
  check(nc_put_att_text(id_, find_variable(variable), name.c_str(), text.size(), text.c_str()));
  check(nc_enddef(id_));
  return *this;
}

ExodusEditor& ExodusEditor::set_attribute(const std::string& variable, const std::string& name,
                                          double value) {
  check(nc_redef(id_));
  check(nc_put_att_double(id_, find_variable(variable), name.c_str(), NC_DOUBLE, 1, &value));
  check(nc_enddef(id_));
  return *this;
}

ExodusEditor& ExodusEditor::add_group(const std::string& name) {
  int group = 0;
  check(nc_def_grp(id_, name.c_str(), &group));
  return *this;
}

}  // namespace contactsim::test
