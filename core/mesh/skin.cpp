// SPDX-License-Identifier: BSD-3-Clause
#include "core/mesh/skin.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

#include "core/base/threads.hpp"
#include "core/mesh/element_faces.hpp"

namespace contactsim {

namespace {

using namespace element_faces;

/// Nodes are taken in ranges of this many, whose faces fit into a core's cache together.
constexpr std::uint32_t nodes_per_range = 1u << 15;

constexpr std::uint32_t range_of(std::uint32_t node) { return node / nodes_per_range; }

/// For every range of nodes the present elements that have a face whose smallest node lies in it.
class RangeElements {
 public:
  RangeElements(const Mesh& mesh, std::span<const std::uint8_t> present);

  std::uint32_t n_ranges() const { return static_cast<std::uint32_t>(begin_.size() - 1); }
  /// Ascending.
  std::span<const std::uint32_t> of(std::uint32_t range) const {
    return {elements_.data() + begin_[range], elements_.data() + begin_[range + 1]};
  }

 private:
  /// The elements of each range, of those from one on before another [n_ranges].
  std::vector<std::vector<std::uint32_t>> list(const Mesh& mesh, std::span<const std::uint8_t> present,
                                               std::uint32_t begin, std::uint32_t end) const;

  std::vector<std::size_t> begin_;  ///< [n_ranges + 1]
  std::vector<std::uint32_t> elements_;
};

/// More lists than this cost more time than they save.
constexpr int max_chunks = 64;

RangeElements::RangeElements(const Mesh& mesh, std::span<const std::uint8_t> present)
    : begin_((mesh.n_nodes() + nodes_per_range - 1) / nodes_per_range + 1, 0) {
  const int n_chunks = std::min(threads_for(mesh.n_elements()), max_chunks);
  const auto begin_of = [&](int chunk) {
    return static_cast<std::uint32_t>(std::uint64_t{mesh.n_elements()} * static_cast<std::uint64_t>(chunk) /
                                      static_cast<std::uint64_t>(n_chunks));
  };
  std::vector<std::vector<std::vector<std::uint32_t>>> lists(static_cast<std::size_t>(n_chunks));
  parallel_for(n_chunks, n_chunks, [&](int chunk) {
    lists[static_cast<std::size_t>(chunk)] = list(mesh, present, begin_of(chunk), begin_of(chunk + 1));
  });
  for (std::uint32_t range = 0; range < n_ranges(); ++range) {
    begin_[range + 1] = begin_[range];
    for (const auto& of_chunk : lists) begin_[range + 1] += of_chunk[range].size();
  }
  elements_.reserve(begin_.back());
  for (std::uint32_t range = 0; range < n_ranges(); ++range) {
    for (const auto& of_chunk : lists)
      elements_.insert(elements_.end(), of_chunk[range].begin(), of_chunk[range].end());
  }
}

std::vector<std::vector<std::uint32_t>> RangeElements::list(const Mesh& mesh,
                                                            std::span<const std::uint8_t> present,
                                                            std::uint32_t begin, std::uint32_t end) const {
  std::vector<std::vector<std::uint32_t>> lists(n_ranges());
  visit_faces(mesh, begin, end, [&](ElementSide side, const Corners& corners) {
    const std::uint32_t element = side.element().value;
    std::vector<std::uint32_t>& of_range = lists[range_of(smallest(corners))];
    if (present[element] && (of_range.empty() || of_range.back() != element)) of_range.push_back(element);
  });
  return lists;
}

/// Turns counts into the offsets where each begins; returns their sum.
std::uint32_t make_offsets(std::vector<std::uint32_t>& counts) {
  std::uint32_t total = 0;
  for (std::uint32_t& count : counts) total += std::exchange(count, total);
  return total;
}

/// Takes bucket after bucket and tells the exterior faces from the shared ones. One per thread.
class FaceMatcher {
 public:
  explicit FaceMatcher(const Mesh& mesh) : mesh_(mesh), in_between_(mesh.blocks().size(), 0) {}

  /// Matches the faces that are filed under one range of nodes; returns the exterior ones.
  ///   elements  all that have such faces, ascending
  std::vector<ElementSide> match(std::uint32_t range, std::span<const std::uint32_t> elements) {
    exterior_.clear();
    sort_faces(range, elements);
    const FaceRecord* begin = records_.data();
    for (const std::uint32_t end : bucket_end_) {
      match_bucket({begin, records_.data() + end});
      begin = records_.data() + end;
    }
    return exterior_;
  }

  /// [n_blocks] faces found so far that a block's solids share with other blocks only.
  const std::vector<std::uint32_t>& in_between() const { return in_between_; }

 private:
  /// Fills records_, by smallest node; within one node in element order.
  void sort_faces(std::uint32_t range, std::span<const std::uint32_t> elements) {
    const std::uint32_t first = range * nodes_per_range;
    const auto n_nodes = std::min(nodes_per_range, static_cast<std::uint32_t>(mesh_.n_nodes()) - first);
    bucket_end_.assign(n_nodes, 0);
    found_.clear();
    visit_faces(mesh_, elements, [&](ElementSide side, const Corners& corners) {
      const std::uint32_t node = smallest(corners) - first;
      if (node >= n_nodes) return;
      ++bucket_end_[node];
      found_.push_back({node, make_record(corners, side)});
    });
    const std::uint32_t n = make_offsets(bucket_end_);
    if (n > records_.size()) records_.resize(n);
    for (const auto& [node, record] : found_) records_[bucket_end_[node]++] = record;
  }

  void match_bucket(std::span<const FaceRecord> bucket) {
    constexpr std::size_t small = 32;
    if (bucket.size() <= small) return match_pairwise(bucket);
    sorted_.assign(bucket.begin(), bucket.end());
    std::sort(sorted_.begin(), sorted_.end());
    for (auto first = sorted_.begin(); first != sorted_.end();) {
      const auto last =
          std::find_if_not(first, sorted_.end(), [&](const FaceRecord& r) { return r.has_nodes_of(*first); });
      const auto n = static_cast<std::size_t>(last - first);
      if (n == 1) add_single(first->side);
      if (n > 1) {
        group_.clear();
        std::transform(first, last, std::back_inserter(group_), [](const FaceRecord& r) { return r.side; });
        add_shared(group_);
      }
      first = last;
    }
  }

  /// For the usual few faces of a node comparing all pairs is fastest.
  void match_pairwise(std::span<const FaceRecord> bucket) {
    std::uint32_t done = 0;  // bit i: face i was found in a group
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      if (done >> i & 1u) continue;
      std::uint32_t same = 0;
      for (std::size_t j = i + 1; j < bucket.size(); ++j) {
        same |= static_cast<std::uint32_t>(bucket[i].has_nodes_of(bucket[j])) << j;
      }
      if (same == 0) {
        add_single(bucket[i].side);
      } else if (mesh_.blocks().size() > 1) {
        group_.assign(1, bucket[i].side);
        for (std::size_t j = i + 1; j < bucket.size(); ++j) {
          if (same >> j & 1u) group_.push_back(bucket[j].side);
        }
        add_shared(group_);
      }
      done |= same;
    }
  }

  void add_single(ElementSide side) {
    const Shape shape = mesh_.blocks()[block_of(side.element())].shape;
    if (topology(shape).family == Family::solid) exterior_.push_back(side);
  }

  void add_shared(std::span<const ElementSide> group) {
    visit_in_between(
        mesh_, group, [this](ElementIndex element) { return block_of(element); },
        [this](std::uint32_t block) { ++in_between_[block]; });
  }

  /// Nearly always the block asked for last.
  std::uint32_t block_of(ElementIndex element) {
    const ElementBlock& last = mesh_.blocks()[last_block_];
    if (element.value - last.first_element.value >= last.n_elements) last_block_ = mesh_.block_of(element);
    return last_block_;
  }

  const Mesh& mesh_;
  std::vector<std::pair<std::uint32_t, FaceRecord>> found_;  ///< smallest node and face, in element order
  std::vector<FaceRecord> records_;                          ///< the same by smallest node
  std::vector<std::uint32_t> bucket_end_;  ///< [nodes of the range] end of each node's records
  std::vector<FaceRecord> sorted_;
  std::vector<ElementSide> group_;
  std::vector<ElementSide> exterior_;
  std::vector<std::uint32_t> in_between_;
  std::uint32_t last_block_ = 0;
};

}  // namespace

std::span<const ElementSide> Skin::sides_of_block(const ElementBlock& block) const {
  const std::uint32_t end = block.first_element.value + block.n_elements;
  const auto first = std::lower_bound(exterior.begin(), exterior.end(), ElementSide(block.first_element, 1));
  const auto last = std::lower_bound(first, exterior.end(), ElementSide({end}, 1));
  return {first, last};
}

Skin make_skin(const Mesh& mesh, std::span<const std::uint8_t> present) {
  const RangeElements elements(mesh, present);
  std::vector<std::vector<ElementSide>> exterior(elements.n_ranges());
  Skin skin;
  skin.in_between.assign(mesh.blocks().size(), 0);
#pragma omp parallel num_threads(threads_for(mesh.n_elements()))
  {
    FaceMatcher matcher(mesh);
#pragma omp for schedule(dynamic)
    for (std::uint32_t range = 0; range < elements.n_ranges(); ++range) {
      exterior[range] = matcher.match(range, elements.of(range));
    }
#pragma omp critical(contactsim_skin)
    std::transform(skin.in_between.begin(), skin.in_between.end(), matcher.in_between().begin(),
                   skin.in_between.begin(), std::plus<>());
  }
  for (const auto& range_sides : exterior) {
    skin.exterior.insert(skin.exterior.end(), range_sides.begin(), range_sides.end());
  }
  std::sort(skin.exterior.begin(), skin.exterior.end());
  return skin;
}

}  // namespace contactsim
