// SPDX-License-Identifier: BSD-3-Clause
#include "core/skin.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <tuple>
#include <type_traits>

#include "core/skin_faces.hpp"
#include "core/threads.hpp"

namespace contactsim {

namespace {

using namespace skin_faces;

/// A half-open range of node numbers.
struct NodeRange {
  std::uint32_t begin = 0, end = 0;
};

/// All faces of the present elements, sorted by smallest node; within one node in element order. Holds the
/// records of one range of nodes at a time, which bounds its memory.
template <class Key>
class FaceBuckets {
 public:
  FaceBuckets(const Mesh& mesh, std::span<const std::uint8_t> present);

  /// Ranges that cover all nodes: one for short keys, two with half of the faces each for long ones.
  std::vector<NodeRange> ranges() const;
  /// Makes the buckets of a range ready. Ranges must be loaded in ascending order, each once.
  void load(NodeRange range);
  /// Precondition: the node lies in the range loaded last.
  std::span<const FaceRecord<Key>> of_node(std::uint32_t node) const {
    return {records_.get() + (begin_[node] - offset_), records_.get() + (begin_[node + 1] - offset_)};
  }

 private:
  /// Calls `work(chunk, elements)` for pieces of the mesh, on several threads.
  template <class Work>
  void for_each_chunk(Work&& work) const;

  const Mesh& mesh_;
  std::span<const std::uint8_t> present_;
  std::vector<std::uint32_t> begin_;  ///< [n_nodes + 1] first record of each node
  std::vector<std::vector<std::uint32_t>>
      cursor_;                                  ///< [n_chunks][n_nodes] where the chunk's next record goes
  std::unique_ptr<FaceRecord<Key>[]> records_;  ///< from offset_ on; not initialised before they are filled
  std::uint32_t capacity_ = 0, offset_ = 0;
};

/// More histograms than this cost more memory than they save time.
constexpr int max_counting_threads = 8;

template <class Key>
template <class Work>
void FaceBuckets<Key>::for_each_chunk(Work&& work) const {
  const int n_chunks = static_cast<int>(cursor_.size());
  const auto begin = [&](int chunk) {
    return static_cast<std::uint32_t>(static_cast<std::uint64_t>(mesh_.n_elements()) * chunk / n_chunks);
  };
#pragma omp parallel for schedule(static, 1) num_threads(n_chunks)
  for (int chunk = 0; chunk < n_chunks; ++chunk) {
    work(static_cast<std::size_t>(chunk), ElementRange{begin(chunk), begin(chunk + 1)});
  }
}

template <class Key>
FaceBuckets<Key>::FaceBuckets(const Mesh& mesh, std::span<const std::uint8_t> present)
    : mesh_(mesh),
      present_(present),
      begin_(mesh.n_nodes() + 1),
      cursor_(static_cast<std::size_t>(std::min(threads_for(mesh.n_elements()), max_counting_threads))) {
  for_each_chunk([&](std::size_t chunk, ElementRange elements) {
    std::vector<std::uint32_t> count(mesh_.n_nodes(), 0);
    visit_faces(mesh_, present_, elements,
                [&](ElementSide, const Corners& corners) { ++count[smallest(corners)]; });
    cursor_[chunk] = std::move(count);
  });
  std::uint32_t total = 0;
  for (std::uint32_t node = 0; node < mesh.n_nodes(); ++node) {
    begin_[node] = total;
    for (auto& cursor : cursor_) {
      const std::uint32_t n_faces = cursor[node];
      cursor[node] = total;
      total += n_faces;
    }
  }
  begin_[mesh.n_nodes()] = total;
}

template <class Key>
std::vector<NodeRange> FaceBuckets<Key>::ranges() const {
  const auto n_nodes = static_cast<std::uint32_t>(begin_.size() - 1);
  if constexpr (std::is_same_v<Key, ShortKey>) return {{0, n_nodes}};
  const std::uint32_t half = begin_.back() / 2;
  const auto middle = std::upper_bound(begin_.begin(), begin_.end(), half) - begin_.begin() - 1;
  const auto split = static_cast<std::uint32_t>(middle);
  return {{0, split}, {split, n_nodes}};
}

template <class Key>
void FaceBuckets<Key>::load(NodeRange range) {
  offset_ = begin_[range.begin];
  const std::uint32_t n = begin_[range.end] - offset_;
  if (n > capacity_) {
    records_.reset();
    records_ = std::make_unique_for_overwrite<FaceRecord<Key>[]>(n);
    capacity_ = n;
  }
  for_each_chunk([&](std::size_t chunk, ElementRange elements) {
    auto& next = cursor_[chunk];
    visit_faces(mesh_, present_, elements, [&](ElementSide side, const Corners& corners) {
      const std::uint32_t node = smallest(corners);
      if (node - range.begin >= range.end - range.begin) return;
      records_[next[node]++ - offset_] = {make_key<Key>(corners), side};
    });
  });
}

/// Which faces are alone, and which faces of solids are shared with other blocks only.
struct SkinPart {
  std::vector<ElementSide> exterior;
  std::vector<std::uint32_t> in_between;  ///< [n_blocks]
};

/// Takes bucket after bucket and tells the exterior faces from the shared ones. One per thread.
template <class Key>
class FaceMatcher {
  using Record = FaceRecord<Key>;

 public:
  explicit FaceMatcher(const Mesh& mesh) : mesh_(mesh) {}

  void match(std::span<const Record> bucket, SkinPart& part) {
    constexpr std::size_t small = 32;
    if (bucket.size() <= small) return match_pairwise(bucket, part);
    sorted_.assign(bucket.begin(), bucket.end());
    std::sort(sorted_.begin(), sorted_.end(), [](const Record& a, const Record& b) {
      return std::tie(a.others, a.side) < std::tie(b.others, b.side);
    });
    for (auto first = sorted_.begin(); first != sorted_.end();) {
      const auto last =
          std::find_if_not(first, sorted_.end(), [&](const Record& r) { return r.others == first->others; });
      const auto n = static_cast<std::size_t>(last - first);
      if (n == 1) add_single(first->side, part);
      if (n > 1) add_shared({first, last}, part);
      first = last;
    }
  }

 private:
  /// For the usual few faces of a node comparing all pairs is fastest.
  void match_pairwise(std::span<const Record> bucket, SkinPart& part) {
    std::uint32_t done = 0;  // bit i: face i was found in a group
    for (std::size_t i = 0; i < bucket.size(); ++i) {
      if (done >> i & 1u) continue;
      std::uint32_t same = 0;
      for (std::size_t j = i + 1; j < bucket.size(); ++j) {
        same |= static_cast<std::uint32_t>(bucket[i].others == bucket[j].others) << j;
      }
      if (same == 0) {
        add_single(bucket[i].side, part);
      } else if (mesh_.blocks().size() > 1) {
        group_.assign(1, bucket[i]);
        for (std::size_t j = i + 1; j < bucket.size(); ++j) {
          if (same >> j & 1u) group_.push_back(bucket[j]);
        }
        add_shared(group_, part);
      }
      done |= same;
    }
  }

  void add_single(ElementSide side, SkinPart& part) {
    const Shape shape = mesh_.blocks()[block_of(side.element())].shape;
    if (topology(shape).family == Family::solid) part.exterior.push_back(side);
  }

  void add_shared(std::span<const Record> group, SkinPart& part) {
    for (const Record& record : group) {
      const std::uint32_t block = block_of(record.side.element());
      const auto of_same_block = std::count_if(group.begin(), group.end(), [&](const Record& other) {
        return block_of(other.side.element()) == block;
      });
      const bool is_solid = topology(mesh_.blocks()[block].shape).family == Family::solid;
      if (is_solid && of_same_block == 1) ++part.in_between[block];
    }
  }

  /// Nearly always the block asked for last.
  std::uint32_t block_of(ElementIndex element) {
    const ElementBlock& last = mesh_.blocks()[last_block_];
    if (element.value - last.first_element.value >= last.n_elements) last_block_ = mesh_.block_of(element);
    return last_block_;
  }

  const Mesh& mesh_;
  std::vector<Record> sorted_, group_;
  std::uint32_t last_block_ = 0;
};

/// Pieces of node numbers that threads take in turn; their number does not show in the result.
constexpr std::uint32_t n_pieces = 64;

template <class Key>
std::vector<SkinPart> match_all(const Mesh& mesh, const FaceBuckets<Key>& buckets, NodeRange nodes) {
  std::vector<SkinPart> parts(n_pieces);
  const auto begin = [&](std::uint32_t piece) {
    const auto n_nodes = static_cast<std::uint64_t>(nodes.end - nodes.begin);
    return nodes.begin + static_cast<std::uint32_t>(n_nodes * piece / n_pieces);
  };
#pragma omp parallel num_threads(threads_for(mesh.n_elements()))
  {
    FaceMatcher<Key> matcher(mesh);
#pragma omp for schedule(dynamic)
    for (std::uint32_t piece = 0; piece < n_pieces; ++piece) {
      parts[piece].in_between.assign(mesh.blocks().size(), 0);
      for (std::uint32_t node = begin(piece); node < begin(piece + 1); ++node) {
        matcher.match(buckets.of_node(node), parts[piece]);
      }
    }
  }
  return parts;
}

template <class Key>
Skin make_skin_with(const Mesh& mesh, std::span<const std::uint8_t> present) {
  Skin skin;
  skin.in_between.assign(mesh.blocks().size(), 0);
  FaceBuckets<Key> buckets(mesh, present);
  for (const NodeRange range : buckets.ranges()) {
    buckets.load(range);
    for (const SkinPart& part : match_all(mesh, buckets, range)) {
      skin.exterior.insert(skin.exterior.end(), part.exterior.begin(), part.exterior.end());
      std::transform(part.in_between.begin(), part.in_between.end(), skin.in_between.begin(),
                     skin.in_between.begin(), std::plus<>());
    }
  }
  std::sort(skin.exterior.begin(), skin.exterior.end());
  return skin;
}

}  // namespace

std::span<const ElementSide> Skin::of_block(const ElementBlock& block) const {
  const std::uint32_t end = block.first_element.value + block.n_elements;
  const auto first = std::lower_bound(exterior.begin(), exterior.end(), ElementSide(block.first_element, 1));
  const auto last = std::lower_bound(first, exterior.end(), ElementSide({end}, 1));
  return {first, last};
}

Skin make_skin(const Mesh& mesh, std::span<const std::uint8_t> present) {
  return mesh.n_nodes() < ShortKey::max_nodes ? make_skin_with<ShortKey>(mesh, present)
                                              : make_skin_with<LongKey>(mesh, present);
}

}  // namespace contactsim
