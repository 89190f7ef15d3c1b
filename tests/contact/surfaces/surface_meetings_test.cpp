// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/surface_meetings.hpp"

#include <string>

#include "support/catch.hpp"

using namespace contactsim;

namespace {

constexpr SurfaceIndex brick_a{0}, brick_b{1}, shells{2}, points{3}, plane{4}, growing{5}, nothing{6};

/// Surfaces by what they have: faces of solids, faces of solids, shells, nodes, a plane, faces that deaths
/// may expose, nothing.
SurfaceList some_surfaces() {
  SurfaceList surfaces(7);
  const char* names[] = {"A", "b", "shells", "points", "plane", "growing", "nothing"};
  for (const SurfaceIndex i : indices(surfaces)) surfaces[i].name = names[i.value];
  surfaces[brick_a].faces = {ElementSide({0}, 1)};
  surfaces[brick_b].faces = {ElementSide({1}, 1)};
  surfaces[shells].lofted_elements = {{2}};
  surfaces[points].nodes = {{7}};
  surfaces[points].kind = SurfaceKind::node;
  surfaces[plane].analytic_planes = {0};
  surfaces[growing].may_gain_faces = true;
  return surfaces;
}

std::vector<DeckName> names_of(const std::string& words) {
  std::vector<DeckName> names;
  std::string word;
  for (const char letter : words + " ") {
    if (letter != ' ') {
      word += letter;
    } else if (!word.empty()) {
      names.push_back({word, {}});
      word.clear();
    }
  }
  return names;
}

/// "A-b B>shells": pairs, with sides where the interaction has them.
std::string text_of(const std::map<PairKey, Meeting>& meetings, const SurfaceList& surfaces) {
  std::string text;
  for (const auto& [key, meeting] : meetings) {
    CHECK(key == PairKey(std::minmax(meeting.first, meeting.second)));
    text +=
        surfaces[meeting.first].name + (meeting.has_sides ? ">" : "-") + surfaces[meeting.second].name + " ";
  }
  return text;
}

struct Meetings {
  SurfaceList surfaces = some_surfaces();
  SurfaceMeetings meetings{surfaces};

  std::string of(const std::string& side_a, const std::string& side_b, bool excludes = false) const {
    Interaction interaction;
    interaction.side_a = names_of(side_a);
    interaction.side_b = names_of(side_b);
    if (excludes) interaction.pair.behavior = InteractionBehavior::no_interaction;
    return text_of(meetings.meetings_of(interaction), surfaces);
  }
  std::string among(const std::string& names) const {
    Interaction interaction;
    interaction.surfaces = names_of(names);
    return text_of(meetings.meetings_of(interaction), surfaces);
  }
  std::string excluded(const std::string& names) const {
    SurfaceExclusion exclusion;
    exclusion.surfaces = names_of(names);
    return text_of(meetings.meetings_of(exclusion), surfaces);
  }
};

}  // namespace

TEST_CASE("surfaces are found by names in any case, in the order named", "[contact][pairs]") {
  const Meetings of;
  CHECK(of.meetings.positions_of(names_of("B none a B")) ==
        std::vector<SurfaceIndex>{brick_b, brick_a, brick_b});
}

TEST_CASE("faces meet faces and nodes, planes faces and nodes, and neither nodes nor planes their like",
          "[contact][pairs]") {
  const Meetings of;
  const auto meet = [&](SurfaceIndex first, SurfaceIndex second) {
    CHECK(of.meetings.can_meet({first, second}) == of.meetings.can_meet({second, first}));
    return of.meetings.can_meet({first, second});
  };
  for (const SurfaceIndex faces : {brick_a, shells, growing}) {
    CHECK(meet(faces, brick_b));
    CHECK(meet(faces, points));
    CHECK(meet(faces, plane));
    CHECK(meet(faces, faces));
    CHECK_FALSE(meet(faces, nothing));
  }
  CHECK(meet(points, plane));
  CHECK_FALSE(meet(points, points));
  CHECK_FALSE(meet(plane, plane));
  CHECK_FALSE(meet(nothing, nothing));
  CHECK(of.meetings.has_empty_side({brick_a, nothing}));
  CHECK(of.meetings.has_empty_side({growing, brick_a}));  // it has none yet
  CHECK_FALSE(of.meetings.has_empty_side({points, plane}));
}

TEST_CASE("sides have an order, which a pair that both ways name loses", "[contact][pairs]") {
  const Meetings of;
  CHECK(of.of("b", "a shells") == "b>A b>shells ");
  CHECK(of.of("a b", "b a") == "A>A A-b b>b ");
  CHECK(of.of("a", "none") == "");
  CHECK(of.among("shells b a") == "b-A shells-A shells-b ");
  CHECK(of.among("b") == "b-b ");
  CHECK(of.among("b none") == "");  // of two one there is not: no self contact
}

TEST_CASE("ALL of a side is every other surface, and itself only where it is excluded or named",
          "[contact][pairs]") {
  const Meetings of;
  CHECK(of.of("b", "all") == "b>A b>shells b>points b>plane b>growing b>nothing ");
  CHECK(of.of("b", "ALL", true) == "b>A b>b b>shells b>points b>plane b>growing b>nothing ");
  CHECK(of.of("b", "all b") == "b>A b>b b>shells b>points b>plane b>growing b>nothing ");
}

TEST_CASE("exclusions are of pairs, of a surface with itself, of one with all, of all", "[contact][pairs]") {
  Meetings of;
  CHECK(of.excluded("b a") == "b-A ");
  CHECK(of.excluded("shells") == "shells-shells ");
  CHECK(of.excluded("b all") == "b-A b-b b-shells b-points b-plane b-growing b-nothing ");
  CHECK(std::ranges::count(of.excluded("all"), '-') == 7 * 8 / 2);
  of.surfaces[nothing].name = "All";  // a surface of that name stands for itself
  const SurfaceMeetings named(of.surfaces);
  SurfaceExclusion exclusion;
  exclusion.surfaces = names_of("b all");
  CHECK(text_of(named.meetings_of(exclusion), of.surfaces) == "b-All ");
}

TEST_CASE("who gives faces and who nodes is settled by what both have, then by the sides",
          "[contact][pairs]") {
  const Meetings of;
  const auto settled = [&](Meeting meeting, ConstraintFormulation formulation) {
    SurfacePair pair;
    pair.formulation = formulation;
    pair.sides = {ShellSides::top, ShellSides::bottom};
    of.meetings.settle(meeting, pair);
    return pair;
  };
  using enum ConstraintFormulation;
  // Both have faces: in the order of surfaces, but for the sides of NODE_FACE.
  SurfacePair pair = settled({shells, brick_a}, face_face);
  CHECK((pair.first == brick_a && pair.second == shells && !pair.is_one_sided && !pair.side_b));
  CHECK(pair.sides == std::array{ShellSides::bottom, ShellSides::top});
  pair = settled({shells, brick_a, true}, face_face);
  CHECK((pair.first == brick_a && pair.second == shells && !pair.is_one_sided));
  CHECK(*pair.side_b == brick_a);
  CHECK(pair.sides == std::array{ShellSides::both, ShellSides::top});  // sides are those of SIDE A
  pair = settled({shells, brick_a, true}, node_face);
  CHECK((pair.first == shells && pair.second == brick_a && pair.is_one_sided && *pair.side_b == brick_a));
  CHECK(pair.sides == std::array{ShellSides::top, ShellSides::both});
  pair = settled({shells, shells, true}, node_face);
  CHECK((!pair.is_one_sided && !pair.side_b));
  // Nodes are the second side, whatever the sides say; a plane gives faces.
  for (const bool has_sides : {false, true}) {
    pair = settled({points, brick_a, has_sides}, face_face);
    CHECK((pair.first == brick_a && pair.second == points && pair.is_one_sided && *pair.side_b == points));
    CHECK(pair.formulation == node_face);
    pair = settled({brick_a, plane, has_sides}, face_face);
    CHECK((pair.first == plane && pair.second == brick_a && pair.is_one_sided && *pair.side_b == brick_a));
  }
}
