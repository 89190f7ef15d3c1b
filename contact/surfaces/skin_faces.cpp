// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/skin_faces.hpp"

#include <algorithm>

#include "contact/surfaces/sort_once.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim {

namespace {

bool is_lofted(const ElementBlock& block) {
  const Family family = topology(block.shape).family;
  return family == Family::shell || family == Family::line || family == Family::particle;
}

/// Faces of all side sets that the requests use, ascending, each once.
std::vector<ElementSide> side_set_faces(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                                        const ContactDomain& domain) {
  std::vector<std::uint8_t> is_used(mesh.side_sets().size(), 0);
  for (const SurfaceRequest& request : requests) {
    if (request.kind == SurfaceKind::node) continue;
    for (const std::uint32_t set : request.side_sets) is_used[set] = 1;
  }
  std::vector<ElementSide> faces;
  for (std::size_t set = 0; set < is_used.size(); ++set) {
    if (!is_used[set]) continue;
    const auto& sides = mesh.side_sets()[set].sides;
    std::copy_if(sides.begin(), sides.end(), std::back_inserter(faces),
                 [&](ElementSide side) { return domain.is_alive(side.element()); });
  }
  sort_once(faces);
  return faces;
}

/// Joins skin and side-set faces that lie in the domain.
void join_faces(std::span<const ElementSide> exterior, std::span<const ElementSide> side_set_faces,
                const ContactDomain& domain, SkinFaces& skin_faces) {
  std::vector<ElementSide> all;
  all.reserve(exterior.size() + side_set_faces.size());
  std::set_union(exterior.begin(), exterior.end(), side_set_faces.begin(), side_set_faces.end(),
                 std::back_inserter(all));
  auto skin = exterior.begin();
  for (const ElementSide face : all) {
    const bool is_exterior = skin != exterior.end() && *skin == face;
    if (is_exterior) ++skin;
    if (!domain.holds(face)) continue;
    skin_faces.faces.push_back(face);
    skin_faces.is_exterior.push_back(is_exterior);
  }
}

template <class T>
std::optional<std::uint32_t> find_sorted(const std::vector<T>& list, const T& value) {
  const auto place = std::lower_bound(list.begin(), list.end(), value);
  if (place == list.end() || *place != value) return std::nullopt;
  return static_cast<std::uint32_t>(place - list.begin());
}

template <class T>
std::pair<std::uint32_t, std::uint32_t> find_range(const std::vector<T>& list, const T& begin, const T& end) {
  const auto first = std::lower_bound(list.begin(), list.end(), begin);
  const auto last = std::lower_bound(first, list.end(), end);
  return {static_cast<std::uint32_t>(first - list.begin()), static_cast<std::uint32_t>(last - list.begin())};
}

ElementIndex end_of(const ElementBlock& block) { return {block.first_element.value + block.n_elements}; }

}  // namespace

std::optional<std::uint32_t> SkinFaces::find_face(ElementSide face) const { return find_sorted(faces, face); }

std::optional<std::uint32_t> SkinFaces::find_lofted(ElementIndex element) const {
  return find_sorted(lofted, element);
}

std::pair<std::uint32_t, std::uint32_t> SkinFaces::faces_of(const ElementBlock& block) const {
  return find_range(faces, ElementSide(block.first_element, 1), ElementSide(end_of(block), 1));
}

std::pair<std::uint32_t, std::uint32_t> SkinFaces::lofted_of(const ElementBlock& block) const {
  return find_range(lofted, block.first_element, end_of(block));
}

bool ContactDomain::holds(NodeIndex node) const {
  if (!subdomain_) return true;
  const double distance_squared = (mesh_.coordinates().col(node.value) - subdomain_->point).squaredNorm();
  return distance_squared <= subdomain_->radius * subdomain_->radius;
}

bool ContactDomain::holds(std::span<const NodeIndex> nodes) const {
  return std::all_of(nodes.begin(), nodes.end(), [&](NodeIndex node) { return holds(node); });
}

bool ContactDomain::holds(ElementSide side) const {
  if (!subdomain_) return true;
  const auto nodes = mesh_.side_nodes(side);
  return holds(std::span<const NodeIndex>(nodes));
}

std::vector<std::uint8_t> find_present(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                                       const ContactDomain& domain) {
  std::vector<std::uint8_t> present(mesh.n_elements(), 0);
  for (const SurfaceRequest& request : requests) {
    if (request.kind == SurfaceKind::node) continue;
    for (const std::uint32_t index : request.blocks) {
      const ElementBlock& block = mesh.blocks()[index];
      std::fill_n(present.begin() + block.first_element.value, block.n_elements, std::uint8_t{1});
    }
    for (const ElementIndex element : request.elements) present[element.value] = 1;
  }
  for (std::uint32_t i = 0; i < mesh.n_elements(); ++i) {
    if (!domain.is_alive({i})) present[i] = 0;
  }
  return present;
}

SkinFaces make_skin_faces(std::span<const SurfaceRequest> requests, const Mesh& mesh,
                          const ContactDomain& domain) {
  const std::vector<std::uint8_t> present = find_present(requests, mesh, domain);
  SkinFaces skin_faces;
  {
    Skin skin = make_skin(mesh, present);
    join_faces(skin.exterior, side_set_faces(requests, mesh, domain), domain, skin_faces);
    skin_faces.in_between = std::move(skin.in_between);
  }
  for (const ElementBlock& block : mesh.blocks()) {
    if (!is_lofted(block)) continue;
    for (std::uint32_t i = 0; i < block.n_elements; ++i) {
      const ElementIndex element{block.first_element.value + i};
      if (present[element.value] && domain.holds(block.element_nodes(i)))
        skin_faces.lofted.push_back(element);
    }
  }
  return skin_faces;
}

}  // namespace contactsim
