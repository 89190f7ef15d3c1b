// SPDX-License-Identifier: BSD-3-Clause
#include "support/mesh_builder.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cassert>
#include <cmath>

namespace contactsim::test {

namespace {

// Nodes closer than this are one node when both share.
constexpr double merge_length = 1e-7;

}  // namespace

NodeIndex MeshBuilder::add_node(const Eigen::Vector3d& position) {
  positions_.push_back(position);
  return {static_cast<std::uint32_t>(positions_.size() - 1)};
}

NodeIndex MeshBuilder::node_at(const Eigen::Vector3d& position, bool share) {
  if (!share) return add_node(position);
  std::array<long long, 3> key;
  for (int i = 0; i < 3; ++i) key[static_cast<std::size_t>(i)] = std::llround(position[i] / merge_length);
  const auto found = shared_nodes_.find(key);
  if (found != shared_nodes_.end()) return found->second;
  return shared_nodes_[key] = add_node(position);
}

ElementBlock& MeshBuilder::open_block(std::int64_t id, const std::string& name, Shape shape) {
  ElementBlock& block = parts_.blocks.emplace_back();
  block.id = id;
  block.name = name;
  block.shape = shape;
  block.type_name = topology(shape).name;
  block.nodes_per_element = topology(shape).n_nodes;
  if (parts_.blocks.size() > 1) {
    const ElementBlock& before = parts_.blocks[parts_.blocks.size() - 2];
    block.first_element = {before.first_element.value + before.n_elements};
  }
  return block;
}

void MeshBuilder::close_block() {
  ElementBlock& block = parts_.blocks.back();
  const auto n_nodes = static_cast<std::size_t>(block.nodes_per_element);
  if (n_nodes == 0) return;
  assert(block.nodes.size() % n_nodes == 0);
  block.n_elements = static_cast<std::uint32_t>(block.nodes.size() / n_nodes);
  for (std::uint32_t e = 0; e < block.n_elements; ++e) {
    const auto nodes = block.element_nodes(e);
    std::vector<NodeIndex> sorted(nodes.begin(), nodes.end());
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end()) block.has_repeated_nodes = true;
  }
}

void MeshBuilder::for_each_cell(const Box& box,
                                const std::function<void(const std::array<NodeIndex, 8>&, int)>& make) {
  const auto [nx, ny, nz] = box.cells;
  std::vector<NodeIndex> grid;
  for (int k = 0; k <= nz; ++k) {
    for (int j = 0; j <= ny; ++j) {
      for (int i = 0; i <= nx; ++i) {
        const Eigen::Vector3d fraction(double(i) / nx, double(j) / ny, double(k) / nz);
        grid.push_back(node_at(box.origin + box.size.cwiseProduct(fraction), box.share_nodes));
      }
    }
  }
  const auto width = static_cast<std::size_t>(nx) + 1, layer = width * (static_cast<std::size_t>(ny) + 1);
  for (int cell = 0; cell < nx * ny * nz; ++cell) {
    const int i = cell % nx, j = cell / nx % ny, k = cell / (nx * ny);
    const std::size_t n = static_cast<std::size_t>(i) + width * static_cast<std::size_t>(j) +
                          layer * static_cast<std::size_t>(k);
    make({grid[n], grid[n + 1], grid[n + width + 1], grid[n + width], grid[n + layer], grid[n + layer + 1],
          grid[n + layer + width + 1], grid[n + layer + width]},
         i + j + k);
  }
}

void MeshBuilder::for_each_cell(const Sheet& sheet,
                                const std::function<void(const std::array<NodeIndex, 4>&)>& make) {
  const auto [nu, nv] = sheet.cells;
  std::vector<NodeIndex> grid;
  for (int j = 0; j <= nv; ++j) {
    for (int i = 0; i <= nu; ++i) {
      grid.push_back(
          node_at(sheet.origin + sheet.u * (double(i) / nu) + sheet.v * (double(j) / nv), sheet.share_nodes));
    }
  }
  const auto width = static_cast<std::size_t>(nu) + 1;
  for (int cell = 0; cell < nu * nv; ++cell) {
    const std::size_t n = static_cast<std::size_t>(cell % nu) + width * static_cast<std::size_t>(cell / nu);
    make({grid[n], grid[n + 1], grid[n + width + 1], grid[n + width]});
  }
}

void MeshBuilder::append(std::initializer_list<NodeIndex> nodes) {
  auto& all = parts_.blocks.back().nodes;
  all.insert(all.end(), nodes);
}

void MeshBuilder::append_tet(std::array<NodeIndex, 4> nodes) {
  const auto edge = [&](std::size_t i) -> Eigen::Vector3d {
    return positions_[nodes[i].value] - positions_[nodes[0].value];
  };
  if (edge(1).cross(edge(2)).dot(edge(3)) < 0.0) std::swap(nodes[1], nodes[2]);
  append({nodes[0], nodes[1], nodes[2], nodes[3]});
}

MeshBuilder& MeshBuilder::add_hexes(const Box& box) {
  open_block(box.id, box.name, Shape::hex8);
  for_each_cell(box, [&](const auto& c, int) { append({c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7]}); });
  close_block();
  return *this;
}

namespace {

using Split = std::vector<std::array<std::size_t, 4>>;

// Paths along a cell's edges from corner 0 to 6.
const Split& split_in_six() {
  static const Split six{{0, 1, 2, 6}, {0, 1, 5, 6}, {0, 3, 2, 6}, {0, 3, 7, 6}, {0, 4, 5, 6}, {0, 4, 7, 6}};
  return six;
}

}  // namespace

MeshBuilder& MeshBuilder::add_ten_node_tets(const Box& box) {
  constexpr std::array<std::array<std::size_t, 2>, 6> edges{{{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};
  std::map<std::array<std::uint32_t, 2>, NodeIndex> midside;
  open_block(box.id, box.name, Shape::tet10);
  for_each_cell(box, [&](const auto& c, int) {
    for (const auto& tet : split_in_six()) {
      append_tet({c[tet[0]], c[tet[1]], c[tet[2]], c[tet[3]]});
      const std::vector<NodeIndex>& all = parts_.blocks.back().nodes;
      const std::vector<NodeIndex> corners(all.end() - 4, all.end());
      for (const auto& [first, second] : edges) {
        const NodeIndex a = std::min(corners[first], corners[second]),
                        b = std::max(corners[first], corners[second]);
        const auto found = midside.find({a.value, b.value});
        const NodeIndex node =
            found != midside.end()
                ? found->second
                : node_at((positions_[a.value] + positions_[b.value]) / 2.0, box.share_nodes);
        midside[{a.value, b.value}] = node;
        append({node});
      }
    }
  });
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_tets(const Box& box, int tets_per_cell) {
  assert(tets_per_cell == 5 || tets_per_cell == 6);
  const Split& six = split_in_six();
  // The two mirrored ways to cut off four corners.
  const Split five_even{{0, 2, 5, 7}, {1, 0, 2, 5}, {3, 0, 2, 7}, {4, 0, 5, 7}, {6, 2, 5, 7}};
  const Split five_odd{{1, 3, 4, 6}, {0, 1, 3, 4}, {2, 1, 3, 6}, {5, 1, 4, 6}, {7, 3, 4, 6}};
  open_block(box.id, box.name, Shape::tet4);
  for_each_cell(box, [&](const auto& c, int parity) {
    const Split& split = tets_per_cell == 6 ? six : parity % 2 == 0 ? five_even : five_odd;
    for (const auto& tet : split) append_tet({c[tet[0]], c[tet[1]], c[tet[2]], c[tet[3]]});
  });
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_wedges(const Box& box) {
  open_block(box.id, box.name, Shape::wedge6);
  for_each_cell(box, [&](const auto& c, int) {
    append({c[0], c[1], c[2], c[4], c[5], c[6]});
    append({c[0], c[2], c[3], c[4], c[6], c[7]});
  });
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_pyramids(const Box& box) {
  open_block(box.id, box.name, Shape::pyramid5);
  for_each_cell(box, [&](const auto& c, int) {
    const NodeIndex middle =
        node_at((positions_[c[0].value] + positions_[c[6].value]) / 2.0, box.share_nodes);
    // A pyramid's base turns inward, a hexahedron's side outward.
    for (const Side& side : topology(Shape::hex8).sides) {
      append({c[side.corners[0]], c[side.corners[3]], c[side.corners[2]], c[side.corners[1]], middle});
    }
  });
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_shells(const Sheet& sheet) {
  open_block(sheet.id, sheet.name, Shape::shell4);
  for_each_cell(sheet, [&](const auto& c) { append({c[0], c[1], c[2], c[3]}); });
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_triangles(const Sheet& sheet) {
  open_block(sheet.id, sheet.name, Shape::shell3);
  for_each_cell(sheet, [&](const auto& c) {
    append({c[0], c[1], c[2]});
    append({c[0], c[2], c[3]});
  });
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_bars(const Row& row) { return add_row(row, Shape::bar2); }

MeshBuilder& MeshBuilder::add_beams(const Row& row) { return add_row(row, Shape::beam2); }

MeshBuilder& MeshBuilder::add_row(const Row& row, Shape shape) {
  open_block(row.id, row.name, shape);
  NodeIndex last = node_at(row.from, row.share_nodes);
  for (int i = 1; i <= row.cells; ++i) {
    const NodeIndex next = node_at(row.from + (row.to - row.from) * (double(i) / row.cells), row.share_nodes);
    append({last, next});
    last = next;
  }
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_spheres(std::int64_t id, const std::string& name,
                                      const std::vector<Eigen::Vector3d>& centres) {
  open_block(id, name, Shape::sphere);
  for (const Eigen::Vector3d& centre : centres) append({node_at(centre, true)});
  close_block();
  return *this;
}

MeshBuilder& MeshBuilder::add_block(std::int64_t id, const std::string& name, Shape shape,
                                    const std::vector<std::uint32_t>& nodes) {
  ElementBlock& block = open_block(id, name, shape);
  for (std::uint32_t node : nodes) block.nodes.push_back({node});
  close_block();
  return *this;
}

MeshParts MeshBuilder::parts() const {
  MeshParts parts = parts_;
  parts.coordinates.resize(3, static_cast<Eigen::Index>(positions_.size()));
  for (std::size_t n = 0; n < positions_.size(); ++n) {
    parts.coordinates.col(static_cast<Eigen::Index>(n)) = positions_[n];
  }
  return parts;
}

}  // namespace contactsim::test
