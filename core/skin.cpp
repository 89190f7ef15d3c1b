// SPDX-License-Identifier: BSD-3-Clause
#include "core/skin.hpp"

#include <omp.h>

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>

namespace contactsim {

namespace {

/// A face by its corner nodes; a triangle repeats its last node.
using Corners = std::array<std::uint32_t, 4>;

/// One face of one element, filed under its smallest node.
struct FaceRecord {
  std::uint32_t node_sum;  ///< of its corners, modulo 2^32: equal for equal faces, seldom for others
  ElementSide side;
};

/// The faces of a shape that matter to skins: every face of a solid, one of a shell.
struct SkinFaces {
  int n = 0;
  std::array<std::array<std::uint8_t, 4>, 6> corners{};  ///< positions in the element's nodes
};

SkinFaces skin_faces(const Topology& shape) {
  SkinFaces faces;
  if (shape.family == Family::solid) {
    for (const Side& side : shape.sides) faces.corners[static_cast<std::size_t>(faces.n++)] = side.corners;
  } else if (shape.family == Family::shell) {
    faces.n = 1;
    faces.corners[0] = {0, 1, 2, static_cast<std::uint8_t>(shape.n_corners - 1)};
  }
  return faces;
}

Corners corners_of(const std::array<std::uint8_t, 4>& corners, const NodeIndex* nodes) {
  return {nodes[corners[0]].value, nodes[corners[1]].value, nodes[corners[2]].value, nodes[corners[3]].value};
}

/// Turns a face with repeated nodes into a triangle, or into nothing (false) when fewer than three nodes are
/// left.
bool reduce(Corners& corners) {
  Corners distinct{};
  auto end = distinct.begin();
  for (const std::uint32_t node : corners) {
    if (std::find(distinct.begin(), end, node) == end) *end++ = node;
  }
  const auto n = end - distinct.begin();
  if (n < 3) return false;
  if (n == 3) distinct[3] = distinct[2];
  corners = distinct;
  return true;
}

std::uint32_t smallest(const Corners& c) { return std::min(std::min(c[0], c[1]), std::min(c[2], c[3])); }

/// Independent of the corners' order; a triangle's repeated node counts once.
std::uint32_t node_sum(const Corners& c) { return c[0] + c[1] + c[2] + (c[3] == c[2] ? 0u : c[3]); }

/// Calls `visit(side, corners)` for every face of the present elements of a block from `first` up to `last`
/// (positions in the block).
template <class Visit>
void visit_faces(const ElementBlock& block, std::span<const std::uint8_t> present, std::uint32_t first,
                 std::uint32_t last, Visit&& visit) {
  const SkinFaces faces = skin_faces(topology(block.shape));
  if (faces.n == 0) return;
  const NodeIndex* nodes = block.nodes.data() + static_cast<std::size_t>(first) * block.nodes_per_element;
  for (std::uint32_t i = first; i < last; ++i, nodes += block.nodes_per_element) {
    const ElementIndex element{block.first_element.value + i};
    if (!present[element.value]) continue;
    for (int f = 0; f < faces.n; ++f) {
      Corners corners = corners_of(faces.corners[static_cast<std::size_t>(f)], nodes);
      if (block.has_repeated_nodes && !reduce(corners)) continue;
      visit(ElementSide(element, f + 1), corners);
    }
  }
}

/// The same over all blocks, for the elements from `first` up to `last` (positions in the mesh).
template <class Visit>
void visit_faces(const Mesh& mesh, std::span<const std::uint8_t> present, std::uint32_t first,
                 std::uint32_t last, Visit&& visit) {
  for (const ElementBlock& block : mesh.blocks()) {
    const std::uint32_t begin = std::max(first, block.first_element.value);
    const std::uint32_t end = std::min(last, block.first_element.value + block.n_elements);
    if (begin >= end) continue;
    visit_faces(block, present, begin - block.first_element.value, end - block.first_element.value, visit);
  }
}

/// All faces of the present elements, sorted by smallest node; within one node in element order.
class FaceBuckets {
 public:
  FaceBuckets(const Mesh& mesh, std::span<const std::uint8_t> present);

  std::span<const FaceRecord> of_node(std::uint32_t node) const {
    return {records_.get() + begin_[node], records_.get() + begin_[node + 1]};
  }

 private:
  std::vector<std::uint32_t> begin_;       ///< [n_nodes + 1]
  std::unique_ptr<FaceRecord[]> records_;  ///< not initialised before it is filled
};

/// More histograms than this cost more memory than they save time.
constexpr int max_counting_threads = 8;

FaceBuckets::FaceBuckets(const Mesh& mesh, std::span<const std::uint8_t> present)
    : begin_(mesh.n_nodes() + 1) {
  const int n_chunks = std::clamp(omp_get_max_threads(), 1, max_counting_threads);
  const auto chunk_begin = [&](int chunk) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(mesh.n_elements()) * chunk / n_chunks);
  };
  std::vector<std::vector<std::uint32_t>> cursor(static_cast<std::size_t>(n_chunks));
#pragma omp parallel for schedule(static, 1) num_threads(n_chunks)
  for (int chunk = 0; chunk < n_chunks; ++chunk) {
    auto& count = cursor[static_cast<std::size_t>(chunk)];
    count.assign(mesh.n_nodes(), 0);
    visit_faces(mesh, present, chunk_begin(chunk), chunk_begin(chunk + 1),
                [&](ElementSide, const Corners& corners) { ++count[smallest(corners)]; });
  }
  std::uint32_t total = 0;
  for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
    begin_[node] = total;
    for (auto& count : cursor) {
      const std::uint32_t n_faces = count[node];
      count[node] = total;
      total += n_faces;
    }
  }
  begin_[mesh.n_nodes()] = total;
  records_ = std::make_unique_for_overwrite<FaceRecord[]>(total);
#pragma omp parallel for schedule(static, 1) num_threads(n_chunks)
  for (int chunk = 0; chunk < n_chunks; ++chunk) {
    auto& next = cursor[static_cast<std::size_t>(chunk)];
    visit_faces(mesh, present, chunk_begin(chunk), chunk_begin(chunk + 1),
                [&](ElementSide side, const Corners& corners) {
                  records_[next[smallest(corners)]++] = {node_sum(corners), side};
                });
  }
}

/// Which faces are alone, and which faces of solids are shared with other blocks only.
struct SkinPart {
  std::vector<ElementSide> exterior;
  std::vector<std::uint32_t> in_between;  ///< [n_blocks]
};

/// Takes bucket after bucket and tells the exterior faces from the shared ones. One per thread.
class FaceMatcher {
 public:
  explicit FaceMatcher(const Mesh& mesh) : mesh_(mesh) {
    for (const ElementBlock& block : mesh.blocks()) faces_.push_back(skin_faces(topology(block.shape)));
  }

  void match(std::span<const FaceRecord> bucket, SkinPart& part) {
    bucket_.assign(bucket.begin(), bucket.end());
    const auto by_sum = [](const FaceRecord& a, const FaceRecord& b) {
      return std::pair(a.node_sum, a.side) < std::pair(b.node_sum, b.side);
    };
    std::sort(bucket_.begin(), bucket_.end(), by_sum);
    for (auto first = bucket_.begin(); first != bucket_.end();) {
      auto last = first + 1;
      while (last != bucket_.end() && last->node_sum == first->node_sum) ++last;
      match_candidates({first, last}, part);
      first = last;
    }
  }

 private:
  /// Splits faces of one node sum into groups of equal faces; nearly always they are one group.
  void match_candidates(std::span<FaceRecord> candidates, SkinPart& part) {
    while (!candidates.empty()) {
      std::size_t n_equal = 1;
      if (candidates.size() > 1) {
        const Corners corners = sorted_corners(candidates[0].side);
        for (std::size_t i = 1; i < candidates.size(); ++i) {
          if (sorted_corners(candidates[i].side) == corners) std::swap(candidates[i], candidates[n_equal++]);
        }
      }
      add_group(candidates.first(n_equal), part);
      candidates = candidates.subspan(n_equal);
    }
  }

  void add_group(std::span<const FaceRecord> group, SkinPart& part) {
    if (group.size() == 1) {
      const ElementSide side = group[0].side;
      const Shape shape = mesh_.blocks()[block_of(side.element())].shape;
      if (topology(shape).family == Family::solid) part.exterior.push_back(side);
      return;
    }
    if (mesh_.blocks().size() == 1) return;
    for (const FaceRecord& record : group) {
      const std::uint32_t block = block_of(record.side.element());
      const auto of_same_block = std::count_if(group.begin(), group.end(), [&](const FaceRecord& other) {
        return block_of(other.side.element()) == block;
      });
      const bool is_solid = topology(mesh_.blocks()[block].shape).family == Family::solid;
      if (is_solid && of_same_block == 1) ++part.in_between[block];
    }
  }

  Corners sorted_corners(ElementSide side) {
    const std::uint32_t block_index = block_of(side.element());
    const ElementBlock& block = mesh_.blocks()[block_index];
    const auto nodes = block.element_nodes(side.element().value - block.first_element.value);
    const auto face = static_cast<std::size_t>(side.side() - 1);
    Corners corners = corners_of(faces_[block_index].corners[face], nodes.data());
    if (block.has_repeated_nodes) reduce(corners);
    std::sort(corners.begin(), corners.end());
    return corners;
  }

  /// Nearly always the block asked for last.
  std::uint32_t block_of(ElementIndex element) {
    const ElementBlock& last = mesh_.blocks()[last_block_];
    if (element.value - last.first_element.value >= last.n_elements) last_block_ = mesh_.block_of(element);
    return last_block_;
  }

  const Mesh& mesh_;
  std::vector<SkinFaces> faces_;  ///< [n_blocks]
  std::vector<FaceRecord> bucket_;
  std::uint32_t last_block_ = 0;
};

/// Pieces of node numbers that threads take in turn; their number does not show in the result.
constexpr std::uint32_t n_node_ranges = 64;

std::vector<SkinPart> match_all(const Mesh& mesh, const FaceBuckets& buckets) {
  std::vector<SkinPart> parts(n_node_ranges);
#pragma omp parallel
  {
    FaceMatcher matcher(mesh);
#pragma omp for schedule(dynamic)
    for (std::uint32_t range = 0; range < n_node_ranges; ++range) {
      SkinPart& part = parts[range];
      part.in_between.assign(mesh.blocks().size(), 0);
      const auto begin = static_cast<std::uint64_t>(mesh.n_nodes()) * range / n_node_ranges;
      const auto end = static_cast<std::uint64_t>(mesh.n_nodes()) * (range + 1) / n_node_ranges;
      for (auto node = begin; node < end; ++node) {
        matcher.match(buckets.of_node(static_cast<std::uint32_t>(node)), part);
      }
    }
  }
  return parts;
}

}  // namespace

std::span<const ElementSide> Skin::of_block(const ElementBlock& block) const {
  const std::uint32_t end = block.first_element.value + block.n_elements;
  const auto first = std::lower_bound(exterior.begin(), exterior.end(), ElementSide(block.first_element, 1));
  const auto last = std::lower_bound(first, exterior.end(), ElementSide({end}, 1));
  return {first, last};
}

Skin make_skin(const Mesh& mesh, std::span<const std::uint8_t> present) {
  Skin skin;
  skin.in_between.assign(mesh.blocks().size(), 0);
  const FaceBuckets buckets(mesh, present);
  for (const SkinPart& part : match_all(mesh, buckets)) {
    skin.exterior.insert(skin.exterior.end(), part.exterior.begin(), part.exterior.end());
    std::transform(part.in_between.begin(), part.in_between.end(), skin.in_between.begin(),
                   skin.in_between.begin(), std::plus<>());
  }
  std::sort(skin.exterior.begin(), skin.exterior.end());
  return skin;
}

}  // namespace contactsim
