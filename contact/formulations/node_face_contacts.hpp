// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

/// The nodes that meet faces as nodes, and what contact remembers of each. A node touches one face, or
/// shares itself among those of the edge or the corner right behind which it stands; only where faces form a
/// hollow does it touch more, three at most. It comes out on the side on which it went in, however deep it
/// gets.
class NodeFaceContacts {
 public:
  /// The faces must outlive this.
  explicit NodeFaceContacts(const ContactMesh& contact_mesh)
      : contact_mesh_(contact_mesh),
        face_histories_(contact_mesh.surface_nodes.size() / rows_per_chunk + 1),
        lost_(face_histories_.size()) {}

  /// Candidates: rows of surface nodes with faces.
  PairLists& candidates() { return candidates_; }
  const PairLists& candidates() const { return candidates_; }
  std::size_t n_rows() const { return candidates_.n_rows(); }

  /// Goes over to other faces and nodes, which stand where those of the constructor stood already.
  void remap(const ContactRemap& remap);

  /// Begins a step: what was lost in the last one is told.
  void begin_step();
  /// Appends the contact points of rows [begin, end). Rows may be shared among threads; which are taken
  /// together has to be the same in every step.
  ///   begin  a multiple of rows_per_chunk
  void find(const ContactStepContext& context, std::size_t begin, std::size_t end,
            std::vector<ContactPoint>& contact_points);

  /// How deep each node was in the last step [n_surface_nodes], 0 where it did not touch.
  std::vector<float> depths() const;
  /// Appends the contacts that ended in the last step though they were deep.
  void find_lost(std::vector<LostContact>& lost) const;

  void archive(StateArchive& saved);

 private:
  static constexpr std::size_t max_walls = 3;
  static constexpr double same_side = 0.5;  // cosine of normals that look the same way
  // Normals closer than this are of one surface that bends, not of the walls of a hollow.
  static constexpr double same_wall = 0.7;

  /// A face that a node touched in the last step.
  struct FaceHistory {
    std::uint32_t row = 0;
    bool is_balanced = false;
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    Eigen::Vector3d elastic_slip = Eigen::Vector3d::Zero();
    float depth = 0.0f;        ///< [length]
    std::uint8_t is_deep = 0;  ///< deeper than what parts in a step
    std::uint32_t pair = 0;
  };
  /// What is known of one node.
  struct NodeHistory {
    std::span<const FaceHistory> face_histories;

    /// Whether the node touched a face in the last step that looks the same way.
    bool knows(const Eigen::Vector3d& normal) const {
      return std::ranges::any_of(face_histories, [&](const FaceHistory& face_history) {
        return face_history.normal.cast<double>().dot(normal) > same_side;
      });
    }
    /// How deep it was in such a face; 0 if it touched none [length].
    double depth(const Eigen::Vector3d& normal) const;
    /// The deepest that it was in any.
    double depth() const;
    /// The slip that was held against a face that looks almost the same way [length].
    Eigen::Vector3d elastic_slip(const Eigen::Vector3d& normal) const;
  };
  struct NearFace;
  struct NearFaces;

  struct Work;

  void find_one(const ContactStepContext& context, std::uint32_t row, Work& work,
                std::vector<ContactPoint>& contact_points) const;
  void add_near_face(const ContactStepContext& context, std::uint32_t row, std::uint32_t face,
                     const NodeHistory& node_history, NearFaces& near_faces) const;
  /// Whether one of the node's own faces is turned towards a face with this normal; of nodes without faces
  /// always.
  bool is_facing(const ContactStepContext& context, const SurfaceNode& node,
                 const Eigen::Vector3d& normal) const;
  /// Whether the node was in front of the face, or hardly behind it, or hardly deeper than behind the faces
  /// that it knows, one step ago. A node that turns up deep inside went in elsewhere; pushing it out here
  /// would make energy from nothing.
  ///   depth  of what it knows [length]
  bool comes_from_outside(const ContactStepContext& context, const SurfaceNode& node, const MovingFace& face,
                          const NearFace& near_face, double depth) const;
  bool projects_inside(const ContactStepContext& context, std::uint32_t face,
                       const NearFace& near_face) const;
  static std::size_t share_at_edge(double thickness, NearFaces& near_faces);
  void choose(const ContactStepContext& context, std::uint32_t row, const NodeHistory& node_history,
              NearFaces& near_faces) const;
  FaceHistory make_face_history(std::uint32_t row, const NearFace& near_face,
                                const ContactPoint& contact_point) const;
  double share_of(const ContactStepContext& context, std::uint32_t row, const NearFace& near_face) const;
  ContactPoint make_contact_point(const ContactStepContext& context, std::uint32_t row,
                                  const NearFace& near_face) const;
  NodePenaltyInput make_push(const ContactStepContext& context, std::uint32_t row, const NearFace& near_face,
                             const ContactPoint& contact_point) const;

  const ContactMesh& contact_mesh_;
  PairLists candidates_;
  std::vector<std::vector<FaceHistory>> face_histories_;  // of each chunk of rows, by row
  std::vector<std::vector<LostContact>> lost_;            // of each chunk of rows
};

}  // namespace contactsim
