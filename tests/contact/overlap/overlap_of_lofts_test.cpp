// SPDX-License-Identifier: BSD-3-Clause
// Overlap removal of shells, beams and particles: where nodes go, and that contact is at rest afterwards.
#include <numbers>

#include "contact/overlap/overlap_removal.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace overlap_of_lofts_test {

namespace {

constexpr double thickness = 0.1, radius = 0.1, depth = 0.02;
constexpr double accuracy = 1e-8;  // of radii, which have single precision

/// Bodies before and after removal of their overlap.
struct Cleared {
  Cleared(const MeshBuilder& builder, const std::string& lines, const std::vector<std::int64_t>& held = {},
          const std::string& options = "")
      : before(builder, general_contact(lines) + options), after(builder, general_contact(lines) + options) {
    std::vector<std::uint8_t> is_held(before.mesh.n_nodes(), 0);
    for (const std::int64_t block : held) {
      for (const NodeIndex node : nodes_of(block)) is_held[node.value] = 1;
    }
    removed = remove_overlap(before.definition, before.mesh, *before.region.contact, is_held);
    after.x = removed.coordinates;
    before.ask();
    after.ask();
  }

  std::vector<NodeIndex> nodes_of(std::int64_t block) const {
    return before.mesh.blocks()[static_cast<std::size_t>(block - 1)].nodes;
  }
  Eigen::Vector3d step(NodeIndex node) const {
    return removed.coordinates.col(node.value) - before.mesh.coordinates().col(node.value);
  }
  /// Whether all nodes of a block went the same way.
  bool moved_by(std::int64_t block, const Eigen::Vector3d& way) const {
    return std::ranges::all_of(nodes_of(block),
                               [&](NodeIndex node) { return (step(node) - way).norm() < accuracy; });
  }
  /// Fails unless contact pushes before and hardly after.
  ///   left  of the force, at most [1]
  void check_rest(double left = 1e-5) const {
    CHECK(before.force_size() > 0.0);
    CHECK(after.force_size() <= left * before.force_size());
    for (const OverlapMoves& moves : removed.moves) CHECK(moves.left <= 1e-5 * moves.deepest);
  }

  ContactBodies before, after;
  OverlapRemoved removed;
};

std::string formulation() {
  const std::string name = GENERATE("node_face", "face_face");
  return "constraint formulation = " + name + "\n";
}

/// A block of height 1 with a sheet on top, lowered into it.
MeshBuilder sheet_in_block(std::array<int, 2> cells, double width) {
  MeshBuilder b;
  const double edge = 0.5 * (1.0 - width);
  b.add_hexes({.id = 1, .cells = {3, 3, 1}});
  add_plate(b,
            {.id = 2,
             .cells = cells,
             .origin = {edge, edge, 1.0 + 0.5 * thickness - depth},
             .u = {width, 0, 0},
             .v = {0, width, 0},
             .share_nodes = false},
            thickness);
  return b;
}

}  // namespace

TEST_CASE("a shell and the block that it lies in meet half way", "[contact][overlap]") {
  const Cleared cleared(sheet_in_block({3, 3}, 1.0), formulation());
  CHECK(cleared.moved_by(2, {0, 0, 0.5 * depth}));
  for (const NodeIndex node : cleared.nodes_of(1)) {
    const bool is_on_top = cleared.before.mesh.coordinates()(2, node.value) == 1.0;
    CHECK((cleared.step(node) - Eigen::Vector3d(0, 0, is_on_top ? -0.5 * depth : 0.0)).norm() < accuracy);
  }
  cleared.check_rest();
}

TEST_CASE("out of a held block a shell goes all the way", "[contact][overlap]") {
  const Cleared cleared(sheet_in_block({4, 4}, 0.7), formulation(), {1});
  CHECK(cleared.moved_by(1, Eigen::Vector3d::Zero()));
  CHECK(cleared.moved_by(2, {0, 0, depth}));
  CHECK(cleared.removed.moves.at(0).n_nodes == 25);
  CHECK(cleared.removed.moves.at(0).deepest == Approx(depth));
  cleared.check_rest();
}

TEST_CASE("a shell comes out of a block whose mesh does not match", "[contact][overlap]") {
  const Cleared cleared(sheet_in_block({4, 4}, 0.7), formulation());
  cleared.check_rest(1e-3);  // faces are warped then, and their facets rise above what their nodes lie on
}

TEST_CASE("parallel shells meet half way, whichever sides face each other", "[contact][overlap]") {
  const bool is_turned = GENERATE(false, true);
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, thickness);
  const Eigen::Vector3d x(1, 0, 0), y(0, 1, 0);
  add_plate(b,
            {.id = 2,
             .cells = {3, 3},
             .origin = {0, 0, thickness - depth},
             .u = is_turned ? y : x,
             .v = is_turned ? x : y,
             .share_nodes = false},
            thickness);
  const Cleared cleared(b, formulation());
  CHECK(cleared.moved_by(1, {0, 0, -0.5 * depth}));
  CHECK(cleared.moved_by(2, {0, 0, 0.5 * depth}));
  cleared.check_rest();
}

TEST_CASE("shells whose rims lie in each other part in their plane", "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, thickness);
  add_plate(b, {.id = 2, .cells = {3, 3}, .origin = {1.0 - depth, 0, 0}, .share_nodes = false}, thickness);
  const Cleared cleared(b, formulation());
  for (const NodeIndex node : cleared.nodes_of(2)) {
    const bool is_at_rim = cleared.before.mesh.coordinates()(0, node.value) == 1.0 - depth;
    CHECK((cleared.step(node) - Eigen::Vector3d(is_at_rim ? 0.5 * depth : 0.0, 0, 0)).norm() < accuracy);
  }
  cleared.check_rest();
}

TEST_CASE("strips of shells that cross between their nodes part", "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 1}, .origin = {-1.5, -0.1, 0}, .u = {3, 0, 0}, .v = {0, 0.2, 0}},
            thickness);
  SECTION("two") {
    add_plate(b,
              {.id = 2,
               .cells = {1, 3},
               .origin = {-0.1, -1.5, thickness - depth},
               .u = {0.2, 0, 0},
               .v = {0, 3, 0}},
              thickness);
  }
  SECTION("one over a bar") {
    b.add_hexes(
        {.id = 2, .cells = {1, 3, 1}, .origin = {-0.1, -1.5, 0.5 * thickness - depth}, .size = {0.2, 3, 1}});
  }
  const Cleared cleared(b, "constraint formulation = face_face\n");
  CHECK(cleared.removed.moves.at(0).deepest == Approx(depth));
  cleared.check_rest();
  const Cleared held(b, "constraint formulation = face_face\n", {1});
  CHECK(held.moved_by(1, Eigen::Vector3d::Zero()));
  held.check_rest();
}

TEST_CASE("a tube of shells comes out of the one around it", "[contact][overlap]") {
  const auto add_tube = [](MeshBuilder& b, std::int64_t id, double r, std::uint32_t n) {
    std::vector<std::uint32_t> first, nodes;
    for (std::uint32_t i = 0; i < n; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / n;
      const Eigen::Vector3d at(r * std::cos(angle), r * std::sin(angle), 0.1 * static_cast<double>(id));
      first.push_back(b.add_node(at).value);
      b.add_node(at + Eigen::Vector3d::UnitZ());
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      const std::uint32_t a = first[i], c = first[(i + 1) % n];
      nodes.insert(nodes.end(), {a, c, c + 1, a + 1});
    }
    b.add_block(id, "", Shape::shell4, nodes);
    b.set_attributes(id, {"thickness"}, std::vector<double>(n, thickness));
  };
  MeshBuilder b;
  add_tube(b, 1, 1.0, 24);
  add_tube(b, 2, 1.09, 30);
  const Cleared cleared(b, formulation());
  CHECK(cleared.removed.moves.at(0).left <= 1e-3 * cleared.removed.moves.at(0).deepest);
  CHECK(cleared.before.force_size() > 0.0);
  CHECK(cleared.after.force_size() <= 1e-3 * cleared.before.force_size());
}

TEST_CASE("a shell that is pushed far pushes what it meets there", "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}});
  add_plate(b, {.id = 2, .cells = {3, 3}, .origin = {0, 0, 0.75}, .share_nodes = false}, thickness);
  add_plate(b, {.id = 3, .cells = {3, 3}, .origin = {0, 0, 1.13}, .share_nodes = false}, thickness);
  const Cleared cleared(b, formulation(), {1});
  REQUIRE(!cleared.removed.moves.empty());
  CHECK(cleared.after.force_size() < 1e-4);
  for (const OverlapMoves& moves : cleared.removed.moves) CHECK(moves.left <= 1e-2 * depth);
}

TEST_CASE("a sheet deep in a block goes out by the face that is nearest", "[contact][overlap]") {
  const double z = GENERATE(0.3, 0.4, 0.6, 0.7);
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 2}, .size = {3, 3, 1}});
  add_plate(b, {.id = 2, .cells = {3, 3}, .origin = {1, 1, z}, .share_nodes = false}, thickness);
  const Cleared cleared(b, formulation(), {1});
  const double way = z > 0.5 ? 1.0 - z + 0.5 * thickness : -z - 0.5 * thickness;
  CHECK(cleared.moved_by(2, {0, 0, way}));
}

TEST_CASE("shells that overlap by more than half their thickness part the shorter way",
          "[contact][overlap]") {
  const double off = GENERATE(-0.4, -0.1, 0.1, 0.4);  // of the mid surfaces, in thicknesses
  const int shape = GENERATE(0, 1);
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, thickness);
  const Sheet upper{.id = 2,
                    .cells = {3, 3},
                    .origin = {0.1, 0.2, off * thickness},
                    .u = {1, 0.2, 0},
                    .v = {-0.2, 1, 0},
                    .share_nodes = false};
  if (shape == 0) add_plate(b, upper, thickness);
  if (shape == 1) b.add_triangles(upper).set_attributes(2, {"thickness"}, std::vector<double>(18, thickness));
  const Cleared cleared(b, formulation(), {1});
  REQUIRE(cleared.removed.moves.size() == 1);
  CHECK(cleared.removed.moves[0].deepest == Approx((1.0 - std::abs(off)) * thickness));
  CHECK(cleared.moved_by(2, {0, 0, std::copysign(thickness, off) - off * thickness}));
  CHECK(cleared.after.force_size() == 0.0);
}

TEST_CASE("a thin shell within a thick one goes out by the nearer face", "[contact][overlap]") {
  const double off = GENERATE(-0.2, 0.2);
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, thickness);
  add_plate(b, {.id = 2, .cells = {2, 2}, .origin = {0.1, 0.1, off * thickness}, .share_nodes = false},
            0.1 * thickness);
  const Cleared cleared(b, formulation(), {1});
  CHECK(cleared.moved_by(2, {0, 0, std::copysign(0.55 * thickness, off) - off * thickness}));
}

TEST_CASE("a ball and a block behind the middle of a shell go out of it", "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, thickness);
  const double off = 0.2 * thickness;
  if (GENERATE(true, false)) {
    add_balls(b, 2, {{0.4, 0.6, off}}, radius);
    CHECK(Cleared(b, formulation(), {1}).moved_by(2, {0, 0, 0.5 * thickness - off + radius}));
  } else {
    b.add_hexes({.id = 2, .origin = {0.1, 0.1, -off}, .size = {0.7, 0.7, 1.0}, .share_nodes = false});
    CHECK(Cleared(b, formulation(), {1}).moved_by(2, {0, 0, 0.5 * thickness + off}));
  }
}

TEST_CASE("shells that end on the middle of another, or are tied to it, do not lie deep in it",
          "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {3, 3}}, thickness);
  if (GENERATE(true, false)) {
    add_plate(b, {.id = 2, .cells = {2, 2}, .origin = {0.1, 0.4, 0}, .v = {0, 0, 1}, .share_nodes = false},
              thickness);
    CHECK(Cleared(b, formulation(), {1}).removed.n_body_passes == 0);
  } else {
    add_plate(b, {.id = 2, .cells = {2, 2}, .share_nodes = false}, thickness);
    CHECK(Cleared(b, "friction model = tied\n", {1}).removed.n_body_passes == 0);
    CHECK(Cleared(b, formulation(), {1}).removed.n_body_passes == 1);
  }
}

TEST_CASE("a shell that stands in a block goes out as a whole by the depth of its rim, however thin",
          "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {1.5, 1.5, 1}});
  b.add_shells({.id = 2,
                .cells = {2, 2},
                .origin = {0.25, 0.8, 1.0 - depth},
                .u = {1, 0, 0},
                .v = {0, 0, 1},
                .share_nodes = false});
  const double thin = 0.01;  // what is deeper than half of that is no contact
  b.set_attributes(2, {"thickness"}, std::vector<double>(4, thin));
  const Cleared cleared(b, formulation(), {1});
  for (const NodeIndex node : cleared.nodes_of(2)) {
    CHECK((cleared.step(node) - Eigen::Vector3d(0, 0, depth)).norm() < accuracy);
  }
  CHECK(cleared.after.force_size() == 0.0);
}

TEST_CASE("a particle goes out of a face all the way", "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {2, 2, 1}});
  add_balls(b, 2, {{0.3, 0.4, 1.0 + radius - depth}, {0.75, 0.75, 1.0 + 0.3 * radius}}, radius);
  const Cleared cleared(b, formulation());
  CHECK(cleared.moved_by(1, Eigen::Vector3d::Zero()));
  CHECK((cleared.step(cleared.nodes_of(2)[0]) - Eigen::Vector3d(0, 0, depth)).norm() < accuracy);
  CHECK((cleared.step(cleared.nodes_of(2)[1]) - Eigen::Vector3d(0, 0, 0.7 * radius)).norm() < accuracy);
  cleared.check_rest();
}

TEST_CASE("a particle whose centre is in a block comes out with its radius", "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 2}, .size = {3, 3, 1}});
  add_balls(b, 2, {{1.4, 1.6, 0.8}}, radius);
  const Cleared cleared(b, formulation(), {1});
  CHECK(cleared.moved_by(2, {0, 0, 0.2 + radius}));
}

TEST_CASE("a held particle has the face give way", "[contact][overlap]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  add_balls(b, 2, {{0.5, 0.5, 1.0 + radius - depth}}, radius);
  const Cleared cleared(b, formulation(), {2});
  CHECK(cleared.moved_by(2, Eigen::Vector3d::Zero()));
  CHECK(cleared.removed.moves.at(0).n_nodes == 4);
  CHECK(cleared.removed.moves.at(0).largest == Approx(depth));
  cleared.check_rest();
}

TEST_CASE("a particle and a shell behind a plane come out", "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {2, 2}, .origin = {0, 0, 0.5 * thickness - depth}}, thickness);
  add_balls(b, 2, {{3, 0, radius - 2.0 * depth}}, radius);
  const Region region = parse_region(
      "begin analytic object ground\n normal direction = 0 0 2\nend\n"
      "begin contact definition\n contact surface floor contains ground\n skin all blocks = on\n"
      " begin interaction defaults\n  general contact = on\n end\nend\n");
  const Mesh mesh = b.build();
  const auto model = make_model(mesh, region);
  REQUIRE(model.messages.empty());
  const OverlapRemoved removed = remove_overlap(model, mesh, *region.contact, {});
  const Eigen::Matrix3Xd steps = removed.coordinates - mesh.coordinates();
  for (Eigen::Index i = 0; i < 9; ++i) CHECK((steps.col(i) - Eigen::Vector3d(0, 0, depth)).norm() < 1e-12);
  CHECK((steps.col(9) - Eigen::Vector3d(0, 0, 2.0 * depth)).norm() < accuracy);
}

TEST_CASE("a beam that lies in a shell goes out of it", "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {4, 4}}, thickness);
  add_rod(b, {.id = 2,
              .cells = 3,
              .from = {0.1, 0.5, 0.5 * thickness + radius - depth},
              .to = {0.9, 0.6, 0.5 * thickness + radius - depth}});
  const Cleared cleared(b, formulation());
  CHECK(cleared.moved_by(1, Eigen::Vector3d::Zero()));
  CHECK(cleared.moved_by(2, {0, 0, depth}));
  cleared.check_rest();
}

TEST_CASE("a beam that crosses a shell without a node over it comes off its rims", "[contact][overlap]") {
  MeshBuilder b;
  add_plate(b, {.id = 1, .cells = {2, 2}}, thickness);
  const double z = 0.5 * thickness + radius - depth;
  add_rod(b, {.id = 2, .cells = 1, .from = {-0.5, 0.5, z}, .to = {1.5, 0.5, z}});
  const Cleared cleared(b, formulation());
  cleared.check_rest();
  const Cleared held(b, formulation(), {1});
  CHECK(held.moved_by(1, Eigen::Vector3d::Zero()));
  // One rim after the other.
  for (const NodeIndex end : held.nodes_of(2)) {
    CHECK(held.step(end).head<2>().norm() < accuracy);
    CHECK(held.step(end).z() == Approx(depth).epsilon(0.4));
  }
  held.check_rest();
}

TEST_CASE("rods in each other share the way", "[contact][overlap]") {
  MeshBuilder b;
  const double z = 2.0 * radius - depth;
  SECTION("crossing") {
    add_rod(b, {.id = 1, .cells = 1, .from = {-1, 0, 0}, .to = {1, 0, 0}});
    add_rod(b, {.id = 2, .cells = 1, .from = {0, -1, z}, .to = {0, 1, z}});
  }
  SECTION("parallel") {
    add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0, 0}, .to = {1, 0, 0}});
    add_rod(b, {.id = 2, .cells = 3, .from = {-1, 0, z}, .to = {1, 0, z}});
  }
  SECTION("as particles") {
    add_balls(b, 1, {{0, 0, 0}}, radius);
    add_balls(b, 2, {{0, 0, z}}, radius);
  }
  const Cleared cleared(b, "");
  CHECK(cleared.moved_by(1, {0, 0, -0.5 * depth}));
  CHECK(cleared.moved_by(2, {0, 0, 0.5 * depth}));
  cleared.check_rest();
  const Cleared held(b, "", {1});
  CHECK(held.moved_by(2, {0, 0, depth}));
  held.check_rest();
}

TEST_CASE("particles packed too tightly part", "[contact][overlap]") {
  std::vector<Eigen::Vector3d> centres;
  for (int i = 0; i < 125; ++i)
    centres.emplace_back(0.19 * (i % 5), 0.19 * (i / 5 % 5), 0.19 * (i / 25));  // 0.2 would be loose
  MeshBuilder b;
  add_balls(b, 1, centres, radius);
  const Cleared cleared(b, "self contact = on\n", {},
                        "begin remove initial overlap\n shell overlap iterations = 100\nend\n");
  CHECK(cleared.removed.moves.at(0).deepest == Approx(0.01).epsilon(0.01));
  CHECK(cleared.removed.moves.at(0).left < 1e-3 * 0.01);
  const Eigen::Vector3d drift =
      (cleared.removed.coordinates - cleared.before.mesh.coordinates()).rowwise().sum();
  CHECK(drift.norm() < accuracy);
}

TEST_CASE("a rod with one end held turns about it", "[contact][overlap]") {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 1, .from = {-1, 0, 0}, .to = {1, 0, 0}});
  add_rod(b, {.id = 2, .cells = 1, .from = {0.5, -1, 0.2 - depth}, .to = {0.5, 1, 0.2 - depth}});
  const Mesh mesh = b.build();
  const std::string lines = general_contact();
  const auto model = make_model(mesh, lines);
  const OverlapRemoved removed =
      remove_overlap(model, mesh, parse_contact(lines), std::vector<std::uint8_t>{1, 0, 1, 1});
  CHECK(removed.coordinates(2, 0) == 0.0);
  CHECK(removed.coordinates(2, 1) == Approx(-depth / 0.75).epsilon(0.01));
  CHECK(removed.moves.at(0).left <= 1e-6);
}

TEST_CASE("what the mesh joins stays, however thick and fine", "[contact][overlap]") {
  MeshBuilder b;
  const std::array<int, 2> cells{20, 20};  // half as long as they are thick
  SECTION("folded sharply") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {1, 0, 0}, .u = {0, 1, 0}, .v = {-0.6, 0, 0.8}},
              thickness);
  }
  SECTION("as a T") {
    add_plate(b, {.id = 1, .cells = cells}, thickness);
    add_plate(b, {.id = 2, .cells = cells, .origin = {0.5, 0, 0}, .u = {0, 1, 0}, .v = {0, 0, 1}}, thickness);
  }
  SECTION("lying on a part of a solid") {
    b.add_hexes({.id = 1, .cells = {20, 20, 2}, .size = {1, 1, 0.1}});
    add_plate(b, {.id = 2, .cells = {10, 20}, .origin = {0, 0, 0.1}, .u = {0.5, 0, 0}, .v = {0, 1, 0}},
              thickness);
  }
  SECTION("beams at an angle") {
    add_rod(b, {.id = 1, .cells = 20, .from = {0, 0, 0}, .to = {1, 0, 0}});
    add_rod(b, {.id = 2, .cells = 20, .from = {1, 0, 0}, .to = {1, 0.5, 1}});
  }
  const Mesh mesh = b.build();
  const std::string lines = general_contact("self contact = on\n");
  const auto model = make_model(mesh, lines);
  REQUIRE(model.messages.empty());
  const OverlapRemoved removed = remove_overlap(model, mesh, parse_contact(lines), {});
  CHECK(removed.moves.empty());
  CHECK(removed.n_passes == 0);
}

TEST_CASE("lofts have passes of their own, and keep overlap within their tolerance", "[contact][overlap]") {
  const MeshBuilder b = sheet_in_block({3, 3}, 1.0);
  const auto with = [&](const std::string& line) {
    return Cleared(b, "", {1}, "begin remove initial overlap\n" + line + "\nend\n").removed;
  };
  CHECK(with("shell overlap tolerance = 0.03").moves.empty());
  CHECK(with("shell overlap tolerance = 0.01").moves.at(0).largest == Approx(depth));
  CHECK(with("overlap iterations = 3").n_passes == 1);
  const Cleared one(sheet_in_block({4, 4}, 0.7), "", {},
                    "begin remove initial overlap\n shell overlap iterations = 1\nend\n");
  CHECK(one.removed.n_passes == 1);
  CHECK(one.removed.moves.at(0).left <= 0.01 * depth);
}

}  // namespace overlap_of_lofts_test
