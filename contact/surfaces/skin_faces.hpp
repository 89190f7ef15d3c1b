// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "contact/surfaces/surface_request.hpp"
#include "core/definition/contact_surfaces.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The faces and lofted elements that some surface may come to own, each with a number. What lies outside the
/// contact subdomain or belongs to dead elements is not among them.
struct SkinFaces {
  std::vector<ElementSide> faces;  ///< ascending; skin faces and side-set faces
  std::vector<std::uint8_t>
      is_exterior;                   ///< [n_faces] whether the face is in the skin of the present elements
  std::vector<ElementIndex> lofted;  ///< ascending; present shells, lines and particles
  std::vector<std::uint32_t> in_between;  ///< [n_blocks] see Skin::in_between

  std::optional<std::uint32_t> find_face(ElementSide face) const;
  std::optional<std::uint32_t> find_lofted(ElementIndex element) const;
  /// Numbers of the faces, or lofted elements, of one block: first, one past last.
  std::pair<std::uint32_t, std::uint32_t> faces_of(const ElementBlock& block) const;
  std::pair<std::uint32_t, std::uint32_t> lofted_of(const ElementBlock& block) const;
};

/// Which nodes and elements take part in contact at all.
class ContactDomain {
 public:
  /// An absent subdomain means everywhere. `alive` has one 0 or 1 per element, or is empty when all live.
  ContactDomain(const Mesh& mesh, const std::optional<ContactSubdomain>& subdomain,
                std::span<const std::uint8_t> alive)
      : mesh_(mesh), subdomain_(subdomain), alive_(alive) {}

  bool is_alive(ElementIndex element) const { return alive_.empty() || alive_[element.value] != 0; }
  /// Within the sphere or on it.
  bool holds(NodeIndex node) const;
  /// With all its nodes.
  bool holds(std::span<const NodeIndex> nodes) const;
  bool holds(ElementSide side) const;

 private:
  const Mesh& mesh_;
  const std::optional<ContactSubdomain>& subdomain_;
  std::span<const std::uint8_t> alive_;
};

/// [n_elements] 1 of living elements of the blocks that face requests name and of those that they pick, else
/// 0.
std::vector<std::uint8_t> find_present(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                                       const ContactDomain& domain);

/// Skins the present blocks and gathers what the requests may claim. Present are the living elements of the
/// blocks that face requests name, and the elements that they pick.
SkinFaces make_skin_faces(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                          const ContactDomain& domain);

}  // namespace contactsim
