// SPDX-License-Identifier: BSD-3-Clause
#include "support/exodus_file.hpp"

#include <netcdf.h>

#include <algorithm>
#include <functional>

#include "support/netcdf_check.hpp"

namespace contactsim::test {

namespace {

int creation_mode(FileFormat format) {
  switch (format) {
    case FileFormat::cdf1:
      return NC_CLOBBER;
    case FileFormat::cdf2:
      return NC_CLOBBER | NC_64BIT_OFFSET;
    case FileFormat::cdf5:
      return NC_CLOBBER | NC_64BIT_DATA;
    case FileFormat::netcdf4:
      return NC_CLOBBER | NC_NETCDF4;
    case FileFormat::netcdf4_classic:
      break;
  }
  return NC_CLOBBER | NC_NETCDF4 | NC_CLASSIC_MODEL;
}

std::vector<long long> from_one(const std::vector<NodeIndex>& nodes) {
  std::vector<long long> numbers;
  for (NodeIndex node : nodes) numbers.push_back(static_cast<long long>(node.value) + 1);
  return numbers;
}

/// Defines everything and keeps the data for the end of the define phase.
class Writer {
 public:
  Writer(const std::string& path, const Mesh& mesh, const ExodusLayout& layout)
      : mesh_(mesh), layout_(layout), integers_(layout.wide_integers ? NC_INT64 : NC_INT) {
    check(nc_create(path.c_str(), creation_mode(layout.format), &id_));
  }

  void write() {
    define_globals();
    define_nodes();
    for (std::size_t i = 0; i < mesh_.blocks().size(); ++i)
      define_block(mesh_.blocks()[i], std::to_string(i + 1));
    for (std::size_t i = 0; i < mesh_.side_sets().size(); ++i)
      define_set(mesh_.side_sets()[i], std::to_string(i + 1));
    for (std::size_t i = 0; i < mesh_.node_sets().size(); ++i)
      define_set(mesh_.node_sets()[i], std::to_string(i + 1));
    define_list(mesh_.blocks(), "num_el_blk", "eb", [](auto& block) { return block.n_elements > 0; });
    define_list(mesh_.side_sets(), "num_side_sets", "ss", [](auto& set) { return !set.sides.empty(); });
    define_list(mesh_.node_sets(), "num_node_sets", "ns", [](auto& set) { return !set.nodes.empty(); });
    for (const Assembly& assembly : mesh_.assemblies()) define_assembly(assembly);
    check(nc_enddef(id_));
    for (const auto& put : puts_) put();
    check(nc_close(id_));
  }

 private:
  int dimension(const std::string& name, std::size_t length) {
    int id = 0;
    if (nc_inq_dimid(id_, name.c_str(), &id) == NC_NOERR) return id;
    check(nc_def_dim(id_, name.c_str(), length, &id));
    return id;
  }

  int define(const std::string& name, nc_type type, const std::vector<int>& dimensions) {
    int variable = 0;
    check(nc_def_var(id_, name.c_str(), type, static_cast<int>(dimensions.size()), dimensions.data(),
                     &variable));
    if (layout_.deflate && type != NC_CHAR) check(nc_def_var_deflate(id_, variable, 1, 1, 1));
    return variable;
  }

  int put_integers(const std::string& name, const std::vector<int>& dimensions,
                   std::vector<long long> values) {
    const int variable = define(name, integers_, dimensions);
    puts_.push_back([this, variable, values] { check(nc_put_var_longlong(id_, variable, values.data())); });
    return variable;
  }

  void put_reals(const std::string& name, const std::vector<int>& dimensions, std::vector<double> values) {
    const int variable = define(name, layout_.single_precision ? NC_FLOAT : NC_DOUBLE, dimensions);
    puts_.push_back([this, variable, values] { check(nc_put_var_double(id_, variable, values.data())); });
  }

  void put_names(const std::string& name, int rows, const std::vector<std::string>& names) {
    const std::size_t width = layout_.name_length + 1;
    const int variable = define(name, NC_CHAR, {rows, dimension("len_name", width)});
    std::string all;
    for (const std::string& text : names)
      all += text.substr(0, width - 1) + std::string(width - std::min(text.size(), width - 1), '\0');
    puts_.push_back([this, variable, all] { check(nc_put_var_text(id_, variable, all.data())); });
  }

  void put_text_attribute(int variable, const std::string& name, const std::string& text) {
    check(nc_put_att_text(id_, variable, name.c_str(), text.size() + 1, text.c_str()));
  }

  void put_number_attribute(int variable, const std::string& name, nc_type type, double value) {
    check(nc_put_att_double(id_, variable, name.c_str(), type, 1, &value));
  }

  void define_globals();
  void define_nodes();
  void define_block(const ElementBlock& block, const std::string& number);
  void define_set(const SideSet& set, const std::string& number);
  void define_set(const NodeSet& set, const std::string& number);
  void define_assembly(const Assembly& assembly);

  template <class Items, class IsFull>
  void define_list(const Items& items, const char* count, const std::string& prefix, IsFull is_full) {
    if (items.empty()) return;
    std::vector<long long> ids, status;
    std::vector<std::string> names;
    for (const auto& item : items) {
      ids.push_back(item.id);
      status.push_back(is_full(item) ? 1 : 0);
      names.push_back(item.name);
    }
    const int rows = dimension(count, items.size());
    const int variable = put_integers(prefix + "_prop1", {rows}, ids);
    check(nc_put_att_text(id_, variable, "name", 2, "ID"));
    if (layout_.with_status) put_integers(prefix + "_status", {rows}, status);
    if (layout_.with_names) put_names(prefix + "_names", rows, names);
  }

  int id_ = -1;
  const Mesh& mesh_;
  ExodusLayout layout_;
  nc_type integers_;
  std::vector<std::function<void()>> puts_;
};

void Writer::define_globals() {
  put_number_attribute(NC_GLOBAL, "api_version", NC_FLOAT, 8.25F);
  put_number_attribute(NC_GLOBAL, "version", NC_FLOAT, 8.25F);
  put_number_attribute(NC_GLOBAL, "floating_point_word_size", NC_INT, layout_.single_precision ? 4 : 8);
  put_number_attribute(NC_GLOBAL, "file_size", NC_INT, layout_.combined_coordinates ? 0 : 1);
  put_text_attribute(NC_GLOBAL, "title", mesh_.title());
  dimension("num_dim", 3);
  if (mesh_.n_elements() > 0) dimension("num_elem", mesh_.n_elements());
}

void Writer::define_nodes() {
  if (mesh_.n_nodes() == 0) return;
  const int n_nodes = dimension("num_nodes", mesh_.n_nodes());
  std::vector<double> all;
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double> values;
    for (std::uint32_t n = 0; n < mesh_.n_nodes(); ++n) values.push_back(mesh_.coordinates()(axis, n));
    all.insert(all.end(), values.begin(), values.end());
    if (!layout_.combined_coordinates)
      put_reals(
          std::string("coord") + "xyz" [axis], { n_nodes }, values);
  }
  if (layout_.combined_coordinates) put_reals("coord", {dimension("num_dim", 3), n_nodes}, all);

  std::vector<long long> node_ids, element_ids;
  for (std::uint32_t n = 0; n < mesh_.n_nodes(); ++n) node_ids.push_back(mesh_.node_id({n}));
  for (std::uint32_t e = 0; e < mesh_.n_elements(); ++e) element_ids.push_back(mesh_.element_id({e}));
  const auto counts = [](const std::vector<long long>& ids) {
    for (std::size_t i = 0; i < ids.size(); ++i) {
      if (ids[i] != static_cast<long long>(i) + 1) return false;
    }
    return true;
  };
  if (!counts(node_ids)) put_integers("node_num_map", {n_nodes}, node_ids);
  if (!counts(element_ids)) put_integers("elem_num_map", {dimension("num_elem", 0)}, element_ids);
}

void Writer::define_block(const ElementBlock& block, const std::string& number) {
  if (block.n_elements == 0) return;
  const int rows = dimension("num_el_in_blk" + number, block.n_elements);
  const int columns = dimension("num_nod_per_el" + number, static_cast<std::size_t>(block.nodes_per_element));
  const int variable = put_integers("connect" + number, {rows, columns}, from_one(block.nodes));
  put_text_attribute(variable, "elem_type", block.type_name);
  if (block.attribute_names.empty()) return;
  const int n_attributes = dimension("num_att_in_blk" + number, block.attribute_names.size());
  put_reals("attrib" + number, {rows, n_attributes}, block.attributes);
  if (layout_.with_names) put_names("attrib_name" + number, n_attributes, block.attribute_names);
}

void Writer::define_set(const SideSet& set, const std::string& number) {
  if (set.sides.empty()) return;
  const int rows = dimension("num_side_ss" + number, set.sides.size());
  std::vector<long long> elements, sides;
  for (const ElementSide& side : set.sides) {
    elements.push_back(static_cast<long long>(side.element().value) + 1);
    sides.push_back(side.side());
  }
  put_integers("elem_ss" + number, {rows}, elements);
  put_integers("side_ss" + number, {rows}, sides);
  if (set.distribution_factors.empty()) return;
  put_reals("dist_fact_ss" + number, {dimension("num_df_ss" + number, set.distribution_factors.size())},
            set.distribution_factors);
}

void Writer::define_set(const NodeSet& set, const std::string& number) {
  if (set.nodes.empty()) return;
  const int rows = dimension("num_nod_ns" + number, set.nodes.size());
  put_integers("node_ns" + number, {rows}, from_one(set.nodes));
  if (!set.distribution_factors.empty()) put_reals("dist_fact_ns" + number, {rows}, set.distribution_factors);
}

void Writer::define_assembly(const Assembly& assembly) {
  const std::string number = std::to_string(assembly.id);
  const EntityKind kind = assembly.member_kind.value_or(EntityKind::block);
  std::vector<long long> members;
  for (std::uint32_t m : assembly.members) {
    members.push_back(kind == EntityKind::block      ? mesh_.blocks()[m].id
                      : kind == EntityKind::side_set ? mesh_.side_sets()[m].id
                      : kind == EntityKind::node_set ? mesh_.node_sets()[m].id
                                                     : mesh_.assemblies()[m].id);
  }
  const int rows = dimension("num_entity_assembly" + number, std::max<std::size_t>(members.size(), 1));
  members.resize(std::max<std::size_t>(members.size(), 1), 1);
  const int variable = put_integers("assembly_entity" + number, {rows}, members);
  constexpr int types[] = {1, 3, 2, 16};
  put_number_attribute(variable, "_id", NC_INT, static_cast<double>(assembly.id));
  put_number_attribute(variable, "_type", NC_INT,
                       assembly.member_kind ? types[static_cast<std::size_t>(kind)] : 17);
  put_text_attribute(variable, "_name", assembly.name);
}

}  // namespace

void write_exodus(const std::string& path, const Mesh& mesh, const ExodusLayout& layout) {
  Writer(path, mesh, layout).write();
}

}  // namespace contactsim::test
