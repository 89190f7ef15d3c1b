// SPDX-License-Identifier: BSD-3-Clause
#include "contact/broad_phase.hpp"

#include <fcl/geometry/bvh/BVH_model.h>

#include <algorithm>
#include <cassert>

namespace contactsim {

namespace {

using Tree = fcl::BVHModel<fcl::AABB<double>>;

/// A triangle from corner to corner of each box and back: its bounding box is that box.
void add_boxes(std::span<const Box> boxes, Tree& tree) {
  std::vector<fcl::Vector3d> corners;
  std::vector<fcl::Triangle> triangles;
  corners.reserve(2 * boxes.size());
  triangles.reserve(boxes.size());
  for (const Box& box : boxes) {
    triangles.emplace_back(corners.size(), corners.size() + 1, corners.size());
    corners.emplace_back(box.lo[0], box.lo[1], box.lo[2]);
    corners.emplace_back(box.hi[0], box.hi[1], box.hi[2]);
  }
  tree.addSubModel(corners, triangles);
}

/// Who is whose child, as FCL has it.
void link_nodes(const Tree& from, BoxTree& to) {
  to.nodes.resize(static_cast<std::size_t>(from.getNumBVs()));
  for (std::size_t i = 0; i < to.nodes.size(); ++i) {
    const auto& node = from.getBV(static_cast<int>(i));
    to.nodes[i].n_boxes = static_cast<std::uint32_t>(node.num_primitives);
    to.nodes[i].link = static_cast<std::uint32_t>(node.isLeaf() ? node.primitiveId() : node.leftChild());
    assert(node.isLeaf() || node.leftChild() > static_cast<int>(i));
  }
}

}  // namespace

BoxTree make_box_tree(std::span<const Box> boxes) {
  BoxTree tree;
  if (boxes.empty()) return tree;
  Tree model;
  model.beginModel(static_cast<int>(boxes.size()), static_cast<int>(2 * boxes.size()));
  add_boxes(boxes, model);
  model.endModel();
  link_nodes(model, tree);
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
  // A build takes as long as some forty visits to every box; searches that look at fewer pairs than there are
  // boxes, as between bodies apart, are never worth one.
  constexpr double growth = 1.2, least_effort = 1.0;
  return fresh_effort_ && effort_ > growth * std::max(*fresh_effort_, least_effort);
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
