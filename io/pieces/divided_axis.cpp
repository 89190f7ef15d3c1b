// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/divided_axis.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace contactsim {

namespace {

/// The number behind a prefix, if that is all there is.
std::optional<std::size_t> number_behind(std::string_view prefix, std::string_view name) {
  if (!name.starts_with(prefix) || name.size() == prefix.size()) return std::nullopt;
  const std::string_view digits = name.substr(prefix.size());
  std::size_t number = 0;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  if (error != std::errc() || end != digits.data() + digits.size()) return std::nullopt;
  return number;
}

constexpr std::array<std::pair<std::string_view, DividedKind>, 7> numbered_dimensions{{
    {"num_el_in_blk", DividedKind::block},
    {"num_nod_ns", DividedKind::node_set},
    {"num_df_ns", DividedKind::node_set},
    {"num_side_ss", DividedKind::side_set},
    {"num_df_ss", DividedKind::side_factor},
    {"num_ele_els", DividedKind::element_set},
    {"num_df_els", DividedKind::element_set},
}};

constexpr std::array of_decomposition{
    // dimensions
    "num_processors", "num_procs_file", "num_int_node", "num_bor_node", "num_ext_node", "num_int_elem",
    "num_bor_elem", "num_nodes_global", "num_elems_global", "num_el_blk_global", "num_ns_global",
    "num_ss_global", "num_n_cmaps", "num_e_cmaps", "ncnt_cmap", "ecnt_cmap",
    // variables
    "nem_ftype", "comm_map", "el_blk_ids_global", "el_blk_cnt_global", "ns_ids_global", "ns_node_cnt_global",
    "ns_df_cnt_global", "ss_ids_global", "ss_side_cnt_global", "ss_df_cnt_global", "node_mapi",
    "node_mapi_idx", "node_mapb", "node_mapb_idx", "node_mape", "node_mape_idx", "elem_mapi", "elem_mapi_idx",
    "elem_mapb", "elem_mapb_idx", "int_n_stat", "bor_n_stat", "ext_n_stat", "int_e_stat", "bor_e_stat",
    "n_comm_ids", "n_comm_stat", "n_comm_info_idx", "n_comm_nids", "n_comm_proc", "n_comm_data_idx",
    "e_comm_ids", "e_comm_stat", "e_comm_info_idx", "e_comm_eids", "e_comm_sids", "e_comm_proc",
    "e_comm_data_idx"};

}  // namespace

std::optional<DividedDimension> find_divided(std::string_view dimension) {
  if (dimension == "num_nodes") return DividedDimension{DividedKind::node, 0};
  if (dimension == "num_elem") return DividedDimension{DividedKind::element, 0};
  for (const auto& [prefix, kind] : numbered_dimensions) {
    if (const auto number = number_behind(prefix, dimension)) return DividedDimension{kind, *number};
  }
  return std::nullopt;
}

std::string_view dimension_of_numbers(std::string_view variable) {
  if (number_behind("connect", variable) || number_behind("node_ns", variable)) return "num_nodes";
  if (number_behind("elem_ss", variable) || number_behind("elem_els", variable)) return "num_elem";
  return "";
}

bool describes_decomposition(std::string_view name) {
  return std::ranges::find(of_decomposition, name) != of_decomposition.end() ||
         number_behind("node_ns_order", name) || number_behind("side_ss_order", name) ||
         number_behind("elem_els_order", name);
}

std::string set_order_name(const DividedDimension& set) {
  const char* prefix = set.kind == DividedKind::node_set      ? "node_ns_order"
                       : set.kind == DividedKind::element_set ? "elem_els_order"
                                                              : "side_ss_order";
  return fmt::format("{}{}", prefix, set.number);
}

}  // namespace contactsim
