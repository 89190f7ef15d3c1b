// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <span>

#include "core/definition/contact_surfaces.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Which nodes take part in contact at all: those within the sphere of RESTRICT CONTACT TO SUBDOMAIN or on
/// it. Source: Sierra/SM 5.22, 8.4.4.
class ContactDomain {
 public:
  /// Both must outlive this. An absent subdomain means everywhere.
  ContactDomain(const Mesh& mesh, const std::optional<ContactSubdomain>& subdomain)
      : mesh_(mesh), subdomain_(subdomain) {}

  bool holds(NodeIndex node) const {
    if (!subdomain_) return true;
    const double distance_squared = (mesh_.coordinates().col(node.value) - subdomain_->point).squaredNorm();
    return distance_squared <= subdomain_->radius * subdomain_->radius;
  }
  /// Whether it holds all of them.
  bool holds(std::span<const NodeIndex> nodes) const {
    return !subdomain_ || std::ranges::all_of(nodes, [&](NodeIndex node) { return holds(node); });
  }
  bool holds(ElementSide side) const {
    if (!subdomain_) return true;
    const auto nodes = mesh_.side_nodes(side);
    return holds(std::span<const NodeIndex>(nodes));
  }

 private:
  const Mesh& mesh_;
  const std::optional<ContactSubdomain>& subdomain_;
};

}  // namespace contactsim
