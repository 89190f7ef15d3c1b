// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/renumber_mesh.hpp"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/base/optional_index.hpp"
#include "core/base/threads.hpp"
#include "core/mesh/mesh_parts.hpp"

namespace contactsim {

namespace {

/// What stands at each new position, by its old one.
using Order = std::vector<std::uint32_t>;

/// Where what stood at each old position is now.
Order inverse(const Order& order) {
  Order now(order.size());
  for (std::uint32_t i = 0; i < order.size(); ++i) now[order[i]] = i;
  return now;
}

/// The grid of cells that holds all elements of a block.
class CellGrid {
 public:
  CellGrid(const ElementBlock& block, const Eigen::Matrix3Xd& x) : block_(block), x_(x) {
    for (const NodeIndex node : block.nodes) box_.extend(Eigen::Vector3d(x.col(node.value)));
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
  std::vector<T> reordered;
  reordered.reserve(items.size());
  for (const std::uint32_t from : order) {
    const auto begin = items.begin() + static_cast<std::ptrdiff_t>(from * n_numbers);
    reordered.insert(reordered.end(), begin, begin + static_cast<std::ptrdiff_t>(n_numbers));
  }
  items = std::move(reordered);
}

void reorder_elements(MeshParts& parts) {
  Order order;
  for (ElementBlock& block : parts.blocks) {
    const Order of_block = order_elements(block, parts.coordinates);
    reorder(of_block, static_cast<std::size_t>(block.nodes_per_element), block.nodes);
    reorder(of_block, block.attribute_names.size(), block.attributes);
    for (const std::uint32_t element : of_block) order.push_back(block.first_element.value + element);
  }
  reorder(order, 1, parts.element_ids);
  reorder(order, 1, parts.element_places);
  const Order now = inverse(order);
  for (SideSet& set : parts.side_sets) {
    for (ElementSide& side : set.sides) side = ElementSide({now[side.element().value]}, side.side());
  }
}

/// Nodes as elements use them first.
Order order_nodes(const MeshParts& parts) {
  const auto n_nodes = static_cast<std::uint32_t>(parts.coordinates.cols());
  std::vector<std::uint8_t> is_placed(n_nodes, 0);
  Order order;
  order.reserve(n_nodes);
  const auto place = [&](std::uint32_t node) {
    if (std::exchange(is_placed[node], std::uint8_t{1}) == 0) order.push_back(node);
  };
  for (const ElementBlock& block : parts.blocks) {
    for (const NodeIndex node : block.nodes) place(node.value);
  }
  for (std::uint32_t node = 0; node < n_nodes; ++node) place(node);
  return order;
}

void reorder_nodes(MeshParts& parts) {
  const Order order = order_nodes(parts), now = inverse(order);
  Eigen::Matrix3Xd coordinates(3, parts.coordinates.cols());
  for (std::uint32_t i = 0; i < order.size(); ++i) coordinates.col(i) = parts.coordinates.col(order[i]);
  parts.coordinates = std::move(coordinates);
  reorder(order, 1, parts.node_ids);
  reorder(order, 1, parts.node_places);
  for (ElementBlock& block : parts.blocks) {
    for (NodeIndex& node : block.nodes) node.value = now[node.value];
  }
  for (NodeSet& set : parts.node_sets) {
    for (NodeIndex& node : set.nodes) node.value = now[node.value];
  }
}

}  // namespace

std::uint64_t hilbert_place(std::array<std::uint32_t, 3> cell) {
  constexpr std::uint32_t highest = 1u << (hilbert_bits - 1);
  for (std::uint32_t bit = highest; bit > 1; bit >>= 1) {
    const std::uint32_t below = bit - 1;
    for (std::uint32_t& along : cell) {
      if ((along & bit) != 0) {
        cell[0] ^= below;
      } else {
        const std::uint32_t swapped = (cell[0] ^ along) & below;
        cell[0] ^= swapped;
        along ^= swapped;
      }
    }
  }
  cell[1] ^= cell[0];
  cell[2] ^= cell[1];
  std::uint32_t turned = 0;
  for (std::uint32_t bit = highest; bit > 1; bit >>= 1) turned ^= (cell[2] & bit) != 0 ? bit - 1 : 0;
  std::uint64_t place = 0;
  for (int bit = hilbert_bits - 1; bit >= 0; --bit) {
    for (const std::uint32_t along : cell) place = place << 1 | (((along ^ turned) >> bit) & 1);
  }
  return place;
}

Mesh renumber_mesh(const Mesh& mesh) {
  MeshParts parts = parts_of(mesh);
  reorder_elements(parts);
  reorder_nodes(parts);
  return Mesh(std::move(parts));
}

}  // namespace contactsim
