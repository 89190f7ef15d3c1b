// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/body_volumes.hpp"
#include "contact/overlap/overlap_parts.hpp"

namespace contactsim {

class BroadPhase;

/// A node of a contact surface that lies inside the solids, or the lofted shells, of another body.
struct DeepOverlap {
  PairIndex pair;
  SurfaceNodeIndex row;
  FaceIndex face;                                    ///< through which its way out leads
  double depth = 0.0;                                ///< along the face's normal, > 0 [length]
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  ///< of the face: the node's way out [1]
  bool is_deep = false;  ///< by more than half the thinner element; always inside a lofted shell
};

/// Finds the nodes of contact surfaces that lie inside solids of other bodies, however deep, or deeper than
/// half the thickness inside their lofted shells: point in element. Bodies are what solids and shells join; a
/// body that lies in itself is not found.
class DeepOverlaps {
 public:
  /// All must outlive this.
  ///   alive  [n_elements] 0 of elements that hold nothing; empty: all do
  DeepOverlaps(const ContactModel& model, const Mesh& mesh, const OverlapParts& parts,
               std::span<const std::uint8_t> alive = {});

  /// [n_nodes] the first node of each node's body.
  const std::vector<std::uint32_t>& bodies() const { return volumes_.bodies(); }

  /// All nodes inside of what their surface is paired with, ascending by row. Of the faces of the body around
  /// it the way out is the nearest one, nearer the more it is turned against the node's surface; those that
  /// look the same way are none. Sheets, lines and spheres take the nearest one, spheres with their radius.
  /// Out of a lofted shell the way leads through a face that one of the node's own faces is facing: of two
  /// sheets whose mid surfaces have passed each other, the shorter way. Ties leave what lies deep in lofts
  /// where it is.
  ///   coordinates  [3 x n_nodes] of the mesh [length]
  ///   surface      the contact nodes there
  ///   shallow      nodes behind a face of the very element that they lie in by less than this share of its
  ///                thickness may be left out: what touches has many of them [1]
  std::vector<DeepOverlap> find(const Eigen::Matrix3Xd& coordinates, const ContactKinematics& kinematics,
                                double shallow = 0.0) const;

 private:
  struct Inside {
    SurfaceNodeIndex row;
    std::uint32_t body;  // in BodyVolumes::thick_bodies()
    ElementIndex element;
  };
  std::optional<std::vector<SurfaceNodeIndex>> find_rows_near_others(const ContactKinematics& kinematics,
                                                                     std::span<const Box> boxes,
                                                                     BroadPhase& around) const;
  std::vector<Inside> find_inside(const Eigen::Matrix3Xd& coordinates, const ContactKinematics& kinematics,
                                  double shallow) const;
  bool is_shallow(const ContactKinematics& kinematics, const Inside& inside, double share,
                  std::span<const FaceIndex> faces) const;
  void leave_out_shallow(const ContactKinematics& kinematics, double share,
                         std::vector<Inside>& inside) const;
  std::optional<DeepOverlap> find_way_out(const ContactKinematics& kinematics, const Inside& inside,
                                          const PairLists<std::uint32_t, FaceIndex>& faces_of_body) const;
  bool is_facing(const ContactKinematics& kinematics, const SurfaceNode& node,
                 const Eigen::Vector3d& normal) const;
  std::uint32_t body_of_row(SurfaceNodeIndex row) const {
    return bodies()[contact_mesh().mesh_nodes[contact_mesh().surface_nodes[row].node].value];
  }
  const ContactMesh& contact_mesh() const { return parts_.contact_mesh; }

  const Mesh& mesh_;
  const OverlapParts& parts_;
  BodyVolumes volumes_;
  PairRules rules_;
};

}  // namespace contactsim
