// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/shared_parts.hpp"

#include <fmt/format.h>

namespace contactsim {

namespace {

using Numbers = std::vector<std::int64_t>;

class SharedPartsWriter {
 public:
  SharedPartsWriter(const WholeFile& whole, std::uint32_t piece, PieceLayout& made)
      : whole_(whole), piece_(piece), made_(made) {}

  void add() {
    add_counts();
    add_ids("num_el_blk", "eb_prop1", "num_el_blk_global", "el_blk_ids_global",
            {{"el_blk_cnt_global", "num_el_in_blk"}});
    add_ids("num_node_sets", "ns_prop1", "num_ns_global", "ns_ids_global",
            {{"ns_node_cnt_global", "num_nod_ns"}, {"ns_df_cnt_global", "num_df_ns"}});
    add_ids("num_side_sets", "ss_prop1", "num_ss_global", "ss_ids_global",
            {{"ss_side_cnt_global", "num_side_ss"}, {"ss_df_cnt_global", "num_df_ss"}});
    add_parts({"num_int_node", "node_mapi", "int_n_stat"}, {"num_bor_node", "node_mapb", "bor_n_stat"},
              border_nodes());
    define("ext_n_stat", "num_procs_file", {0});
    add_parts({"num_int_elem", "elem_mapi", "int_e_stat"}, {"num_bor_elem", "elem_mapb", "bor_e_stat"},
              border_elements());
    add_shared_nodes();
    add_shared_sides();
    add_attributes();
  }

 private:
  std::size_t n_items(const char* dimension) const {
    const auto axis = whole_.division.division.find(dimension);
    return axis == whole_.division.division.end() ? 0 : axis->second.positions[piece_].size();
  }

  void add_dimension(const char* name, std::size_t length) {
    if (length > 0) made_.layout.dimensions.push_back({name, length, false});
  }

  void define(const char* name, const char* dimension, Numbers values) {
    if (values.empty()) return;
    NetcdfType type = NetcdfType::int32;
    for (const std::int64_t value : values) {
      if (value != static_cast<std::int32_t>(value)) type = NetcdfType::int64;
    }
    made_.layout.variables.push_back({name, type, {dimension}, {}});
    made_.made.insert_or_assign(name, std::move(values));
  }

  void add_counts() {
    add_dimension("num_processors", whole_.n_pieces);
    add_dimension("num_procs_file", 1);
    add_dimension("num_nodes_global", whole_.layout.length("num_nodes"));
    add_dimension("num_elems_global", whole_.layout.length("num_elem"));
    made_.layout.variables.push_back({"nem_ftype", NetcdfType::int32, {}, {}});
    made_.made.insert_or_assign("nem_ftype", Numbers{0});
  }

  struct Count {
    const char *variable, *dimension;
  };

  void add_ids(const char* count, const char* ids, const char* dimension, const char* variable,
               const std::vector<Count>& counts) {
    const std::size_t n = whole_.layout.length(count);
    const auto stored = whole_.file.find_variable(ids);
    if (n == 0 || !stored) return;
    add_dimension(dimension, n);
    Numbers values(n);
    whole_.file.read_int64(*stored, values);
    define(variable, dimension, values);
    for (const Count& of : counts) {
      for (std::size_t i = 0; i < n; ++i)
        values[i] = static_cast<std::int64_t>(whole_.layout.length(fmt::format("{}{}", of.dimension, i + 1)));
      define(of.variable, dimension, values);
    }
  }

  std::vector<std::uint8_t> border_nodes() const {
    std::vector<std::uint8_t> is_border(n_items("num_nodes"), 0);
    for (const SharedNode& shared : whole_.division.nodes[piece_]) is_border[shared.node] = 1;
    return is_border;
  }

  std::vector<std::uint8_t> border_elements() const {
    std::vector<std::uint8_t> is_border(n_items("num_elem"), 0);
    for (const SharedSide& shared : whole_.division.sides[piece_]) is_border[shared.element] = 1;
    return is_border;
  }

  /// What a part of the nodes or elements is called.
  struct PartNames {
    const char *count, *numbers, *status;
  };

  void add_part(const PartNames& names, Numbers numbers) {
    define(names.status, "num_procs_file", {numbers.empty() ? 0 : 1});
    add_dimension(names.count, numbers.size());
    define(names.numbers, names.count, std::move(numbers));
  }

  void add_parts(const PartNames& internal, const PartNames& border,
                 const std::vector<std::uint8_t>& is_border) {
    Numbers inside, at_border;
    for (std::size_t i = 0; i < is_border.size(); ++i)
      (is_border[i] != 0 ? at_border : inside).push_back(static_cast<std::int64_t>(i + 1));
    add_part(internal, std::move(inside));
    add_part(border, std::move(at_border));
  }

  /// What a list of what is shared is called.
  struct ListNames {
    const char *count, *ids, *status, *end, *length;
  };

  /// One list with the number 1, which ends with its last entry.
  void add_list(const ListNames& names, std::size_t n) {
    add_dimension(names.count, 1);
    add_dimension(names.length, n);
    define(names.ids, names.count, {1});
    define(names.status, names.count, {1});
    define(names.end, names.count, {static_cast<std::int64_t>(n)});
  }

  void add_shared_nodes() {
    const std::vector<SharedNode>& shared = whole_.division.nodes[piece_];
    if (shared.empty()) return;
    add_list({"num_n_cmaps", "n_comm_ids", "n_comm_stat", "n_comm_data_idx", "ncnt_cmap"}, shared.size());
    Numbers nodes, pieces;
    for (const SharedNode& one : shared) {
      nodes.push_back(one.node + 1);
      pieces.push_back(one.piece);
    }
    define("n_comm_nids", "ncnt_cmap", std::move(nodes));
    define("n_comm_proc", "ncnt_cmap", std::move(pieces));
  }

  void add_shared_sides() {
    const std::vector<SharedSide>& shared = whole_.division.sides[piece_];
    if (shared.empty()) return;
    add_list({"num_e_cmaps", "e_comm_ids", "e_comm_stat", "e_comm_data_idx", "ecnt_cmap"}, shared.size());
    Numbers elements, sides, pieces;
    for (const SharedSide& one : shared) {
      elements.push_back(one.element + 1);
      sides.push_back(one.side);
      pieces.push_back(one.piece);
    }
    define("e_comm_eids", "ecnt_cmap", std::move(elements));
    define("e_comm_sids", "ecnt_cmap", std::move(sides));
    define("e_comm_proc", "ecnt_cmap", std::move(pieces));
  }

  void add_attributes() {
    constexpr double nemesis_version = 2.6;  // of the definitions above
    const double api =
        first_number(find_attribute(whole_.layout.attributes, "api_version"))
            .value_or(first_number(find_attribute(whole_.layout.attributes, "version")).value_or(2));
    auto& attributes = made_.layout.attributes;
    attributes.push_back({"nemesis_file_version", NetcdfType::float32, std::vector<double>{nemesis_version}});
    attributes.push_back({"nemesis_api_version", NetcdfType::float32, std::vector<double>{api}});
    attributes.push_back({"processor_info", NetcdfType::int32, Numbers{whole_.n_pieces, piece_}});
  }

  const WholeFile& whole_;
  std::uint32_t piece_;
  PieceLayout& made_;
};

}  // namespace

void add_shared_parts(const WholeFile& whole, std::uint32_t piece, PieceLayout& made) {
  SharedPartsWriter(whole, piece, made).add();
}

}  // namespace contactsim
