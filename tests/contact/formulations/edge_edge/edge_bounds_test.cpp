// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_bounds.hpp"

#include <limits>

#include "contact/mesh/feature_edges.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Two bricks whose edges are all sharp.
struct Bricks {
  Bricks() : parts(made(), general_contact()) {
    choose_feature_edges(parts.definition.surface_options, parts.model.surfaces.surfaces, parts.kinematics,
                         parts.contact_mesh);
    start = parts.x;
    untouched.assign(parts.contact_mesh.edges.size(), 0.0f);
  }
  static MeshBuilder made() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .size = {1, 2, 1}});
    b.add_hexes({.id = 2, .size = {1, 1, 3}, .share_nodes = false});
    return b;
  }
  /// Throws the second brick into the first one, both far away.
  void throw_at_random(Random& random, double far) {
    const Eigen::Matrix3d turn = random_rotation(random);
    const Vector3d way = random_vector(random, 1.2);
    parts.x = start;
    parts.x.rightCols(8) = (turn * start.rightCols(8)).colwise() + way;
    parts.x.colwise() += far * Vector3d(1, -2, 3);
    parts.move();
  }

  ContactParts parts;
  Eigen::Matrix3Xd start;
  IndexedVector<EdgeIndex, float> untouched;
};

/// Of a pair that stands in any lane among others.
bool may_cross(const EdgeBounds& bounds, std::uint32_t a, std::uint32_t b) {
  EdgeBounds::Pairs pairs;
  const std::uint32_t lane = (a + b) % n_float_lanes;
  for (std::uint32_t i = 0; i < lane; ++i) pairs.add({i % 12}, {12 + (b + i) % 12});
  pairs.add({a}, {b});
  return (bounds.may_cross(pairs) >> lane & 1) != 0;
}

}  // namespace

TEST_CASE("edges that meet may cross as bounds have it, and most others may not", "[contact][edges]") {
  const double far = GENERATE(0.0, 1e5);
  Random random(1);
  Bricks bricks;
  const ContactParts& parts = bricks.parts;
  REQUIRE(parts.contact_mesh.edges.size() == 24);
  EdgeBounds bounds;
  int n_meet = 0, n_may = 0, n_all = 0;
  for (int i = 0; i < 200; ++i) {
    bricks.throw_at_random(random, far);
    bounds.update(parts.kinematics, bricks.untouched);
    for (std::uint32_t a = 0; a < 12; ++a) {
      for (std::uint32_t b = 12; b < 24; ++b) {
        const ContactEdge &first = parts.contact_mesh.edges[{a}], &second = parts.contact_mesh.edges[{b}];
        Segment one, other;
        one << parts.kinematics.x(first.nodes[0]), parts.kinematics.x(first.nodes[1]);
        other << parts.kinematics.x(second.nodes[0]), parts.kinematics.x(second.nodes[1]);
        const bool meet = find_edge_gap(parts.kinematics, first, second, nearest_points(one, other),
                                        std::numeric_limits<double>::infinity(), true)
                              .has_value();
        const bool may = may_cross(bounds, a, b);
        if (meet && !may) FAIL("edges that meet are left out");
        n_meet += meet ? 1 : 0;
        n_may += may ? 1 : 0;
        ++n_all;
      }
    }
  }
  CHECK(n_meet > 500);
  CHECK(n_may < n_all / 3);
}

TEST_CASE("edges that have touched something may cross whatever they do", "[contact][edges]") {
  Bricks bricks;
  bricks.parts.x.rightCols(8).colwise() += Vector3d(0, 0, 50);
  bricks.parts.move();
  EdgeBounds bounds;
  bounds.update(bricks.parts.kinematics, bricks.untouched);
  const auto n_partners = [&](std::uint32_t b) {
    int n = 0;
    for (std::uint32_t a = 0; a < 12; ++a) n += may_cross(bounds, a, b) ? 1 : 0;
    return n;
  };
  const int n_of_other = n_partners(13);
  CHECK(n_partners(12) < 12);
  bricks.untouched[{12}] = 0.01f;
  bounds.update(bricks.parts.kinematics, bricks.untouched);
  CHECK(n_partners(12) == 12);
  CHECK(n_partners(13) == n_of_other);
}
