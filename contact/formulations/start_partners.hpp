// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <concepts>
#include <optional>
#include <vector>

#include "contact/geometry/face_face.hpp"
#include "contact/interface_laws/pair_rules.hpp"
#include "contact/mesh/contact_kinematics.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "contact/mesh/pair_lists.hpp"

namespace contactsim {

class StateArchive;

/// How far the corners of a face that is kept as a partner are to be carried along with what slides on it.
struct PartnerCarry {
  bool is_of_first = false;  ///< of two faces the first one is carried, else the second
  Eigen::Vector4d weights =
      Eigen::Vector4d::Zero();  ///< sum 0; the way is the sum of these times the corners [1]

  bool is_zero() const { return weights.isZero(0.0); }
  /// The face where it has been carried to, with the velocities that belong there.
  MovingFace carried(MovingFace face) const {
    face.x.colwise() += (face.x * weights).eval();
    face.v.colwise() += (face.v * weights).eval();
    return face;
  }
};

/// A face, or a surface node, whose faces of the start are dead.
template <class AnIndex>
struct ReleasedPartner {
  AnIndex entity;
  PairIndex pair;
};

/// Which faces what slides infinitesimally projects onto at the start: those it keeps, with the planes in
/// which they lie. One side of a pair slides, the other keeps still: SIDE B of NODE_FACE slides, else the
/// surface with less area, of one and the same surface the smaller face, or every node. A node meets the
/// plane of its face beyond the edges too; of two faces the still one goes along with the other in its own
/// plane, so that they lie over each other as they did. The corners of the still face bear what its plane
/// beyond them would: their weights are those of the linear extension, so that forces leave no moment.
/// Source: small sliding of Abaqus (contact planes that do not end).
///   Row  FaceIndex, or SurfaceNodeIndex
template <class Row>
class StartPartners {
 public:
  using Lists = PairLists<Row, FaceIndex>;

  /// Looks for the partners of rows, and takes them: of faces with faces of greater number, or of nodes.
  ///   candidates  of the first search
  ///   start       the contact nodes before the first step
  void begin_faces(const ContactKinematics& start, const PairRules& rules,
                   const Lists& candidates) requires std::same_as<Row, FaceIndex>;
  void begin_nodes(const ContactKinematics& start, const PairRules& rules,
                   const Lists& candidates) requires std::same_as<Row, SurfaceNodeIndex>;

  bool empty() const { return lists_.partners.empty(); }
  /// Candidates without those of sliding faces that project onto others.
  Lists restricted(const PairRules& rules, const ContactMesh& contact_mesh,
                   const Lists& candidates) const requires std::same_as<Row, FaceIndex>;
  /// Candidates with the partners, which stay candidates wherever they are while their pair keeps them.
  Lists united_with(const PairRules& rules, const Lists& candidates) const;

  /// Whether a row keeps a partner.
  bool has(Row row, FaceIndex partner) const { return find(row, partner).has_value(); }
  /// How far a face is to be carried where two are partners.
  std::optional<PartnerCarry> find_carry(const ContactKinematics& kinematics, FaceIndex first,
                                         FaceIndex second) const requires std::same_as<Row, FaceIndex>;

  /// Goes over to other faces and nodes. Returns what has lost the last of its partners and slides freely
  /// now.
  std::vector<ReleasedPartner<Row>> remap(const NewPositions<Row>& rows, const NewPositions<FaceIndex>& faces,
                                          std::size_t n_rows_after);
  void archive(const std::string& name, StateArchive& saved);

 private:
  struct Start {
    Eigen::Vector3d apart = Eigen::Vector3d::Zero();  // of the centres, in axes of the still face [length]
    bool slides_first = true;                         // the first one slides
    PairIndex pair;
  };
  std::optional<std::size_t> find(Row row, FaceIndex partner) const;
  Row sliding(std::size_t k, Row row) const {
    if constexpr (std::same_as<Row, FaceIndex>) return starts_[k].slides_first ? row : lists_.partner(k);
    return row;
  }

  Lists lists_;
  std::vector<Start> starts_;  // [n_pairs]
};

}  // namespace contactsim
