// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_face_history.hpp"

#include <iterator>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

FaceHistory make_face_history(const ContactMesh& contact_mesh, const ContactPoint& point) {
  const SurfaceNodeIndex row = point.row();
  const double thickness = std::min(contact_mesh.surface_nodes[row].penalty_properties.thickness,
                                    contact_mesh.faces[point.second_face()].penalty_properties.thickness);
  const double depth = std::max(0.0, -point.gap);
  return {row,
          point.is_balanced,
          point.normal.cast<float>(),
          point.elastic_slip,
          static_cast<float>(depth),
          depth > deep_share * thickness,
          point.pair};
}

}  // namespace

double NodeHistory::depth(const Eigen::Vector3d& normal) const {
  float depth = 0.0f;
  for (const FaceHistory& face_history : face_histories) {
    if (face_history.normal.cast<double>().dot(normal) > same_side)
      depth = std::max(depth, face_history.depth);
  }
  return depth;
}

Eigen::Vector3d NodeHistory::elastic_slip(const Eigen::Vector3d& normal) const {
  Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();
  for (const FaceHistory& face_history : face_histories) {
    if (face_history.normal.cast<double>().dot(normal) > same_wall) elastic_slip = face_history.elastic_slip;
  }
  return elastic_slip;
}

NodeHistory NodeFaceHistory::of(SurfaceNodeIndex row) const {
  const auto found = std::ranges::equal_range(chunks_[chunk_of(row)], row, {}, &FaceHistory::row);
  return {{found.begin(), found.end()}};
}

std::vector<float> NodeFaceHistory::depths(std::size_t n_surface_nodes) const {
  IndexedVector<SurfaceNodeIndex, float> depths(n_surface_nodes, 0.0f);
  for (const std::vector<FaceHistory>& chunk : chunks_) {
    for (const FaceHistory& face_history : chunk)
      depths[face_history.row] = std::max(depths[face_history.row], face_history.depth);
  }
  return depths;
}

void NodeFaceHistory::begin_step() {
  for (std::vector<LostContact>& chunk : lost_) chunk.clear();
}

void NodeFaceHistory::update(const ContactStepContext& context, std::size_t chunk,
                             std::span<const ContactPoint> points) {
  const ContactMesh& contact_mesh = context.kinematics.contact_mesh();
  std::vector<FaceHistory>& histories = chunks_[chunk];
  if (histories.empty() && points.empty()) return;
  std::vector<FaceHistory> others, found, now;
  std::ranges::copy_if(histories, std::back_inserter(others), [&](const FaceHistory& face_history) {
    return face_history.is_balanced != context.balances;
  });
  for (const ContactPoint& point : points) {
    if (point.is_met()) found.push_back(make_face_history(contact_mesh, point));
  }
  now.reserve(others.size() + found.size());
  std::ranges::merge(others, found, std::back_inserter(now), {}, &FaceHistory::row, &FaceHistory::row);
  for (const FaceHistory& face_history : histories) {
    if (face_history.is_deep != 0 &&
        !std::ranges::binary_search(now, face_history.row, {}, &FaceHistory::row))
      lost_[chunk].push_back(
          {face_history.pair, contact_mesh.surface_nodes[face_history.row].node, face_history.depth});
  }
  histories = std::move(now);
}

void NodeFaceHistory::find_lost(std::vector<LostContact>& lost) const {
  for (const std::vector<LostContact>& chunk : lost_) lost.insert(lost.end(), chunk.begin(), chunk.end());
}

void NodeFaceHistory::remap(const ContactRemap& remap) {
  std::vector<std::vector<FaceHistory>> chunks(remap.n_rows_after / rows_per_chunk + 1);
  for (const std::vector<FaceHistory>& chunk : chunks_) {
    for (FaceHistory face_history : chunk) {
      const OptionalIndex<SurfaceNodeIndex> row = remap.rows[face_history.row];
      if (!row) continue;
      face_history.row = *row;
      face_history.is_deep = 0;  // what deaths end is not lost
      chunks[chunk_of(*row)].push_back(face_history);
    }
  }
  for (std::vector<FaceHistory>& chunk : chunks) std::ranges::stable_sort(chunk, {}, &FaceHistory::row);
  chunks_ = std::move(chunks);
  lost_.assign(chunks_.size(), {});
}

void NodeFaceHistory::archive(StateArchive& saved) {
  std::vector<FaceHistory> all;
  for (const std::vector<FaceHistory>& chunk : chunks_) all.insert(all.end(), chunk.begin(), chunk.end());
  saved.rows("contact/node_pairs/face_histories", all, [](FaceHistory& face_history, RowNumbers& row) {
    row(face_history.row.value, face_history.is_balanced, face_history.normal, face_history.elastic_slip,
        face_history.depth, face_history.is_deep, face_history.pair.value);
  });
  if (!saved.restores()) return;
  for (std::vector<FaceHistory>& chunk : chunks_) chunk.clear();
  for (const FaceHistory& face_history : all) chunks_[chunk_of(face_history.row)].push_back(face_history);
}

}  // namespace contactsim
