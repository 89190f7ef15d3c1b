// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_geometry.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <memory>

#include "app/report/face_owners.hpp"
#include "contact/lofting/section_sizes.hpp"
#include "core/definition/simulation.hpp"
#include "core/mesh/skin.hpp"

namespace contactsim {

namespace {

constexpr std::string_view set_prefix = "contact_";

/// The owners that a results file's side sets tell: position of a set among those of contact, plus 1.
using SetOwners = std::map<ElementSide, std::uint32_t>;

SetOwners owners_of_sets(const Mesh& mesh, std::vector<std::string>& names) {
  SetOwners owners;
  for (std::uint32_t i = 0; i < mesh.side_sets().size(); ++i) {
    const std::string name = mesh.name({EntityKind::side_set, i});
    if (!name.starts_with(set_prefix)) continue;
    names.push_back(name.substr(set_prefix.size()));
    for (const ElementSide side : mesh.side_sets()[i].sides)
      owners.try_emplace(side, static_cast<std::uint32_t>(names.size()));
  }
  return owners;
}

class GeometryMaker {
 public:
  GeometryMaker(const Mesh& mesh, const std::optional<ReportRegion>& region, const ElementLife& life)
      : mesh_(mesh), life_(life) {
    point_of_node_.assign(mesh.n_nodes(), std::nullopt);
    if (region && region->region.contact) owners_ = std::make_unique<FaceOwners>(*region, mesh);
    if (!owners_) of_sets_ = owners_of_sets(mesh, made_.owners);
    made_.radii.assign(mesh.blocks().size(), 0.0);
    if (!region) return;
    const std::vector<SectionSize> sizes = find_section_sizes(region->definition, region->region, mesh);
    std::ranges::transform(sizes, made_.radii.begin(),
                           [](const SectionSize& size) { return size.radius.value_or(0.0); });
  }

  ReportGeometry make() {
    for (const ElementSide side : find_faces()) add_solid_face(side);
    for (std::uint32_t b = 0; b < mesh_.blocks().size(); ++b) add_thin_block(b);
    std::ranges::stable_sort(made_.faces, {}, [](const ReportFace& face) { return face.element; });
    number_points();
    made_.lost.resize(1);
    if (!owners_) return std::move(made_);
    made_.owners = owners_->names();
    made_.lost = owners_->lost();
    made_.knows_claims = true;
    return std::move(made_);
  }

 private:
  Family family_of(std::uint32_t block) const { return topology(mesh_.blocks()[block].shape).family; }

  std::vector<ElementSide> find_faces() const {
    const std::vector<std::uint8_t> all(mesh_.n_elements(), 1);
    std::vector<ElementSide> faces = make_skin(mesh_, all).exterior, more, joined;
    if (owners_) more = owners_->faces();
    for (const auto& [side, owner] : of_sets_) more.push_back(side);
    std::ranges::set_union(faces, more, std::back_inserter(joined));
    for (const auto& [side, time] : life_.exposed) joined.push_back(side);
    std::ranges::sort(joined);
    joined.erase(std::unique(joined.begin(), joined.end()), joined.end());
    return joined;
  }

  void add_face(ReportFace face, const std::array<NodeIndex, 4>& corners, bool is_lofted) {
    for (std::size_t i = 0; i < 4; ++i) face.points[i] = corners[i].value;  // nodes until they are numbered
    if (!life_.dead_from.empty()) fill_life(face);
    if (owners_) {
      owners_->fill(is_lofted, face);
    } else if (const auto found = of_sets_.find({face.element, face.side}); found != of_sets_.end()) {
      face.owner = found->second;
    }
    made_.faces.push_back(face);
  }

  void fill_life(ReportFace& face) const {
    face.hidden_from = life_.dead_from[face.element.value];
    const auto exposed = life_.exposed.find({face.element, face.side});
    if (exposed != life_.exposed.end()) face.shown_from = exposed->second;
  }

  void add_solid_face(ElementSide side) {
    const std::uint32_t block = mesh_.block_of(side.element());
    if (family_of(block) != Family::solid) return;
    for (const auto& corners : mesh_.side_facets(side))
      add_face({{}, side.element(), side.side(), block}, corners, false);
  }

  void add_thin_block(std::uint32_t b) {
    const ElementBlock& block = mesh_.blocks()[b];
    for (std::uint32_t i = 0; i < block.n_elements && !block.nodes.empty(); ++i) {
      const ElementIndex element{block.first_element.value + i};
      const std::span<const NodeIndex> nodes = block.element_nodes(i);
      if (family_of(b) == Family::shell) {
        const std::size_t last = topology(block.shape).n_corners - 1u;
        add_face({{}, element, 1, b}, {nodes[0], nodes[1], nodes[2], nodes[last]}, true);
      } else if (family_of(b) == Family::line || family_of(b) == Family::particle) {
        auto& things = family_of(b) == Family::line ? made_.lines : made_.particles;
        const std::array<std::uint32_t, 2> ends{nodes[0].value, nodes[nodes.size() > 1 ? 1 : 0].value};
        things.push_back({ends, element, b, owners_ ? owners_->owner_of(element) : 0});
      }
    }
  }

  void number(std::uint32_t& node) {
    OptionalIndex<std::uint32_t>& point = point_of_node_[node];
    if (!point) {
      point = static_cast<std::uint32_t>(made_.nodes.size());
      made_.nodes.push_back({node});
    }
    node = *point;
  }

  template <class Things>
  void number_all(Things& things) {
    for (auto& thing : things) std::ranges::for_each(thing.points, [&](auto& node) { number(node); });
  }

  void number_points() {
    number_all(made_.faces);
    number_all(made_.lines);
    number_all(made_.particles);
  }

  const Mesh& mesh_;
  const ElementLife& life_;
  std::unique_ptr<FaceOwners> owners_;
  SetOwners of_sets_;
  std::vector<OptionalIndex<std::uint32_t>> point_of_node_;  // [n_nodes]
  ReportGeometry made_;
};

}  // namespace

ReportGeometry make_report_geometry(const Mesh& mesh, const std::optional<ReportRegion>& region,
                                    const ElementLife& life) {
  return GeometryMaker(mesh, region, life).make();
}

}  // namespace contactsim
