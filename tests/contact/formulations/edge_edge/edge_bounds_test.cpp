// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/edge_edge/edge_bounds.hpp"

#include <algorithm>
#include <cmath>
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
    for (const EdgeIndex edge : indices(parts.contact_mesh.edges)) edges.push_back(edge);
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
  std::vector<EdgeIndex> edges;
};

using Reach = EdgeBounds::Reach;
constexpr Reach any_reach{0.0, 1e9};

/// Of a pair that stands in any lane among others, at whatever distance if nothing is said.
bool may_touch(const EdgeBounds& bounds, std::uint32_t a, std::uint32_t b, const Reach& reach = any_reach) {
  EdgeBounds::Pairs pairs;
  const std::uint32_t lane = (a + b) % n_float_lanes;
  for (std::uint32_t i = 0; i < lane; ++i) pairs.add({i % 12}, {12 + (b + i) % 12}, 0);
  pairs.add({a}, {b}, 0);
  return (bounds.may_touch(pairs, reach) >> lane & 1) != 0;
}

/// How far apart two edges are along the normal of both, less what they may close by and what is left of
/// their thickness [length].
double distance_out_of_reach(const ContactKinematics& kinematics, const ContactEdge& first,
                             const ContactEdge& second, const Reach& reach) {
  const Vector3d a = kinematics.x(first.nodes[0]), b = kinematics.x(second.nodes[0]);
  const Vector3d normal =
      (kinematics.x(first.nodes[1]) - a).cross(kinematics.x(second.nodes[1]) - b).normalized();
  double speed = 0.0;
  for (const ContactNodeIndex i : first.nodes) {
    for (const ContactNodeIndex j : second.nodes)
      speed = std::max(speed, (kinematics.v(i) - kinematics.v(j)).norm());
  }
  return std::abs((b - a).dot(normal)) - reach.depth * first.penalty_properties.thickness - reach.shift -
         speed * reach.time;
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
    bounds.update(parts.kinematics, bricks.edges, bricks.untouched);
    for (std::uint32_t a = 0; a < 12; ++a) {
      for (std::uint32_t b = 12; b < 24; ++b) {
        const ContactEdge &first = parts.contact_mesh.edges[{a}], &second = parts.contact_mesh.edges[{b}];
        Segment one, other;
        one << parts.kinematics.x(first.nodes[0]), parts.kinematics.x(first.nodes[1]);
        other << parts.kinematics.x(second.nodes[0]), parts.kinematics.x(second.nodes[1]);
        const bool meet = find_edge_gap(parts.kinematics, first, second, nearest_points(one, other),
                                        std::numeric_limits<double>::infinity(), true)
                              .has_value();
        const bool may = may_touch(bounds, a, b);
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
  bounds.update(bricks.parts.kinematics, bricks.edges, bricks.untouched);
  const auto n_partners = [&](std::uint32_t b) {
    int n = 0;
    for (std::uint32_t a = 0; a < 12; ++a) n += may_touch(bounds, a, b) ? 1 : 0;
    return n;
  };
  const int n_of_other = n_partners(13);
  CHECK(n_partners(12) < 12);
  bricks.untouched[{12}] = 0.01f;
  bounds.update(bricks.parts.kinematics, bricks.edges, bricks.untouched);
  CHECK(n_partners(12) == 12);
  CHECK(n_partners(13) == n_of_other);
}

TEST_CASE("edges that cross within reach along the normal of both may touch, others do not",
          "[contact][edges]") {
  const double far = GENERATE(0.0, 1e5), speed = GENERATE(0.0, 100.0), ahead = GENERATE(0.0, 0.002);
  const Reach reach{ahead, 0.01, GENERATE(1.0, 0.1)};
  Random random(2);
  Bricks bricks;
  ContactParts& parts = bricks.parts;
  for (ContactEdge& edge : parts.contact_mesh.edges) edge.penalty_properties.thickness = 0.05;
  EdgeBounds bounds;
  int n_near = 0, n_left_out = 0;
  for (int i = 0; i < 200; ++i) {
    for (Eigen::Index k = 0; k < parts.v.cols(); ++k) parts.v.col(k) = random_vector(random, speed);
    bricks.throw_at_random(random, far);
    bounds.update(parts.kinematics, bricks.edges, bricks.untouched);
    for (std::uint32_t a = 0; a < 12; ++a) {
      for (std::uint32_t b = 12; b < 24; ++b) {
        if (!may_touch(bounds, a, b)) continue;
        const double out = distance_out_of_reach(parts.kinematics, parts.contact_mesh.edges[{a}],
                                                 parts.contact_mesh.edges[{b}], reach);
        const bool may = may_touch(bounds, a, b, reach);
        if (out <= 0.0 && !may) FAIL("edges within reach are left out");
        // Speeds count by the sum of their components, and the nodes' apart from the mean's: twice, thrice.
        if (out > 0.02 + 4.0 * std::sqrt(3.0) * speed * ahead && may) FAIL("edges out of reach are kept");
        n_near += out <= 0.0 ? 1 : 0;
        n_left_out += may ? 0 : 1;
      }
    }
  }
  CHECK(n_near > 20);
  if (speed * ahead == 0.0) CHECK(n_left_out > 1000);
}
