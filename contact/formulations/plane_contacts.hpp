// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "contact/formulations/contact_step_context.hpp"
#include "contact/mesh/contact_remap.hpp"
#include "core/definition/contact_surfaces.hpp"

namespace contactsim {

/// The nodes that meet analytic planes. A plane is rigid, does not move and has no end: whatever is behind it
/// is pushed out along its normal. Source: Sierra/SM 5.22, analytic objects.
class PlaneContacts {
 public:
  /// The faces must outlive this.
  ///   surfaces  those of the faces; their analytic_planes are positions in `planes`
  ///   planes    of the region
  PlaneContacts(const ContactMesh& contact_mesh, const ContactSurfaces& surfaces,
                std::span<const AnalyticPlane> planes, const PairRules& rules)
      : contact_mesh_(contact_mesh) {
    add_pairs(surfaces, planes, rules);
  }

  std::size_t n_rows() const { return node_plane_pairs_.size(); }

  /// Goes over to other nodes, which stand where those of the constructor stood already. Arguments as there.
  void remap(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes, const PairRules& rules,
             const ContactRemap& remap);

  /// Appends the contact points of rows [begin, end). Rows may be shared among threads.
  void find(const ContactStepContext& context, std::size_t begin, std::size_t end,
            std::vector<ContactPoint>& points);

  void archive(StateArchive& saved);

 private:
  /// A node and a plane.
  struct NodePlanePair {
    std::uint32_t node;  ///< surface node
    std::uint32_t pair;
    std::uint32_t plane;  ///< of the region
    Eigen::Vector3d normal, origin;
    Eigen::Vector3d elastic_slip;  ///< slip that the tangential spring holds [length]
  };
  void add_pairs(const ContactSurfaces& surfaces, std::span<const AnalyticPlane> planes,
                 const PairRules& rules);
  void add_pairs(std::uint32_t surface, std::uint32_t pair, std::uint32_t index, const AnalyticPlane& plane);

  const ContactMesh& contact_mesh_;
  std::vector<NodePlanePair> node_plane_pairs_;
};

}  // namespace contactsim
