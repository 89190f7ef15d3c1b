// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "contact/contact_scene.hpp"
#include "contact/pair_lists.hpp"

namespace contactsim {

/// The nodes that meet faces as nodes, and what contact remembers of each. A node touches one face, however
/// many share the edge or the corner that it stands over; only where faces form a hollow does it touch more,
/// three at most. It comes out on the side on which it went in.
class NodeFaceContacts {
 public:
  /// The faces must outlive this.
  explicit NodeFaceContacts(const ContactFaces& faces) : faces_(faces), memory_(faces.surface_nodes.size()) {}

  /// Candidates: rows of surface nodes with faces.
  PairLists& candidates() { return candidates_; }
  const PairLists& candidates() const { return candidates_; }
  std::size_t n_rows() const { return candidates_.n_rows(); }

  /// Appends the places of contact of rows [begin, end). Rows may be shared among threads.
  void find(const ContactScene& scene, std::size_t begin, std::size_t end,
            std::vector<ContactRecord>& records);

 private:
  static constexpr std::size_t most_touched = 3;

  /// A face that a node touched in the last step.
  struct Touch {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    Eigen::Vector3d elastic = Eigen::Vector3d::Zero();
  };
  struct Memory {
    std::array<Touch, most_touched> touches;
    std::uint8_t n_touches = 0;

    /// Whether the node touched a face in the last step that looks the same way.
    bool knows(const Eigen::Vector3d& normal) const {
      for (std::size_t i = 0; i < n_touches; ++i) {
        if (touches[i].normal.dot(normal) > 0.5) return true;
      }
      return false;
    }
  };
  struct Hit;
  struct Hits;

  /// hits  scratch
  void find_one(const ContactScene& scene, std::uint32_t row, Hits& hits,
                std::vector<ContactRecord>& records);
  void look_at(const ContactScene& scene, std::uint32_t row, std::uint32_t face, Hits& hits) const;
  /// Whether one of the node's own faces is turned towards a face with this normal; of nodes without faces
  /// always.
  bool looks_at(const ContactScene& scene, const SurfaceNode& node, const Eigen::Vector3d& normal) const;
  /// Whether the node was in front of the face, or hardly behind it, one step ago. A node that turns up deep
  /// inside went in elsewhere; pushing it out here would make energy from nothing.
  bool comes_from_outside(const ContactScene& scene, const SurfaceNode& node, const MovingFace& face,
                          const Hit& hit) const;
  bool stands_over(const ContactScene& scene, std::uint32_t face, const Hit& hit) const;
  void choose(const ContactScene& scene, const Memory& memory, Hits& hits) const;
  ContactRecord make_record(const ContactScene& scene, std::uint32_t row, const Hit& hit) const;

  const ContactFaces& faces_;
  PairLists candidates_;
  std::vector<Memory> memory_;  // [n_surface_nodes]
};

}  // namespace contactsim
