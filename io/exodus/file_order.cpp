// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/file_order.hpp"

#include <algorithm>

namespace contactsim {

template <class PlaceOf>
FileOrder::FileOrder(std::uint32_t n, const PlaceOf& place_of) : n_(n) {
  std::uint32_t i = 0;
  while (i < n && place_of(i) == i) ++i;
  if (i == n) return;
  positions_.resize(n);
  for (i = 0; i < n; ++i) positions_[place_of(i)] = i;
}

FileOrder FileOrder::of_nodes(const Mesh& mesh) {
  return {mesh.n_nodes(), [&](std::uint32_t i) { return mesh.node_place({i}); }};
}

FileOrder FileOrder::of_block(const Mesh& mesh, const ElementBlock& block) {
  const std::uint32_t first = block.first_element.value;
  return {block.n_elements, [&, first](std::uint32_t i) { return mesh.element_place({first + i}) - first; }};
}

void FileOrder::to_mesh(std::span<double> values) const {
  if (is_same()) return;
  const std::vector<double> of_file(values.begin(), values.end());
  for (std::uint32_t place = 0; place < n_; ++place) values[positions_[place]] = of_file[place];
}

}  // namespace contactsim
