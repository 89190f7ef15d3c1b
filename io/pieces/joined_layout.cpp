// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/joined_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>

namespace contactsim {

namespace {

/// Further maps: their number, and what is named by it.
struct FurtherMaps {
  const char *count, *names, *variable, *property;
};

constexpr std::array further_maps{FurtherMaps{"num_node_maps", "nmap_names", "node_map", "nm_prop"},
                                  FurtherMaps{"num_elem_maps", "emap_names", "elem_map", "em_prop"}};

/// Integers that pieces give of themselves: where one has something, the whole has.
constexpr std::array of_any_piece{"eb_status",    "ns_status",    "ss_status",    "els_status",
                                  "elem_var_tab", "nset_var_tab", "sset_var_tab", "elset_var_tab"};

/// Lists of which the first piece that has them speaks for all.
constexpr std::array of_first_piece{"num_qa_rec", "num_info"};

class LayoutJoiner {
 public:
  LayoutJoiner(const std::vector<OpenPiece>& pieces, const Division& division, PieceNumbering numbering)
      : pieces_(pieces), division_(division), numbering_(std::move(numbering)) {}

  JoinedLayout join() {
    drop_original_maps();
    for (const OpenPiece& piece : pieces_) add_dimensions(piece);
    for (const OpenPiece& piece : pieces_) add_variables(piece);
    add_map("node_num_map", "num_nodes", numbering_.node_id_type, std::move(numbering_.node_ids));
    add_map("elem_num_map", "num_elem", numbering_.element_id_type, std::move(numbering_.element_ids));
    for (const char* name : of_any_piece) join_status(name);
    for (const NetcdfAttribute& attribute : pieces_.front().layout.attributes) {
      if (!attribute.name.starts_with("nemesis_") && attribute.name != "processor_info")
        joined_.layout.attributes.push_back(attribute);
    }
    return std::move(joined_);
  }

 private:
  /// What keeps the user's ids in pieces is no map of the whole.
  void drop_original_maps() {
    for (const FurtherMaps& maps : further_maps) {
      for (const OpenPiece& piece : pieces_) {
        const std::size_t n = piece.layout.length(maps.count);
        const auto names = piece.file->find_variable(maps.names);
        if (n == 0 || !names || !names->is_text || names->shape.size() != 2) continue;
        const std::vector<std::string> texts = piece.file->read_texts(*names);
        if (texts.size() != n || texts.back() != original_ids) continue;
        dropped_.insert(fmt::format("{}{}", maps.variable, n));
        shortened_[maps.count] = n - 1;
        break;
      }
    }
  }

  void add_dimensions(const OpenPiece& piece) {
    for (const NetcdfDimension& dimension : piece.layout.dimensions) {
      if (describes_decomposition(dimension.name)) continue;
      NetcdfDimension of_whole = dimension;
      if (const auto divided = division_.find(dimension.name); divided != division_.end())
        of_whole = {dimension.name, divided->second.length, false};
      if (const auto shortened = shortened_.find(dimension.name); shortened != shortened_.end())
        of_whole.length = shortened->second;
      const auto [known, is_new] = first_.emplace(dimension.name, &piece);
      if (is_new) {
        if (of_whole.length > 0 || of_whole.is_unlimited) joined_.layout.dimensions.push_back(of_whole);
        continue;
      }
      check_same(piece, *known->second, dimension);
    }
  }

  void check_same(const OpenPiece& piece, const OpenPiece& first, const NetcdfDimension& dimension) const {
    const std::size_t there = first.layout.length(dimension.name);
    const bool may_differ = find_divided(dimension.name).has_value() ||
                            std::ranges::find(of_first_piece, dimension.name) != of_first_piece.end();
    if (may_differ || dimension.length == there) return;
    piece.file->fail(fmt::format("does not go with {}: {} is {}, there {}", first.file->path(),
                                 dimension.name, dimension.length, there));
  }

  void add_variables(const OpenPiece& piece) {
    for (NetcdfDefinition variable : piece.layout.variables) {
      if (describes_decomposition(variable.name) || dropped_.contains(variable.name) ||
          variable.name == "node_num_map" || variable.name == "elem_num_map")
        continue;
      // The processing order of a piece is none of the whole.
      if (variable.name == order_map) continue;
      if (variable.name == whole_order_map) variable.name = order_map;
      if (!names_.insert(variable.name).second) continue;
      const bool is_empty = std::ranges::any_of(variable.dimensions, [&](const std::string& dimension) {
        return joined_.layout.find_dimension(dimension) == nullptr;
      });
      if (!is_empty) joined_.layout.variables.push_back(std::move(variable));
    }
  }

  void add_map(const char* name, const char* dimension, NetcdfType type, std::vector<std::int64_t> ids) {
    if (ids.empty()) return;
    joined_.layout.variables.push_back({name, type, {dimension}, {}});
    joined_.made.emplace(name, std::move(ids));
  }

  void join_status(const char* name) {
    const NetcdfDefinition* variable = joined_.layout.find_variable(name);
    if (variable == nullptr) return;
    std::size_t n = 1;
    for (const std::size_t length : joined_.layout.shape(*variable)) n *= length;
    std::vector<std::int64_t> most(n, 0);
    for (const OpenPiece& piece : pieces_) {
      const auto of_piece = piece.file->find_variable(name);
      if (!of_piece) continue;
      if (of_piece->size() != n) piece.file->fail(fmt::format("variable {} should have {} values", name, n));
      std::vector<std::int64_t> values(n);
      piece.file->read_int64(*of_piece, values);
      for (std::size_t i = 0; i < n; ++i) most[i] = std::max(most[i], values[i]);
    }
    joined_.made.emplace(name, std::move(most));
  }

  const std::vector<OpenPiece>& pieces_;
  const Division& division_;
  PieceNumbering numbering_;
  JoinedLayout joined_;
  std::map<std::string, const OpenPiece*, std::less<>> first_;  // with a dimension
  std::map<std::string, std::size_t, std::less<>> shortened_;
  std::set<std::string> dropped_, names_;
};

}  // namespace

JoinedLayout join_layouts(const std::vector<OpenPiece>& pieces, const Division& division,
                          PieceNumbering numbering) {
  return LayoutJoiner(pieces, division, std::move(numbering)).join();
}

}  // namespace contactsim
