// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/contact_remap.hpp"

namespace contactsim {

class StateArchive;

/// A face that a node touched in the last step.
struct FaceHistory {
  SurfaceNodeIndex row;
  bool is_balanced = false;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();  ///< [length]
  float depth = 0.0f;                                      ///< [length]
  std::uint8_t is_deep = 0;                                ///< deeper than what parts in a step
  PairIndex pair;
};

/// What is known of one node: the faces that it touched. A face that looks the same way as one of them counts
/// as the same.
struct NodeHistory {
  static constexpr double same_side = 0.5;  ///< cosine of normals that look the same way
  /// Normals closer than this are of one surface that bends, not of the walls of a hollow.
  static constexpr double same_wall = 0.7;

  std::span<const FaceHistory> face_histories;

  /// Whether the node touched a face in the last step that looks the same way.
  bool knows(const Eigen::Vector3d& normal) const {
    return std::ranges::any_of(face_histories, [&](const FaceHistory& face_history) {
      return face_history.normal.cast<double>().dot(normal) > same_side;
    });
  }
  /// Whether it touched such a face under a pair.
  bool touched(PairIndex pair, const Eigen::Vector3d& normal) const {
    return std::ranges::any_of(face_histories, [&](const FaceHistory& face_history) {
      return face_history.pair == pair && face_history.normal.cast<double>().dot(normal) > same_side;
    });
  }
  /// How deep it was in such a face; 0 if it touched none [length].
  double depth(const Eigen::Vector3d& normal) const;
  /// The slip that was held against a face that looks almost the same way [length].
  Eigen::Vector3d elastic_slip(const Eigen::Vector3d& normal) const;
};

/// What contact of nodes with faces remembers from step to step.
class NodeFaceHistory {
 public:
  explicit NodeFaceHistory(std::size_t n_surface_nodes)
      : chunks_(n_surface_nodes / rows_per_chunk + 1), lost_(chunks_.size()) {}

  NodeHistory of(SurfaceNodeIndex row) const;
  /// [n_surface_nodes] How deep each was in the last step, 0 where it did not touch [length].
  std::vector<float> depths(std::size_t n_surface_nodes) const;

  /// Begins a step: what was lost in the last one is known.
  void begin_step();
  /// Takes the contact points of one chunk of rows over, in the order of rows. What the other kind of
  /// enforcement remembers of a node stays.
  void update(const ContactStepContext& context, std::size_t chunk, std::span<const ContactPoint> points);
  /// Appends the contacts that ended though they were deep.
  void find_lost(std::vector<LostContact>& lost) const;
  void remap(const ContactRemap& remap);
  void archive(StateArchive& saved);

 private:
  static std::size_t chunk_of(SurfaceNodeIndex row) { return row.value / rows_per_chunk; }

  std::vector<std::vector<FaceHistory>> chunks_;  // of each chunk of rows, by row
  std::vector<std::vector<LostContact>> lost_;    // of each chunk of rows
};

}  // namespace contactsim
