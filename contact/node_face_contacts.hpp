// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "contact/contact_place.hpp"
#include "contact/contact_renumbering.hpp"
#include "contact/contact_scene.hpp"
#include "contact/pair_lists.hpp"

namespace contactsim {

/// The nodes that meet faces as nodes, and what contact remembers of each. A node touches one face, or shares
/// itself among those of the edge or the corner right behind which it stands; only where faces form a hollow
/// does it touch more, three at most. It comes out on the side on which it went in, however deep it gets.
class NodeFaceContacts {
 public:
  /// The faces must outlive this.
  explicit NodeFaceContacts(const ContactFaces& faces)
      : faces_(faces), touches_(faces.surface_nodes.size() / rows_per_chunk + 1), lost_(touches_.size()) {}

  /// Candidates: rows of surface nodes with faces.
  PairLists& candidates() { return candidates_; }
  const PairLists& candidates() const { return candidates_; }
  std::size_t n_rows() const { return candidates_.n_rows(); }

  /// Goes over to other faces and nodes, which stand where those of the constructor stood already.
  void renumber(const ContactRenumbering& places);

  /// Begins a step: what was lost in the last one is told.
  void begin_step();
  /// Appends the places of contact of rows [begin, end). Rows may be shared among threads; which are taken
  /// together has to be the same in every step.
  ///   begin  a multiple of rows_per_chunk
  void find(const ContactScene& scene, std::size_t begin, std::size_t end,
            std::vector<ContactRecord>& records);

  /// How deep each node was in the last step [n_surface_nodes], 0 where it did not touch.
  std::vector<float> depths() const;
  /// Appends the contacts that ended in the last step though they were deep.
  void find_lost(std::vector<LostContact>& lost) const;

  void archive(StateArchive& saved);

 private:
  static constexpr std::size_t most_walls = 3;
  static constexpr double same_side = 0.5;  // cosine of normals that look the same way
  // Normals closer than this are of one surface that bends, not of the walls of a hollow.
  static constexpr double same_wall = 0.7;

  /// A face that a node touched in the last step.
  struct Touch {
    std::uint32_t row = 0;
    bool is_balanced = false;
    Eigen::Vector3f normal = Eigen::Vector3f::Zero();
    Eigen::Vector3d elastic = Eigen::Vector3d::Zero();
    float depth = 0.0f;        ///< [length]
    std::uint8_t is_deep = 0;  ///< deeper than what parts in a step
    std::uint32_t pair = 0;
  };
  /// What is known of one node.
  struct Memory {
    std::span<const Touch> touches;

    /// Whether the node touched a face in the last step that looks the same way.
    bool knows(const Eigen::Vector3d& normal) const {
      return std::ranges::any_of(
          touches, [&](const Touch& touch) { return touch.normal.cast<double>().dot(normal) > same_side; });
    }
    /// How deep it was in such a face; 0 if it touched none [length].
    double depth(const Eigen::Vector3d& normal) const;
    /// The deepest that it was in any.
    double depth() const;
    /// The slip that was held against a face that looks almost the same way [length].
    Eigen::Vector3d elastic(const Eigen::Vector3d& normal) const;
  };
  struct Hit;
  struct Hits;

  struct Work;

  void find_one(const ContactScene& scene, std::uint32_t row, Work& work,
                std::vector<ContactRecord>& records) const;
  void look_at(const ContactScene& scene, std::uint32_t row, std::uint32_t face, const Memory& memory,
               Hits& hits) const;
  /// Whether one of the node's own faces is turned towards a face with this normal; of nodes without faces
  /// always.
  bool looks_at(const ContactScene& scene, const SurfaceNode& node, const Eigen::Vector3d& normal) const;
  /// Whether the node was in front of the face, or hardly behind it, or hardly deeper than behind the faces
  /// that it knows, one step ago. A node that turns up deep inside went in elsewhere; pushing it out here
  /// would make energy from nothing.
  ///   depth  of what it knows [length]
  bool comes_from_outside(const ContactScene& scene, const SurfaceNode& node, const MovingFace& face,
                          const Hit& hit, double depth) const;
  bool stands_over(const ContactScene& scene, std::uint32_t face, const Hit& hit) const;
  static std::size_t share_edge(double thickness, Hits& hits);
  void choose(const ContactScene& scene, std::uint32_t row, const Memory& memory, Hits& hits) const;
  Touch make_touch(std::uint32_t row, const Hit& hit, const ContactRecord& record) const;
  double share_of(const ContactScene& scene, std::uint32_t row, const Hit& hit) const;
  ContactRecord make_record(const ContactScene& scene, std::uint32_t row, const Hit& hit) const;
  NodePush make_push(const ContactScene& scene, std::uint32_t row, const Hit& hit,
                     const ContactRecord& record) const;

  const ContactFaces& faces_;
  PairLists candidates_;
  std::vector<std::vector<Touch>> touches_;     // of each chunk of rows, by row
  std::vector<std::vector<LostContact>> lost_;  // of each chunk of rows
};

}  // namespace contactsim
