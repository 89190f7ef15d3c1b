// SPDX-License-Identifier: BSD-3-Clause
#include "contact/overlap/body_volumes.hpp"

#include <algorithm>
#include <map>

#include "contact/mesh/bodies.hpp"
#include "contact/overlap/overlap_parts.hpp"
#include "contact/overlap/point_box.hpp"

namespace contactsim {

BodyVolumes::BodyVolumes(const Mesh& mesh, const ContactMesh& contact_mesh,
                         std::span<const std::uint8_t> alive)
    : mesh_(mesh), contact_mesh_(contact_mesh), alive_(alive), bodies_(find_bodies(mesh)) {
  find_thick_bodies();
  find_lofts();
}

void BodyVolumes::find_thick_bodies() {
  for (const ContactFace& face : contact_mesh_.faces) {
    if (!contact_mesh_.is_lofted(face) && !is_solid(mesh_, face.side)) continue;
    const std::uint32_t body = bodies_[contact_mesh_.mesh_nodes[face.corners[0]].value];
    if (thick_bodies_.empty() || thick_bodies_.back() != body) thick_bodies_.push_back(body);
  }
  std::ranges::sort(thick_bodies_);
  thick_bodies_.erase(std::ranges::unique(thick_bodies_).begin(), thick_bodies_.end());
}

OptionalIndex<std::uint32_t> BodyVolumes::find_number(std::uint32_t body) const {
  const auto found = std::ranges::lower_bound(thick_bodies_, body);
  if (found == thick_bodies_.end() || *found != body) return {};
  return static_cast<std::uint32_t>(found - thick_bodies_.begin());
}

/// Finds numbers of bodies, in no time where the same one is asked for again: nodes and elements of a body
/// follow each other.
class BodyVolumes::NumberOfLast {
 public:
  explicit NumberOfLast(const BodyVolumes& volumes) : volumes_(volumes) {}

  OptionalIndex<std::uint32_t> find(std::uint32_t body) {
    if (body_ != body) {
      body_ = body;
      number_ = volumes_.find_number(body);
    }
    return number_;
  }

 private:
  const BodyVolumes& volumes_;
  OptionalIndex<std::uint32_t> body_, number_;
};

std::vector<Box> BodyVolumes::boxes(const Eigen::Matrix3Xd& coordinates,
                                    const ContactKinematics& kinematics) const {
  std::vector<Box> boxes(thick_bodies_.size(), empty_box());
  NumberOfLast last(*this);
  const auto extend = [&](NodeIndex mesh_node, const Eigen::Vector3d& x) {
    if (const auto number = last.find(bodies_[mesh_node.value])) add_point(x, boxes[*number]);
  };
  for (std::uint32_t i = 0; i < mesh_.n_nodes(); ++i) extend({i}, coordinates.col(i));
  for (const Loft& loft : lofts_) {
    for (const ContactNodeIndex point : loft.corners)
      extend(contact_mesh_.mesh_nodes[point], kinematics.x(point));
  }
  return boxes;
}

/// Pairs the tops and bottoms of lofted shells. One of which a surface has one side only is no volume.
void BodyVolumes::find_lofts() {
  std::map<std::uint32_t, const ContactFace*> tops;
  for (const ContactFace& face : contact_mesh_.faces) {
    if (contact_mesh_.is_lofted(face) && face.side.side() == 1) tops[face.side.element().value] = &face;
  }
  for (const ContactFace& face : contact_mesh_.faces) {
    if (!contact_mesh_.is_lofted(face) || face.side.side() != 2) continue;
    const auto top = tops.find(face.side.element().value);
    if (top == tops.end()) continue;
    std::array<ContactNodeIndex, 8> corners{};
    for (std::size_t k = 0; k < 4; ++k) {
      corners[k] = top->second->corners[k];
      corners[k + 4] =
          *std::ranges::find(face.corners, contact_mesh_.mesh_nodes[corners[k]],
                             [&](ContactNodeIndex point) { return contact_mesh_.mesh_nodes[point]; });
    }
    lofts_.push_back({corners, face.side.element()});
    tops.erase(top);
  }
}

std::vector<BodyVolume> BodyVolumes::near(const Eigen::Matrix3Xd& coordinates,
                                          const ContactKinematics& kinematics,
                                          std::span<const Box> boxes) const {
  std::vector<BodyVolume> near;
  BodyVolume volume;
  // Most bodies of a mesh have nothing near: they cost no corners.
  NumberOfLast last(*this);
  const auto may_be_near = [&](std::uint32_t body) {
    const OptionalIndex<std::uint32_t> number = last.find(body);
    return number && boxes[*number].lo[0] <= boxes[*number].hi[0];
  };
  const auto add_if_near = [&](std::size_t n_corners) {
    Box own = empty_box();
    for (std::size_t k = 0; k < n_corners; ++k)
      add_point(volume.corners.col(static_cast<Eigen::Index>(k)), own);
    if (do_overlap(own, boxes[*last.find(volume.body)])) near.push_back(volume);
  };
  for (const ElementBlock& block : mesh_.blocks()) {
    if (topology(block.shape).family != Family::solid) continue;
    const std::size_t n_corners = topology(block.shape).n_corners;
    volume.shape = block.shape;
    for (std::uint32_t e = 0; e < block.n_elements; ++e) {
      const auto nodes = block.element_nodes(e);
      volume.body = bodies_[nodes[0].value];
      volume.element = {block.first_element.value + e};
      if (!may_be_near(volume.body) || (!alive_.empty() && !alive_[volume.element.value])) continue;
      for (std::size_t k = 0; k < n_corners; ++k)
        volume.corners.col(static_cast<Eigen::Index>(k)) = coordinates.col(nodes[k].value);
      add_if_near(n_corners);
    }
  }
  for (const auto& [loft, element] : lofts_) {
    const bool is_triangle = loft[2] == loft[3];
    const std::size_t n = is_triangle ? 3 : 4;
    volume.shape = is_triangle ? Shape::wedge6 : Shape::hex8;
    volume.body = bodies_[contact_mesh_.mesh_nodes[loft[0]].value];
    volume.element = element;
    if (!may_be_near(volume.body)) continue;
    for (std::size_t k = 0; k < n; ++k) {
      volume.corners.col(static_cast<Eigen::Index>(k)) = kinematics.x(loft[k]);
      volume.corners.col(static_cast<Eigen::Index>(k + n)) = kinematics.x(loft[k + 4]);
    }
    add_if_near(2 * n);
  }
  return near;
}

}  // namespace contactsim
