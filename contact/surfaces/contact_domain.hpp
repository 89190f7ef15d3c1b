// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <variant>

#include "core/definition/contact_surfaces.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// Which nodes take part in contact at all: those that at the start are within the sphere or box of RESTRICT
/// CONTACT or on it. Source: Sierra/SM 5.22, 8.4.4.
class ContactDomain {
 public:
  /// Both must outlive this. An absent subdomain means everywhere.
  ContactDomain(const Mesh& mesh, const std::optional<ContactSubdomain>& subdomain)
      : mesh_(mesh), subdomain_(subdomain) {}

  bool holds(NodeIndex node) const {
    if (!subdomain_) return true;
    const Eigen::Vector3d x = mesh_.coordinates().col(node.value);
    return std::visit([&](const auto& shape) { return is_in(shape, x); }, subdomain_->shape);
  }
  /// Whether it holds all of them.
  bool holds(std::span<const NodeIndex> nodes) const {
    return !subdomain_ || std::ranges::all_of(nodes, [&](NodeIndex node) { return holds(node); });
  }
  bool holds(ElementSide side) const {
    if (!subdomain_) return true;
    return std::ranges::all_of(mesh_.side_facets(side), [&](const std::array<NodeIndex, 4>& corners) {
      return holds(std::span<const NodeIndex>(corners));
    });
  }

 private:
  static bool is_in(const ContactSphere& sphere, const Eigen::Vector3d& x) {
    return (x - sphere.point).squaredNorm() <= sphere.radius * sphere.radius;
  }
  static bool is_in(const ContactBox& box, const Eigen::Vector3d& x) {
    return (x.array() >= box.lower.array()).all() && (x.array() <= box.upper.array()).all();
  }

  const Mesh& mesh_;
  const std::optional<ContactSubdomain>& subdomain_;
};

}  // namespace contactsim
