// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/broad_phase.hpp"

#include <fcl/geometry/bvh/BVH_model.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <numeric>

#include "core/base/memory_error.hpp"

namespace contactsim {

namespace {

/// Boxes that stand close together, by their numbers.
using Part = std::span<std::uint32_t>;

/// Halves parts at the median of their centres, across the longest side of the box around these, until there
/// are as many as wanted.
///   depth  2^depth parts
void split(std::span<const Box> boxes, Part part, int depth, std::vector<Part>& parts) {
  if (depth == 0) {
    parts.push_back(part);
    return;
  }
  const auto twice_centre = [&](std::uint32_t i, std::size_t axis) {
    return boxes[i].lo[axis] + boxes[i].hi[axis];
  };
  std::array<double, 3> length;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto [least, most] =
        std::ranges::minmax(part, {}, [&](std::uint32_t i) { return twice_centre(i, axis); });
    length[axis] = twice_centre(most, axis) - twice_centre(least, axis);
  }
  const auto axis = static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
  const auto middle = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
  std::ranges::nth_element(part, middle, {}, [&](std::uint32_t i) { return twice_centre(i, axis); });
  split(boxes, {part.begin(), middle}, depth - 1, parts);
  split(boxes, {middle, part.end()}, depth - 1, parts);
}

/// A node of FCL's tree of a part.
struct PartNode {
  std::uint32_t n_boxes = 0;
  std::uint32_t link = 0;  ///< of one box its number, of more the first child's place in the tree
};

/// FCL's tree of a part, its root first. A triangle from corner to corner of each box and back has that box
/// around it. FCL takes two hundred bytes a box, which are free again then.
std::vector<PartNode> make_tree(std::span<const Box> boxes, std::span<const std::uint32_t> part) {
  std::vector<fcl::Vector3d> corners;
  std::vector<fcl::Triangle> triangles;
  corners.reserve(2 * part.size());
  triangles.reserve(part.size());
  for (const std::uint32_t i : part) {
    const Box& box = boxes[i];
    triangles.emplace_back(corners.size(), corners.size() + 1, corners.size());
    corners.emplace_back(box.lo[0], box.lo[1], box.lo[2]);
    corners.emplace_back(box.hi[0], box.hi[1], box.hi[2]);
  }
  fcl::BVHModel<fcl::AABB<double>> tree;
  const int n_triangles = static_cast<int>(triangles.size()), n_corners = static_cast<int>(corners.size());
  // In this order they fail by lack of memory alone, which FCL does not throw.
  if (tree.beginModel(n_triangles, n_corners) != fcl::BVH_OK ||
      tree.addSubModel(corners, triangles) != fcl::BVH_OK || tree.endModel() != fcl::BVH_OK)
    WorkInMemory::throw_bad_alloc();
  std::vector<PartNode> nodes(static_cast<std::size_t>(tree.getNumBVs()));
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const auto& node = tree.getBV(static_cast<int>(i));
    assert(node.isLeaf() ? node.num_primitives == 1 : node.leftChild() > static_cast<int>(i));
    nodes[i].n_boxes = static_cast<std::uint32_t>(node.num_primitives);
    nodes[i].link = node.isLeaf() ? part[static_cast<std::size_t>(node.primitiveId())]
                                  : static_cast<std::uint32_t>(node.leftChild());
  }
  return nodes;
}

/// Puts FCL's trees below top levels that halve the parts as split() did.
class TopLevelTree {
 public:
  TopLevelTree(std::span<const std::vector<PartNode>> trees, BoxTree& made)
      : trees_(trees), nodes_(made.nodes) {
    std::size_t n = 2 * trees.size() - 1;
    for (const std::vector<PartNode>& tree : trees) n += tree.size() - 1;
    nodes_.resize(n);
    graft(0, trees.size(), 0);
  }

 private:
  /// The nodes below each node follow each other, its children first.
  void graft(std::size_t first, std::size_t n_parts, std::size_t at) {
    if (n_parts == 1) {
      copy(trees_[first], at);
      return;
    }
    const std::size_t children = next_;
    next_ += 2;
    graft(first, n_parts / 2, children);
    graft(first + n_parts / 2, n_parts / 2, children + 1);
    nodes_[at].n_boxes = nodes_[children].n_boxes + nodes_[children + 1].n_boxes;
    nodes_[at].link = static_cast<std::uint32_t>(children);
  }

  /// Who is whose child, as FCL has it. Its root stands first, and at `at` here.
  void copy(std::span<const PartNode> from, std::size_t at) {
    const std::size_t first = next_ - 1;  // where the second node's place would be, less one
    for (std::size_t i = 0; i < from.size(); ++i) {
      BoxNode& made = nodes_[i == 0 ? at : first + i];
      made.n_boxes = from[i].n_boxes;
      made.link = from[i].n_boxes == 1 ? from[i].link : static_cast<std::uint32_t>(first + from[i].link);
    }
    next_ += from.size() - 1;
  }

  std::span<const std::vector<PartNode>> trees_;
  decltype(BoxTree::nodes)& nodes_;
  std::size_t next_ = 1;
};

}  // namespace

BoxTree make_box_tree(std::span<const Box> boxes) {
  constexpr std::size_t boxes_per_part = 4096;
  constexpr int max_halvings = 4;
  BoxTree tree;
  if (boxes.empty()) return tree;
  int depth = 0;
  while (depth < max_halvings && boxes.size() >> depth > boxes_per_part) ++depth;
  std::vector<std::uint32_t> numbers(boxes.size());
  std::iota(numbers.begin(), numbers.end(), 0u);
  std::vector<Part> parts;
  split(boxes, numbers, depth, parts);
  std::vector<std::vector<PartNode>> trees(parts.size());
  const auto n_parts = static_cast<std::int64_t>(parts.size());
#pragma omp parallel for schedule(dynamic) num_threads(threads_for(boxes.size()))
  for (std::int64_t i = 0; i < n_parts; ++i) {
    const auto k = static_cast<std::size_t>(i);
    trees[k] = make_tree(boxes, parts[k]);
  }
  TopLevelTree(trees, tree);
  divide(tree);
  refit(tree, [&](std::uint32_t i) { return boxes[i]; });
  return tree;
}

std::optional<std::uint32_t> BroadPhase::build(std::span<const Box> boxes) {
  const auto unsound = std::find_if_not(boxes.begin(), boxes.end(), is_sound);
  if (unsound != boxes.end()) return static_cast<std::uint32_t>(unsound - boxes.begin());
  tree_ = make_box_tree(boxes);
  ++counts_.builds;
  fresh_effort_.reset();
  return std::nullopt;
}

void BroadPhase::note_refit() {
  ++counts_.refits;
  if (!fresh_effort_ && effort_ > 0.0) fresh_effort_ = effort_;
}

bool BroadPhase::is_slow() const {
  // A build takes as long as some forty visits to every box; searches that visit fewer pairs than there are
  // boxes, as between bodies apart, are never worth one.
  constexpr double growth = 1.2, min_effort = 1.0;
  return fresh_effort_ && effort_ > growth * std::max(*fresh_effort_, min_effort);
}

double BroadPhase::count_search(std::span<const FoundPairs> parts, std::size_t n_kept,
                                std::uint32_t n_partners) {
  std::uint64_t visits = 0, overlaps = 0;
  for (const FoundPairs& part : parts) {
    visits += part.visits;
    overlaps += part.overlaps;
  }
  counts_.visits += visits;
  counts_.overlaps += overlaps;
  counts_.candidates += n_kept;
  const std::uint64_t n_asked = tree_.n_boxes() + n_partners + overlaps;
  const double effort = n_asked > 0 ? static_cast<double>(visits) / static_cast<double>(n_asked) : 0.0;
  note_effort(effort);
  return effort;
}

}  // namespace contactsim
