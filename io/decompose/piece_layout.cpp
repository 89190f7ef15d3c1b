// SPDX-License-Identifier: BSD-3-Clause
#include "io/decompose/piece_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

#include "io/decompose/shared_parts.hpp"

namespace contactsim {

namespace {

/// Where the ids of nodes, or elements, are kept.
struct IdMaps {
  const char *ids, *dimension, *count, *names, *variable, *property;
};

constexpr std::array id_maps{
    IdMaps{"node_num_map", "num_nodes", "num_node_maps", "nmap_names", "node_map", "nm_prop"},
    IdMaps{"elem_num_map", "num_elem", "num_elem_maps", "emap_names", "elem_map", "em_prop"}};

/// The status of blocks and sets, and the tables that say which variables they have.
struct StatusOf {
  const char *count, *status, *dimension, *table;
};

constexpr std::array statuses{StatusOf{"num_el_blk", "eb_status", "num_el_in_blk", "elem_var_tab"},
                              StatusOf{"num_node_sets", "ns_status", "num_nod_ns", "nset_var_tab"},
                              StatusOf{"num_side_sets", "ss_status", "num_side_ss", "sset_var_tab"},
                              StatusOf{"num_elem_sets", "els_status", "num_ele_els", "elset_var_tab"}};

constexpr std::size_t name_length = 33;

class PieceDrafter {
 public:
  PieceDrafter(const WholeFile& whole, std::uint32_t piece) : whole_(whole), piece_(piece) {}

  PieceLayout draft() {
    find_empty_blocks();
    for (const NetcdfDimension& dimension : whole_.layout.dimensions) add_dimension(dimension);
    for (const NetcdfDefinition& variable : whole_.layout.variables) add_variable(variable);
    for (const IdMaps& maps : id_maps) add_id_maps(maps);
    for (const StatusOf& status : statuses) add_status(status);
    for (const std::string& dimension : whole_.division.ordered_sets) add_order(dimension);
    made_.layout.attributes = whole_.layout.attributes;
    add_shared_parts(whole_, piece_, made_);
    return std::move(made_);
  }

 private:
  const std::vector<std::uint32_t>* find_positions(const std::string& dimension) const {
    const auto axis = whole_.division.division.find(dimension);
    return axis == whole_.division.division.end() ? nullptr : &axis->second.positions[piece_];
  }

  /// Blocks without elements in the piece have neither nodes nor attributes of an element.
  void find_empty_blocks() {
    for (std::size_t number = 1; number <= whole_.layout.length("num_el_blk"); ++number) {
      const auto* elements = find_positions(fmt::format("num_el_in_blk{}", number));
      if (elements != nullptr && !elements->empty()) continue;
      left_out_.insert(fmt::format("num_nod_per_el{}", number));
      left_out_.insert(fmt::format("num_att_in_blk{}", number));
    }
  }

  bool keeps_ids(const IdMaps& maps) const { return whole_.layout.find_variable(maps.ids) != nullptr; }
  bool has_items(const IdMaps& maps) const {
    const auto* items = find_positions(maps.dimension);
    return items != nullptr && !items->empty();
  }

  void add_dimension(NetcdfDimension dimension) {
    if (left_out_.contains(dimension.name)) return;
    if (const auto* positions = find_positions(dimension.name)) dimension.length = positions->size();
    for (const IdMaps& maps : id_maps) {
      if (dimension.name == maps.count && keeps_ids(maps)) ++dimension.length;
    }
    if (dimension.name == "len_name") dimension.length = std::max(dimension.length, least_name_length());
    if (dimension.length > 0 || dimension.is_unlimited) made_.layout.dimensions.push_back(dimension);
  }

  std::size_t least_name_length() const {
    const bool keeps = std::ranges::any_of(id_maps, [&](const IdMaps& maps) { return keeps_ids(maps); });
    return keeps ? original_ids.size() + 1 : 0;
  }

  bool is_there(const std::vector<std::string>& dimensions) const {
    return std::ranges::all_of(dimensions, [&](const std::string& dimension) {
      return made_.layout.find_dimension(dimension) != nullptr;
    });
  }

  void add_variable(NetcdfDefinition variable) {
    if (variable.name == "node_num_map" || variable.name == "elem_num_map") return;
    if (!is_there(variable.dimensions)) return;
    variable.name = name_in_piece(variable);
    made_.layout.variables.push_back(std::move(variable));
  }

  void require_dimension(const char* name, std::size_t length) {
    if (made_.layout.find_dimension(name) == nullptr)
      made_.layout.dimensions.push_back({name, length, false});
  }

  void define(NetcdfDefinition variable, NetcdfValues values) {
    made_.made.insert_or_assign(variable.name, std::move(values));
    if (made_.layout.find_variable(variable.name) == nullptr)
      made_.layout.variables.push_back(std::move(variable));
  }

  /// Values of a list of the whole file.
  NetcdfValues read_all(const std::string& name) const {
    const NetcdfDefinition& definition = *whole_.layout.find_variable(name);
    const NetcdfVariable variable = whole_.file.find_variable(name).value();
    return whole_.file.read_values(variable, definition.type, {0, variable.shape.at(0)});
  }

  void add_id_maps(const IdMaps& maps) {
    if (has_items(maps)) {
      std::vector<std::int64_t> numbers;
      for (const std::uint32_t position : *find_positions(maps.dimension)) numbers.push_back(position + 1);
      define({maps.ids, NetcdfType::int32, {maps.dimension}, {}}, std::move(numbers));
    }
    if (!keeps_ids(maps)) return;
    require_dimension("len_name", name_length);
    require_dimension(maps.count, 1);
    add_original_ids(maps);
    add_map_names(maps);
    add_map_properties(maps);
  }

  void add_original_ids(const IdMaps& maps) {
    if (!has_items(maps)) return;
    const std::string name = fmt::format("{}{}", maps.variable, made_.layout.length(maps.count));
    const NetcdfDefinition& ids = *whole_.layout.find_variable(maps.ids);
    define({name, ids.type, {maps.dimension}, {}}, take_part(whole_, ids, false, read_all(maps.ids), piece_));
  }

  void add_map_names(const IdMaps& maps) {
    const std::size_t n = made_.layout.length(maps.count), width = made_.layout.length("len_name");
    std::vector<std::string> names(n);
    if (const auto stored = whole_.file.find_variable(maps.names))
      std::ranges::copy(whole_.file.read_stored_texts(*stored), names.begin());
    names.back() = original_ids;
    std::vector<char> rows(n * width, '\0');
    for (std::size_t i = 0; i < n; ++i)
      std::copy_n(names[i].begin(), std::min(names[i].size(), width - 1),
                  rows.begin() + static_cast<std::ptrdiff_t>(i * width));
    define({maps.names, NetcdfType::text, {maps.count, "len_name"}, {}}, std::move(rows));
  }

  /// Each property of maps, the first of which is their ids, has a value for the further map.
  void add_map_properties(const IdMaps& maps) {
    const std::string ids = fmt::format("{}1", maps.property);
    if (made_.layout.find_variable(ids) == nullptr) {
      const std::string name = "ID";
      define({ids,
              NetcdfType::int32,
              {maps.count},
              {{"name", NetcdfType::text, std::vector<char>(name.begin(), name.end())}}},
             std::vector<std::int64_t>(made_.layout.length(maps.count), 1));
      return;
    }
    for (const NetcdfDefinition& variable : whole_.layout.variables) {
      if (variable.dimensions != std::vector<std::string>{maps.count} ||
          !variable.name.starts_with(maps.property))
        continue;
      auto values = std::get<std::vector<std::int64_t>>(read_all(variable.name));
      values.push_back(variable.name == ids ? *std::ranges::max_element(values) + 1 : 0);
      made_.made.insert_or_assign(variable.name, std::move(values));
    }
  }

  void add_status(const StatusOf& status) {
    const std::size_t n = whole_.layout.length(status.count);
    if (n == 0) return;
    std::vector<std::int64_t> values;
    for (std::size_t number = 1; number <= n; ++number) {
      const auto* items = find_positions(fmt::format("{}{}", status.dimension, number));
      values.push_back(items != nullptr && !items->empty() ? 1 : 0);
    }
    if (made_.layout.find_variable(status.table) != nullptr) {
      auto table = std::get<std::vector<std::int64_t>>(read_all(status.table));
      for (std::size_t i = 0; i < table.size(); ++i) table[i] *= values[i * n / table.size()];
      made_.made.insert_or_assign(status.table, std::move(table));
    }
    define({status.status, NetcdfType::int32, {status.count}, {}}, std::move(values));
  }

  void add_order(const std::string& dimension) {
    const std::vector<std::uint32_t>& positions = *find_positions(dimension);
    if (positions.empty()) return;
    std::vector<std::int64_t> places;
    for (const std::uint32_t position : positions) places.push_back(position + 1);
    define({set_order_name(*find_divided(dimension)), NetcdfType::int32, {dimension}, {}}, std::move(places));
  }

  const WholeFile& whole_;
  std::uint32_t piece_;
  PieceLayout made_;
  std::set<std::string, std::less<>> left_out_;
};

}  // namespace

PieceLayout make_piece_layout(const WholeFile& whole, std::uint32_t piece) {
  return PieceDrafter(whole, piece).draft();
}

std::string name_in_piece(const NetcdfDefinition& variable) {
  return std::string(variable.name == order_map ? whole_order_map : variable.name);
}

NetcdfValues take_part(const WholeFile& whole, const NetcdfDefinition& variable, bool record,
                       const NetcdfValues& values, std::uint32_t piece) {
  AxisPlace place;
  const std::vector<std::uint32_t>* positions = nullptr;
  for (std::size_t d = record ? 1 : 0; d < variable.dimensions.size(); ++d) {
    const auto axis = whole.division.division.find(variable.dimensions[d]);
    const std::size_t length = whole.layout.length(variable.dimensions[d]);
    if (positions == nullptr && axis != whole.division.division.end()) {
      positions = &axis->second.positions[piece];
      place.along = length;
    } else {
      (positions == nullptr ? place.outer : place.inner) *= length;
    }
  }
  if (positions == nullptr) return values;
  NetcdfValues part = std::visit(
      [&](const auto& all) -> NetcdfValues {
        using T = typename std::decay_t<decltype(all)>::value_type;
        return gather<T>(all, *positions, place);
      },
      values);
  const std::string_view numbered = dimension_of_numbers(variable.name);
  if (numbered.empty()) return part;
  const std::vector<std::uint32_t>& items = whole.division.division.find(numbered)->second.positions[piece];
  for (std::int64_t& number : std::get<std::vector<std::int64_t>>(part))
    number = std::ranges::lower_bound(items, static_cast<std::uint32_t>(number - 1)) - items.begin() + 1;
  return part;
}

}  // namespace contactsim
