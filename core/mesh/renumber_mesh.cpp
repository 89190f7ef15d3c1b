// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/renumber_mesh.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include "core/base/optional_index.hpp"
#include "core/base/threads.hpp"
#include "core/mesh/element_faces.hpp"
#include "core/mesh/topology.hpp"

namespace contactsim {

namespace {

/// What stands at each new position, by its old one.
using Order = std::vector<std::uint32_t>;

/// Calls function(i) for every i below n, shared by threads.
template <class Function>
void for_each(std::size_t n, const Function& function) {
  parallel_for(static_cast<std::uint32_t>(n), threads_for(n), function);
}

/// Where what stood at each old position is now.
Order inverse(const Order& order) {
  Order now(order.size());
  for_each(order.size(), [&](std::uint32_t i) { now[order[i]] = i; });
  return now;
}

/// The grid of cells that holds all elements of a block.
class CellGrid {
 public:
  CellGrid(const ElementBlock& block, const Eigen::Matrix3Xd& x) : block_(block), x_(x) {
    // Each node once: elements share them.
    std::vector<std::uint8_t> is_used(static_cast<std::size_t>(x.cols()), 0);
    for (const NodeIndex node : block.nodes) is_used[node.value] = 1;
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      if (is_used[static_cast<std::size_t>(i)] != 0) box_.extend(Eigen::Vector3d(x.col(i)));
    }
    const double size = box_.isEmpty() ? 0.0 : box_.sizes().maxCoeff();
    cells_per_length_ = size > 0.0 ? (1 << hilbert_bits) / size : 0.0;
  }

  std::uint64_t place_of(std::uint32_t element) const {
    Eigen::Vector3d middle = Eigen::Vector3d::Zero();
    const auto nodes = block_.element_nodes(element);
    for (const NodeIndex node : nodes) middle += x_.col(node.value) - box_.min();
    middle *= cells_per_length_ / static_cast<double>(nodes.size());
    std::array<std::uint32_t, 3> cell{};
    for (std::size_t i = 0; i < 3; ++i) {
      // Comparisons with what is not a number are false.
      const double along = middle[static_cast<Eigen::Index>(i)];
      cell[i] = along > 0.0 ? static_cast<std::uint32_t>(std::min(along, (1 << hilbert_bits) - 1.0)) : 0;
    }
    return hilbert_place(cell);
  }

 private:
  const ElementBlock& block_;
  const Eigen::Matrix3Xd& x_;
  Eigen::AlignedBox3d box_;
  double cells_per_length_ = 0.0;
};

Order order_elements(const ElementBlock& block, const Eigen::Matrix3Xd& x) {
  Order order(block.n_elements);
  std::iota(order.begin(), order.end(), 0u);
  if (block.nodes.empty()) return order;
  const CellGrid grid(block, x);
  std::vector<std::pair<std::uint64_t, std::uint32_t>> places(block.n_elements);
  parallel_for(block.n_elements, threads_for(std::size_t{10} * block.n_elements), [&](std::uint32_t i) {
    places[i] = {grid.place_of(i), i};
  });
  std::ranges::sort(places);
  std::ranges::transform(places, order.begin(), [](const auto& place) { return place.second; });
  return order;
}

/// Items of so many numbers each, in a new order.
template <class T>
void reorder(const Order& order, std::size_t n_numbers, std::vector<T>& items) {
  if (items.empty()) return;
  std::vector<T> reordered(items.size());
  for_each(order.size(), [&](std::uint32_t i) {
    std::copy_n(items.begin() + static_cast<std::ptrdiff_t>(order[i] * n_numbers), n_numbers,
                reordered.begin() + static_cast<std::ptrdiff_t>(i * n_numbers));
  });
  items = std::move(reordered);
}

/// Where the file has what now stands at each position; those beyond the end, and all of none, as it was.
void reorder_places(Order order, std::vector<std::uint32_t>& places) {
  for (std::uint32_t& place : order) place = place < places.size() ? places[place] : place;
  places = std::move(order);
}

void reorder_elements(MeshParts& parts) {
  std::size_t n_elements = 0;
  for (const ElementBlock& block : parts.blocks) n_elements += block.n_elements;
  Order order;
  order.reserve(n_elements);
  for (ElementBlock& block : parts.blocks) {
    const Order of_block = order_elements(block, parts.coordinates);
    reorder(of_block, static_cast<std::size_t>(block.nodes_per_element), block.nodes);
    reorder(of_block, block.attribute_names.size(), block.attributes);
    for (const std::uint32_t element : of_block) order.push_back(block.first_element.value + element);
  }
  reorder(order, 1, parts.element_ids);
  if (std::ranges::any_of(parts.side_sets, [](const SideSet& set) { return !set.sides.empty(); })) {
    const Order now = inverse(order);
    for (SideSet& set : parts.side_sets) {
      for (ElementSide& side : set.sides) side = ElementSide({now[side.element().value]}, side.side());
    }
  }
  reorder_places(std::move(order), parts.element_places);
}

/// A number of a node by which those of its neighbours tell nothing of it. Source: Steele, Lea and Flood,
/// OOPSLA 2014, 453-472: SplittableRandom, Stafford's variant 13.
std::uint64_t mixed(std::uint64_t node) {
  node += 0x9e3779b97f4a7c15u;
  node = (node ^ (node >> 30)) * 0xbf58476d1ce4e5b9u;
  node = (node ^ (node >> 27)) * 0x94d049bb133111ebu;
  return node ^ (node >> 31);
}

/// Marks the nodes of faces that solids do not share, and of all that is no solid. A face has one number, the
/// sum of those of its corners, by which it turns over bits of its nodes: what two elements share turns them
/// back, so that nothing is left at nodes inside; elsewhere something is, but in one case of 2^64.
std::vector<std::uint64_t> mark_surface_nodes(const Mesh& mesh) {
  std::vector<std::uint64_t> marks(mesh.n_nodes(), 0);
  for (const ElementBlock& block : mesh.blocks()) {
    const Topology& shape = topology(block.shape);
    if (shape.family != Family::solid) {
      for (const NodeIndex node : block.nodes) marks[node.value] = 1;
      continue;
    }
    const auto turn_over = [&](ElementSide side, const element_faces::Corners& corners) {
      const std::size_t n_corners = corners[3] == corners[2] ? 3 : 4;
      std::uint64_t bits = 0;
      for (std::size_t k = 0; k < n_corners; ++k) bits += mixed(corners[k]);
      for (std::size_t k = 0; k < n_corners; ++k) marks[corners[k]] ^= bits;
      if (shape.split_faces.empty()) return;
      const auto between = mesh.side_facets(side).corners[3];  // the midside nodes
      for (std::size_t k = 0; k < 3; ++k) marks[between[k].value] ^= bits;
    };
    element_faces::visit_faces_of_block(
        block, block.n_elements, [&](std::uint32_t i) { return block.first_element.value + i; }, turn_over);
  }
  return marks;
}

/// Numbers nodes block by block, those of surfaces before those inside, as elements use them first.
///   is_on_surface  [n_nodes] 0: inside
Order number_nodes(std::span<const std::uint64_t> is_on_surface, MeshParts& parts) {
  const auto n_nodes = static_cast<std::uint32_t>(parts.coordinates.cols());
  std::vector<OptionalIndex<std::uint32_t>> now(n_nodes);
  Order order;
  order.reserve(n_nodes);
  const auto number_of = [&](std::uint32_t node) {
    OptionalIndex<std::uint32_t>& number = now[node];
    if (!number) {
      number = static_cast<std::uint32_t>(order.size());
      order.push_back(node);
    }
    return *number;
  };
  for (ElementBlock& block : parts.blocks) {
    for (const NodeIndex node : block.nodes) {
      if (is_on_surface[node.value] != 0) number_of(node.value);
    }
    for (NodeIndex& node : block.nodes) node.value = number_of(node.value);
  }
  for (std::uint32_t node = 0; node < n_nodes; ++node) number_of(node);
  for (NodeSet& set : parts.node_sets) {
    for (NodeIndex& node : set.nodes) node.value = number_of(node.value);
  }
  return order;
}

///   is_on_surface  as for number_nodes
void reorder_nodes(std::span<const std::uint64_t> is_on_surface, MeshParts& parts) {
  Order order = number_nodes(is_on_surface, parts);
  Eigen::Matrix3Xd coordinates(3, parts.coordinates.cols());
  for_each(order.size(), [&](std::uint32_t i) { coordinates.col(i) = parts.coordinates.col(order[i]); });
  parts.coordinates = std::move(coordinates);
  reorder(order, 1, parts.node_ids);
  reorder_places(std::move(order), parts.node_places);
}

/// The bits of a number, at most 16, with two zeros before each of them.
std::uint64_t spread(std::uint64_t bits) {
  bits = (bits | bits << 16) & 0x0000'0000'ff00'00ff;
  bits = (bits | bits << 8) & 0x0000'00f0'0f00'f00f;
  bits = (bits | bits << 4) & 0x0000'0c30'c30c'30c3;
  return (bits | bits << 2) & 0x0000'2492'4924'9249;
}

}  // namespace

std::uint64_t hilbert_place(std::array<std::uint32_t, 3> cell) {
  constexpr std::uint32_t highest = 1u << (hilbert_bits - 1);
  for (std::uint32_t bit = highest; bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& along : cell) {
      // Turned over where the bit is set, else swapped with the first: no branch, which no processor
      // foresees.
      const std::uint32_t turned = (along & bit) != 0 ? below : 0;
      const std::uint32_t swapped = (cell[0] ^ along) & below & ~turned;
      along ^= swapped;
      cell[0] ^= swapped | turned;
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t turned = 0;
  for (std::uint32_t bit = highest; bit > 1; bit >>= 1) turned ^= (cell[2] & bit) != 0 ? bit - 1 : 0;
  return spread(cell[0] ^ turned) << 2 | spread(cell[1] ^ turned) << 1 | spread(cell[2] ^ turned);
}

Mesh renumber_mesh(Mesh mesh) {
  const std::vector<std::uint64_t> is_on_surface = mark_surface_nodes(mesh);
  MeshParts parts = std::move(mesh).release();
  reorder_elements(parts);
  reorder_nodes(is_on_surface, parts);
  return Mesh(std::move(parts));
}

}  // namespace contactsim
