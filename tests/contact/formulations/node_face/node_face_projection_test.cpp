// SPDX-License-Identifier: BSD-3-Clause
#include <bit>
#include <cstdint>
#include <set>

#include "contact/formulations/node_face/node_face_contacts.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Two slabs of hexahedra of unlike sizes, one a little inside the other, and tetrahedra whose tips are in
/// the upper one; every node is moved at random.
struct RoughSlabs : ContactParts {
  explicit RoughSlabs(Random& random)
      : ContactParts(make(), general_contact("constraint formulation = node_face\n")), contacts(setup()) {
    for (auto node : x.colwise()) node += random_vector(random, 0.02);
    for (auto velocity : v.colwise()) velocity = random_vector(random, 0.1);
    move();
    search();
    contacts.take_candidates(node_faces);
  }
  static MeshBuilder make() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {5, 5, 1}, .size = {5, 5, 1}});
    b.add_hexes(
        {.id = 2, .cells = {7, 6, 1}, .origin = {0.3, 0.2, 0.97}, .size = {5, 5, 1}, .share_nodes = false});
    std::vector<std::uint32_t> tets;
    for (int i = 0; i < 4; ++i) {
      const Vector3d at(1.2 * i, 1.1 * i, 2.0);
      for (const Vector3d& way : {Vector3d(0, 0, -0.04), Vector3d(0.9, 0.1, 0.7), Vector3d(0.2, 0.8, 0.8),
                                  Vector3d(-0.6, -0.5, 0.9)})
        tets.push_back(b.add_node(at + way).value);
    }
    b.add_block(3, "", Shape::tet4, tets);
    return b;
  }
  std::vector<ContactPoint> detect(const ContactStepContext& context, std::size_t begin, std::size_t end) {
    std::vector<ContactPoint> points;
    contacts.detect(context, {begin, end}, points);
    return points;
  }

  NodeFaceContacts contacts;
};

std::vector<std::uint64_t> bits_of(const ContactPoint& point) {
  std::vector<std::uint64_t> bits{point.first_entity, point.second_entity, point.pair.value};
  const auto add = [&](double number) { bits.push_back(std::bit_cast<std::uint64_t>(number)); };
  for (int i = 0; i < 3; ++i) add(point.normal[i]);
  for (int i = 0; i < 4; ++i) add(point.second.weights[i]);
  for (const double number : {point.gap, point.area, point.force, point.stiffness, point.closing})
    add(number);
  return bits;
}

}  // namespace

TEST_CASE("contact points of nodes do not depend on which are projected together", "[contact][node_face]") {
  Random random(11);
  const double dt = GENERATE(0.0, 0.1);
  std::set<std::size_t> n_faces;  // of the nodes that touch
  for (int i = 0; i < 20; ++i) {
    RoughSlabs parts(random);
    const ContactStepContext context = parts.context(dt);
    const std::size_t n_rows = parts.contacts.n_rows();
    parts.contacts.begin_detection(context);
    const auto together = parts.detect(context, 0, n_rows);
    std::vector<ContactPoint> apart;
    for (std::size_t row = 0; row < n_rows; ++row) {
      const auto points = parts.detect(context, row, row + 1);
      n_faces.insert(points.size());
      apart.insert(apart.end(), points.begin(), points.end());
    }
    REQUIRE(together.size() == apart.size());
    for (std::size_t k = 0; k < apart.size(); ++k) CHECK(bits_of(together[k]) == bits_of(apart[k]));
    CHECK(std::ranges::is_sorted(together, {}, &ContactPoint::first_entity));
    CHECK(together.size() > n_lanes);
  }
  CHECK(n_faces.size() > 1);
}

TEST_CASE("rows without candidates between others have no contact points", "[contact][node_face]") {
  Random random(12);
  RoughSlabs parts(random);
  const ContactStepContext context = parts.context(0.0);
  parts.contacts.begin_detection(context);
  CHECK(parts.detect(context, 0, 0).empty());
  std::size_t n = 0;
  for (const ContactPoint& point : parts.detect(context, 0, parts.contacts.n_rows())) {
    CHECK_FALSE(parts.contacts.candidates().of(point.row()).empty());
    ++n;
  }
  std::size_t n_empty = 0;
  for (const SurfaceNodeIndex row : parts.contacts.candidates().rows())
    n_empty += parts.contacts.candidates().of(row).empty() ? 1 : 0;
  CHECK(n > 30);
  CHECK(n_empty > 10);
}
