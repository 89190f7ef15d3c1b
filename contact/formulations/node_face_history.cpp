// SPDX-License-Identifier: BSD-3-Clause
// What contact of nodes with faces remembers from step to step.
#include <algorithm>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/node_face_contacts.hpp"
#include "core/base/state_archive.hpp"

namespace contactsim {

Eigen::Vector3d NodeFaceContacts::NodeHistory::elastic_slip(const Eigen::Vector3d& normal) const {
  Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();
  for (const FaceHistory& face_history : face_histories) {
    if (face_history.normal.cast<double>().dot(normal) > same_wall) elastic_slip = face_history.elastic_slip;
  }
  return elastic_slip;
}

double NodeFaceContacts::NodeHistory::depth(const Eigen::Vector3d& normal) const {
  float depth = 0.0f;
  for (const FaceHistory& face_history : face_histories) {
    if (face_history.normal.cast<double>().dot(normal) > same_side)
      depth = std::max(depth, face_history.depth);
  }
  return depth;
}

double NodeFaceContacts::NodeHistory::depth() const {
  float depth = 0.0f;
  for (const FaceHistory& face_history : face_histories) depth = std::max(depth, face_history.depth);
  return depth;
}

void NodeFaceContacts::archive(StateArchive& saved) {
  contactsim::archive("contact/node_pairs", candidates_, saved);
  std::vector<FaceHistory> all;
  for (const std::vector<FaceHistory>& chunk : face_histories_)
    all.insert(all.end(), chunk.begin(), chunk.end());
  saved.rows("contact/node_pairs/face_histories", all, [](FaceHistory& face_history, RowNumbers& row) {
    row(face_history.row, face_history.is_balanced, face_history.normal, face_history.elastic_slip,
        face_history.depth, face_history.is_deep, face_history.pair);
  });
  if (!saved.restores()) return;
  for (std::vector<FaceHistory>& chunk : face_histories_) chunk.clear();
  for (const FaceHistory& face_history : all)
    face_histories_[face_history.row / rows_per_chunk].push_back(face_history);
}

void NodeFaceContacts::remap(const ContactRemap& remap) {
  std::vector<std::size_t> before;
  candidates_ = transferred(candidates_, remap.rows, remap.faces, remap.n_rows_after, before);
  std::vector<std::vector<FaceHistory>> face_histories(remap.n_rows_after / rows_per_chunk + 1);
  for (const std::vector<FaceHistory>& chunk : face_histories_) {
    for (FaceHistory face_history : chunk) {
      face_history.row = remap.rows[face_history.row];
      face_history.is_deep = 0;  // what deaths end is not lost
      if (face_history.row != ContactRemap::removed)
        face_histories[face_history.row / rows_per_chunk].push_back(face_history);
    }
  }
  for (std::vector<FaceHistory>& chunk : face_histories)
    std::ranges::stable_sort(chunk, {}, &FaceHistory::row);
  face_histories_ = std::move(face_histories);
  lost_.assign(face_histories_.size(), {});
}

void NodeFaceContacts::begin_step() {
  for (std::vector<LostContact>& chunk : lost_) chunk.clear();
}

void NodeFaceContacts::find_lost(std::vector<LostContact>& lost) const {
  for (const std::vector<LostContact>& chunk : lost_) lost.insert(lost.end(), chunk.begin(), chunk.end());
}

std::vector<float> NodeFaceContacts::depths() const {
  std::vector<float> depths(contact_mesh_.surface_nodes.size(), 0.0f);
  for (const std::vector<FaceHistory>& chunk : face_histories_) {
    for (const FaceHistory& face_history : chunk)
      depths[face_history.row] = std::max(depths[face_history.row], face_history.depth);
  }
  return depths;
}

}  // namespace contactsim
