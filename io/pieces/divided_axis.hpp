// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace contactsim {

/// What runs along a dimension of an Exodus file that differs between the pieces of a decomposition.
enum class DividedKind : std::uint8_t { node, element, block, node_set, side_set, side_factor, element_set };

/// Such a dimension: its kind and, of blocks and sets, the number in its name, from 1.
struct DividedDimension {
  DividedKind kind = DividedKind::node;
  std::size_t number = 0;
};

/// What a dimension of this name is, if pieces differ in it.
std::optional<DividedDimension> find_divided(std::string_view dimension);

/// The dimension that the numbers in a variable count along, from 1: num_nodes of connectivity and node sets,
/// num_elem of side sets and element sets, "" of all others.
std::string_view dimension_of_numbers(std::string_view variable);

/// How the items along a dimension are spread over the pieces.
struct DividedAxis {
  std::size_t length = 0;                             ///< of the whole
  std::vector<std::vector<std::uint32_t>> positions;  ///< [pieces][items of the piece]: in the whole, from 0
};

/// By the names of the dimensions.
using Division = std::map<std::string, DividedAxis, std::less<>>;

/// Where one dimension stands among those of an array: values lie outer by along by inner.
struct AxisPlace {
  std::size_t outer = 1, along = 1, inner = 1;
};

/// Takes the items of a piece out of the values of the whole.
///   whole  outer x along x inner values
template <class T>
std::vector<T> gather(std::span<const T> whole, std::span<const std::uint32_t> positions,
                      const AxisPlace& place) {
  std::vector<T> part;
  part.reserve(place.outer * positions.size() * place.inner);
  for (std::size_t o = 0; o < place.outer; ++o) {
    for (const std::uint32_t position : positions) {
      const T* from = whole.data() + (o * place.along + position) * place.inner;
      part.insert(part.end(), from, from + place.inner);
    }
  }
  return part;
}

/// Puts the items of a piece where they belong in the values of the whole.
///   part   outer x positions x inner values
///   whole  outer x along x inner values
template <class T>
void scatter(std::span<const T> part, std::span<const std::uint32_t> positions, const AxisPlace& place,
             std::span<T> whole) {
  const T* from = part.data();
  for (std::size_t o = 0; o < place.outer; ++o) {
    for (const std::uint32_t position : positions) {
      T* to = whole.data() + (o * place.along + position) * place.inner;
      for (std::size_t i = 0; i < place.inner; ++i) to[i] = *from++;
    }
  }
}

/// Whether a dimension or variable only tells how a file is decomposed: the whole has none such.
/// Source: Hennigan & Shadid, NEMESIS I: A Set of Functions for Describing Unstructured Finite-Element Data
/// on Parallel Computers (Sandia National Laboratories, 1998); names of the Exodus library.
bool describes_decomposition(std::string_view name);

/// The name of the map that keeps the ids of nodes, or elements, in pieces whose own maps hold the numbers in
/// the whole. Source: Sandia's nem_spread and IOSS.
inline constexpr std::string_view original_ids = "original_global_id_map";

/// Pieces keep the processing order of elements, which names elements of the whole, under the second name.
inline constexpr std::string_view order_map = "elem_map", whole_order_map = "whole_elem_map";

/// A variable of pieces, named by prefix and number of its set, that gives each entry's position in the whole
/// set, from 1, where sets are not in the order of their nodes, or of elements and sides.
std::string set_order_name(const DividedDimension& set);

}  // namespace contactsim
