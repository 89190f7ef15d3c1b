// SPDX-License-Identifier: BSD-3-Clause
#include "io/pieces/side_factors.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace contactsim {

std::optional<std::size_t> count_side_nodes(Shape shape, int side) {
  if (shape == Shape::unknown) return std::nullopt;
  const Topology& facts = topology(shape);
  const Side& corners = facts.sides[static_cast<std::size_t>(side) - 1];
  if (facts.n_nodes == facts.n_corners || corners.kind == SideKind::node) return corners.n_corners;
  if (corners.kind == SideKind::edge) return 3;
  const bool has_centre = shape == Shape::hex27 || shape == Shape::shell9;
  return std::size_t{2} * corners.n_corners + (has_centre ? 1 : 0);
}

ElementShapes::ElementShapes(const NetcdfFile& file, const NetcdfLayout& layout) {
  std::size_t end = 0;
  for (std::size_t number = 1; number <= layout.length("num_el_blk"); ++number) {
    end += layout.length(fmt::format("num_el_in_blk{}", number));
    ends_.push_back(end);
    const auto connectivity = file.find_variable(fmt::format("connect{}", number));
    const bool is_table = connectivity && connectivity->shape.size() == 2 && connectivity->shape[1] <= 1000;
    shapes_.push_back(is_table ? find_shape(file.find_text(*connectivity, "elem_type").value_or(""),
                                            static_cast<int>(connectivity->shape[1]))
                               : Shape::unknown);
  }
}

Shape ElementShapes::of(std::size_t element) const {
  const auto block = static_cast<std::size_t>(std::ranges::upper_bound(ends_, element) - ends_.begin());
  return block < shapes_.size() ? shapes_[block] : Shape::unknown;
}

std::optional<std::vector<std::size_t>> divide_factors(std::span<const ShapedSide> sides,
                                                       std::size_t n_factors) {
  std::vector<std::size_t> counts;
  for (const ShapedSide& side : sides) {
    const auto n_sides = static_cast<std::int64_t>(topology(side.shape).sides.size());
    if (side.side < 1 || side.side > n_sides) break;
    counts.push_back(count_side_nodes(side.shape, static_cast<int>(side.side)).value_or(0));
  }
  if (counts.size() == sides.size() &&
      std::accumulate(counts.begin(), counts.end(), std::size_t{0}) == n_factors)
    return counts;
  if (sides.empty() || n_factors % sides.size() != 0) return std::nullopt;
  return std::vector<std::size_t>(sides.size(), n_factors / sides.size());
}

}  // namespace contactsim
