// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/piece_numbering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <span>

#include "core/base/errors.hpp"
#include "io/netcdf/clean_text.hpp"

namespace contactsim {

namespace {

using Numbers = std::vector<std::int64_t>;

constexpr std::size_t max_items = std::numeric_limits<std::int32_t>::max();

Numbers read_map(const OpenPiece& piece, const std::string& map, const std::string& dimension,
                 const char* what) {
  const std::size_t n = piece.layout.length(dimension);
  Numbers numbers = piece.integers(map, n);
  if (n > 0 && numbers.empty())
    piece.file->fail(
        fmt::format("has no {}, the numbers of its {}s in the whole mesh: it cannot be joined", map, what));
  return numbers;
}

/// The positions of numbers in a list that rises.
std::vector<std::uint32_t> find_positions(std::span<const std::int64_t> numbers, const Numbers& rising) {
  std::vector<std::uint32_t> positions(numbers.size());
  const bool has_no_gap = !rising.empty() && static_cast<std::uint64_t>(rising.back() - rising.front()) + 1 ==
                                                 static_cast<std::uint64_t>(rising.size());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    positions[i] = static_cast<std::uint32_t>(has_no_gap ? numbers[i] - rising.front()
                                                         : std::ranges::lower_bound(rising, numbers[i]) -
                                                               rising.begin());
  }
  return positions;
}

bool is_one_to_n(const Numbers& rising) {
  return rising.empty() || (rising.front() == 1 && rising.back() == static_cast<std::int64_t>(rising.size()));
}

/// Throws when there are not as many numbers as the whole has.
///   rising  each once
void check_count(const std::vector<OpenPiece>& pieces, const Numbers& rising, std::size_t expected,
                 const char* what) {
  if (rising.size() == expected) return;
  const NetcdfFile& file = *pieces.front().file;
  const bool are_positions =
      rising.empty() || (rising.front() >= 1 && rising.back() <= static_cast<std::int64_t>(expected));
  if (rising.size() > expected || !are_positions)
    file.fail(fmt::format("the {} pieces have {} {}s, the whole mesh {}", pieces.size(), rising.size(), what,
                          expected));
  std::int64_t missing = 1;
  for (const std::int64_t number : rising) missing += number == missing ? 1 : 0;
  file.fail(fmt::format("{} {} of the {} of the whole mesh is in none of the {} pieces", what, missing,
                        expected, pieces.size()));
}

/// Throws when a list that rises holds a number twice.
void check_no_repeat(const std::vector<OpenPiece>& pieces, const std::vector<Numbers>& of_pieces,
                     const Numbers& rising, const char* what) {
  const auto repeat = std::ranges::adjacent_find(rising);
  if (repeat == rising.end()) return;
  std::vector<std::size_t> holders;
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    for (std::ptrdiff_t n = std::ranges::count(of_pieces[p], *repeat); n > 0; --n) holders.push_back(p);
  }
  pieces[holders.at(1)].file->fail(fmt::format("{} {} of the whole mesh is in {}{}", what, *repeat,
                                               pieces[holders.at(0)].file->path(),
                                               holders[0] == holders[1] ? " twice" : " as well"));
}

/// Puts values by items of pieces into the order of the whole; the first piece of an item says its value.
Numbers join(const std::vector<Numbers>& of_pieces, const DividedAxis& axis) {
  Numbers whole(axis.length);
  for (std::size_t p = of_pieces.size(); p-- > 0;)
    scatter<std::int64_t>(of_pieces[p], axis.positions[p], {1, axis.length, 1}, whole);
  return whole;
}

/// The name of the variable with original_ids, where it is the last of the further maps: "node_map1".
std::string find_original_map(const OpenPiece& piece, const std::string& count, const std::string& names,
                              const std::string& prefix) {
  const std::size_t n = piece.layout.length(count);
  const auto variable = piece.file->find_variable(names);
  if (n == 0 || !variable || !variable->is_text || variable->shape.size() != 2) return "";
  const std::vector<std::string> texts = piece.file->read_texts(*variable);
  return texts.size() == n && texts.back() == original_ids ? fmt::format("{}{}", prefix, n) : "";
}

/// The wider type of a variable in any piece.
NetcdfType find_type(const std::vector<OpenPiece>& pieces, const std::string& variable) {
  const bool is_wide = std::ranges::any_of(pieces, [&](const OpenPiece& piece) {
    const NetcdfDefinition* found = piece.layout.find_variable(variable);
    return found != nullptr && found->type == NetcdfType::int64;
  });
  return is_wide ? NetcdfType::int64 : NetcdfType::int32;
}

/// The user's ids: those of original_ids, where each piece with items has them; else the numbers themselves.
///   numbers  of the maps, in the order of the whole
///   type     becomes that of what the ids are read from
Numbers find_ids(const std::vector<OpenPiece>& pieces, const DividedAxis& axis, bool is_node, Numbers numbers,
                 NetcdfType& type) {
  type = find_type(pieces, is_node ? "node_num_map" : "elem_num_map");
  std::string map;
  std::vector<Numbers> ids(pieces.size());
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const std::size_t n = axis.positions[p].size();
    if (n == 0) continue;
    map = is_node ? find_original_map(pieces[p], "num_node_maps", "nmap_names", "node_map")
                  : find_original_map(pieces[p], "num_elem_maps", "emap_names", "elem_map");
    if (!map.empty()) ids[p] = pieces[p].integers(map, n);
    if (ids[p].empty()) return numbers;
  }
  if (!map.empty()) type = find_type(pieces, map);
  return join(ids, axis);
}

Numbers number_nodes(const std::vector<OpenPiece>& pieces, Division& division, NetcdfType& id_type) {
  std::vector<Numbers> maps;
  Numbers rising;
  for (const OpenPiece& piece : pieces) {
    maps.push_back(read_map(piece, "node_num_map", "num_nodes", "node"));
    Numbers own = maps.back();
    std::ranges::sort(own);
    if (const auto repeat = std::ranges::adjacent_find(own); repeat != own.end())
      piece.file->fail(fmt::format("node {} of the whole mesh is in it twice", *repeat));
    rising.insert(rising.end(), own.begin(), own.end());
  }
  std::ranges::sort(rising);
  rising.erase(std::unique(rising.begin(), rising.end()), rising.end());
  const std::size_t expected = pieces.front().layout.length("num_nodes_global");
  if (expected > max_items) pieces.front().file->fail("has more nodes than are possible");
  check_count(pieces, rising, expected, "node");
  DividedAxis& axis = division["num_nodes"];
  axis.length = rising.size();
  for (const Numbers& map : maps) axis.positions.push_back(find_positions(map, rising));
  const bool is_counting = is_one_to_n(rising);
  return find_ids(pieces, axis, true, is_counting ? Numbers() : std::move(rising), id_type);
}

/// Elements of one block in all pieces.
struct BlockNumbers {
  std::vector<std::size_t> begins;  ///< [pieces]: of its elements among those of the piece
  std::vector<Numbers> of_pieces;
  Numbers rising;
};

BlockNumbers find_block(const std::vector<OpenPiece>& pieces, const std::vector<Numbers>& maps,
                        const std::string& dimension, std::vector<std::size_t>& begins) {
  BlockNumbers block{begins, {}, {}};
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    const std::size_t n = pieces[p].layout.length(dimension);
    if (n > maps[p].size() - begins[p])
      pieces[p].file->fail("its blocks have more elements than num_elem says");
    const auto begin = maps[p].begin() + static_cast<std::ptrdiff_t>(begins[p]);
    block.of_pieces.emplace_back(begin, begin + static_cast<std::ptrdiff_t>(n));
    block.rising.insert(block.rising.end(), block.of_pieces.back().begin(), block.of_pieces.back().end());
    begins[p] += n;
  }
  std::ranges::sort(block.rising);
  return block;
}

Numbers number_elements(const std::vector<OpenPiece>& pieces, Division& division, NetcdfType& id_type) {
  const std::size_t expected = pieces.front().layout.length("num_elems_global");
  if (expected > max_items) pieces.front().file->fail("has more elements than are possible");
  std::vector<Numbers> maps;
  Numbers all;
  for (const OpenPiece& piece : pieces) {
    maps.push_back(read_map(piece, "elem_num_map", "num_elem", "element"));
    all.insert(all.end(), maps.back().begin(), maps.back().end());
  }
  std::ranges::sort(all);
  check_no_repeat(pieces, maps, all, "element");
  check_count(pieces, all, expected, "element");

  DividedAxis& elements = division["num_elem"];
  elements.length = expected;
  for (const Numbers& map : maps) elements.positions.emplace_back(map.size());
  std::vector<std::size_t> begins(pieces.size(), 0);
  Numbers in_order;
  const std::size_t n_blocks = pieces.front().layout.length("num_el_blk");
  for (std::size_t number = 1; number <= n_blocks; ++number) {
    const std::string dimension = fmt::format("num_el_in_blk{}", number);
    const BlockNumbers block = find_block(pieces, maps, dimension, begins);
    DividedAxis& axis = division[dimension];
    axis.length = block.rising.size();
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      axis.positions.push_back(find_positions(block.of_pieces[p], block.rising));
      for (std::size_t i = 0; i < axis.positions[p].size(); ++i)
        elements.positions[p][block.begins[p] + i] =
            static_cast<std::uint32_t>(in_order.size()) + axis.positions[p][i];
    }
    in_order.insert(in_order.end(), block.rising.begin(), block.rising.end());
  }
  for (std::size_t p = 0; p < pieces.size(); ++p) {
    if (begins[p] != maps[p].size())
      pieces[p].file->fail(
          fmt::format("its blocks have {} elements, but num_elem says {}", begins[p], maps[p].size()));
  }
  const bool is_counting = std::ranges::is_sorted(in_order) && is_one_to_n(in_order);
  return find_ids(pieces, elements, false, is_counting ? Numbers() : std::move(in_order), id_type);
}

}  // namespace

PieceNumbering number_pieces(const std::vector<OpenPiece>& pieces, Division& division) {
  PieceNumbering numbering;
  numbering.node_ids = number_nodes(pieces, division, numbering.node_id_type);
  numbering.element_ids = number_elements(pieces, division, numbering.element_id_type);
  return numbering;
}

}  // namespace contactsim
