// SPDX-License-Identifier: BSD-3-Clause
// What contact of nodes with faces remembers from step to step.
#include <algorithm>

#include "contact/contact_place.hpp"
#include "contact/node_face_contacts.hpp"
#include "core/state_archive.hpp"

namespace contactsim {

Eigen::Vector3d NodeFaceContacts::Memory::elastic(const Eigen::Vector3d& normal) const {
  Eigen::Vector3d elastic = Eigen::Vector3d::Zero();
  for (const Touch& touch : touches) {
    if (touch.normal.cast<double>().dot(normal) > same_wall) elastic = touch.elastic;
  }
  return elastic;
}

double NodeFaceContacts::Memory::depth(const Eigen::Vector3d& normal) const {
  float depth = 0.0f;
  for (const Touch& touch : touches) {
    if (touch.normal.cast<double>().dot(normal) > same_side) depth = std::max(depth, touch.depth);
  }
  return depth;
}

double NodeFaceContacts::Memory::depth() const {
  float depth = 0.0f;
  for (const Touch& touch : touches) depth = std::max(depth, touch.depth);
  return depth;
}

void NodeFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/node_pairs", candidates_, saved);
  std::vector<Touch> all;
  for (const std::vector<Touch>& chunk : touches_) all.insert(all.end(), chunk.begin(), chunk.end());
  saved.rows("contact/node_pairs/touches", all, [](Touch& touch, RowNumbers& row) {
    row(touch.row, touch.is_balanced, touch.normal, touch.elastic, touch.depth, touch.is_deep, touch.pair);
  });
  if (!saved.restores()) return;
  for (std::vector<Touch>& chunk : touches_) chunk.clear();
  for (const Touch& touch : all) touches_[touch.row / rows_per_chunk].push_back(touch);
}

void NodeFaceContacts::renumber(const ContactRenumbering& places) {
  std::vector<std::size_t> before;
  candidates_ = carried(candidates_, places.rows, places.faces, places.n_rows_after, before);
  std::vector<std::vector<Touch>> touches(places.n_rows_after / rows_per_chunk + 1);
  for (const std::vector<Touch>& chunk : touches_) {
    for (Touch touch : chunk) {
      touch.row = places.rows[touch.row];
      touch.is_deep = 0;  // what deaths end is not lost
      if (touch.row != ContactRenumbering::gone) touches[touch.row / rows_per_chunk].push_back(touch);
    }
  }
  for (std::vector<Touch>& chunk : touches) std::ranges::stable_sort(chunk, {}, &Touch::row);
  touches_ = std::move(touches);
  lost_.assign(touches_.size(), {});
}

void NodeFaceContacts::begin_step() {
  for (std::vector<LostContact>& chunk : lost_) chunk.clear();
}

void NodeFaceContacts::find_lost(std::vector<LostContact>& lost) const {
  for (const std::vector<LostContact>& chunk : lost_) lost.insert(lost.end(), chunk.begin(), chunk.end());
}

std::vector<float> NodeFaceContacts::depths() const {
  std::vector<float> depths(faces_.surface_nodes.size(), 0.0f);
  for (const std::vector<Touch>& chunk : touches_) {
    for (const Touch& touch : chunk) depths[touch.row] = std::max(depths[touch.row], touch.depth);
  }
  return depths;
}

}  // namespace contactsim
