// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/contact_renumbering.hpp"
#include "contact/contact_scene.hpp"
#include "core/definition/contact_surfaces.hpp"

namespace contactsim {

/// The nodes that meet analytic planes. A plane is rigid, does not move and has no end: whatever is behind it
/// is pushed out along its normal. Source: Sierra/SM 5.22, analytic objects.
class PlaneContacts {
 public:
  /// The faces must outlive this.
  ///   surfaces  those of the faces; their analytic_planes are positions in `planes`
  ///   planes    of the region
  PlaneContacts(const ContactFaces& faces, const ContactSurfaces& surfaces,
                std::span<const AnalyticPlane> planes, const PairRules& rules)
      : faces_(faces) {
    add_places(surfaces, planes, rules);
  }

  std::size_t n_rows() const { return places_.size(); }

  /// Goes over to other nodes, which stand where those of the constructor stood already. Arguments as there.
  void renumber(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                const PairRules& rules, const ContactRenumbering& places);

  /// Appends the places of contact of rows [begin, end). Rows may be shared among threads.
  void find(const ContactScene& scene, std::size_t begin, std::size_t end,
            std::vector<ContactRecord>& records);

  void archive(StateArchive& saved);

 private:
  /// A node and a plane.
  struct Place {
    std::uint32_t node;  ///< surface node
    std::uint32_t pair;
    std::uint32_t plane;  ///< of the region
    Eigen::Vector3d normal, origin;
    Eigen::Vector3d elastic;  ///< slip that the tangential spring holds [length]
  };
  void add_places(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                  const PairRules& rules);
  void add_places(std::uint32_t surface, std::uint32_t pair, std::uint32_t index, const AnalyticPlane& plane);

  const ContactFaces& faces_;
  std::vector<Place> places_;
};

}  // namespace contactsim
