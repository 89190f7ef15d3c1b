// SPDX-License-Identifier: BSD-3-Clause
#include <map>
#include <set>

#include "contact/surfaces/resolve_surfaces.hpp"
#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/random_contact.hpp"

// What must hold for every mesh and every deck, tried on random ones.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// The slow and obvious resolution of lines whose items are blocks and side sets of solids.
class SlowResolution {
 public:
  SlowResolution(const Mesh& mesh, const ContactDefinition& contact) : mesh_(mesh) {
    for (const SurfaceCommand& command : contact.surface_commands) {
      if (const auto* line = std::get_if<ContactSurfaceLine>(&command)) lines_.push_back(line);
    }
    for (const auto* line : lines_) {
      for (const DeckName& item : line->items) {
        if (const auto block = mesh_.find(EntityKind::block, item.text)) present_.insert(*block);
      }
    }
    for (std::uint32_t e = 0; e < mesh_.n_elements(); ++e) add_faces_of({e});
    for (const auto* line : lines_) claim(*line);
  }

  const std::map<ElementSide, std::string>& face_owner() const { return face_owner_; }
  const std::map<ElementIndex, std::string>& loft_owner() const { return loft_owner_; }

 private:
  Family family_of(ElementIndex element) const {
    return topology(mesh_.blocks()[mesh_.block_of(element)].shape).family;
  }

  void add_faces_of(ElementIndex element) {
    if (present_.count(mesh_.block_of(element)) == 0) return;
    const Topology& shape = topology(mesh_.blocks()[mesh_.block_of(element)].shape);
    for (int side = 1; side <= static_cast<int>(shape.sides.size()); ++side) {
      if (shape.sides[static_cast<std::size_t>(side - 1)].kind != SideKind::face) continue;
      const auto nodes = mesh_.side_nodes({element, side});
      sharing_[std::set<NodeIndex>(nodes.begin(), nodes.end())].insert(element);
    }
  }

  void claim(const ContactSurfaceLine& line) {
    for (const DeckName& item : line.items) {
      if (const auto set = mesh_.find(EntityKind::side_set, item.text)) {
        for (const ElementSide side : mesh_.side_sets()[*set].sides)
          face_owner_.try_emplace(side, line.name.text);
      }
      if (const auto block = mesh_.find(EntityKind::block, item.text)) claim(mesh_.blocks()[*block], line);
    }
  }

  void claim(const ElementBlock& block, const ContactSurfaceLine& line) {
    for (std::uint32_t i = 0; i < block.n_elements; ++i) {
      const ElementIndex element{block.first_element.value + i};
      if (family_of(element) != Family::solid) {
        loft_owner_.try_emplace(element, line.name.text);
        continue;
      }
      for (int side = 1; side <= static_cast<int>(topology(block.shape).sides.size()); ++side) {
        const auto nodes = mesh_.side_nodes({element, side});
        const bool is_alone = sharing_[std::set<NodeIndex>(nodes.begin(), nodes.end())].size() == 1;
        if (is_alone) face_owner_.try_emplace(ElementSide(element, side), line.name.text);
      }
    }
  }

  const Mesh& mesh_;
  std::vector<const ContactSurfaceLine*> lines_;
  std::set<std::uint32_t> present_;
  std::map<std::set<NodeIndex>, std::set<ElementIndex>> sharing_;
  std::map<ElementSide, std::string> face_owner_;
  std::map<ElementIndex, std::string> loft_owner_;
};

}  // namespace

TEST_CASE("random decks give the owners of a slow resolution, no face twice", "[contact][properties]") {
  Random random(1);
  for (int round = 0; round < 60; ++round) {
    const Mesh mesh = random_mesh_or_blocking(random).build();
    const std::string lines = join(random_lines(random));
    const auto result = resolve(mesh, lines);
    REQUIRE(result.messages.empty());
    const ContactDefinition contact = parse_contact(lines);
    const SlowResolution slow(mesh, contact);
    std::map<ElementSide, std::string> face_owner;
    std::map<ElementIndex, std::string> loft_owner;
    for (const ContactSurface& surface : result.surfaces) {
      for (const ElementSide face : surface.faces) CHECK(face_owner.try_emplace(face, surface.name).second);
      for (const ElementIndex one : surface.lofted_elements)
        CHECK(loft_owner.try_emplace(one, surface.name).second);
    }
    CHECK(face_owner == slow.face_owner());
    CHECK(loft_owner == slow.loft_owner());
  }
}

TEST_CASE("a surface claims what it would own alone, and loses the rest to earlier ones",
          "[contact][properties]") {
  Random random(2);
  for (int round = 0; round < 30; ++round) {
    const Mesh mesh = random_mesh_or_blocking(random).build();
    const auto lines = random_lines(random);
    const auto result = resolve(mesh, join(lines));
    for (std::uint32_t i = 0; i < result.surfaces.size(); ++i) {
      const ContactSurface& surface = result.surfaces[i];
      std::size_t lost_faces = 0, lost_lofted = 0, lost_nodes = 0;
      for (const LostClaims& lost : surface.lost_to) {
        CHECK(lost.winner < i);
        lost_faces += lost.faces;
        lost_lofted += lost.lofted;
        lost_nodes += lost.nodes;
      }
      std::vector<std::string> first = lines;
      std::rotate(first.begin(), first.begin() + i, first.begin() + i + 1);
      const ContactSurface alone = resolve(mesh, join(first)).surfaces.front();
      CHECK(alone.lost_to.empty());
      CHECK(alone.faces.size() == surface.faces.size() + lost_faces);
      CHECK(alone.lofted_elements.size() == surface.lofted_elements.size() + lost_lofted);
      CHECK(alone.nodes.size() == surface.nodes.size() + lost_nodes);
    }
  }
}
