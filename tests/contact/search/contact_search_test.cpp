// SPDX-License-Identifier: BSD-3-Clause
#include "contact/search/contact_search.hpp"

#include <algorithm>
#include <set>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/pair_sets.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Bricks of hexahedra and of tetrahedra that lie about in a cube of edge 6, some in each other.
MeshBuilder scattered_bricks(Random& random) {
  MeshBuilder b;
  for (std::int64_t id = 1; id <= 8; ++id) {
    const test::Box box{.id = id,
                        .cells = {2, 1, 2},
                        .origin = random_vector(random, 3.0),
                        .size = {1.6, 0.9, 1.4},
                        .share_nodes = false};
    if (id % 2 == 0) {
      b.add_hexes(box);
    } else {
      b.add_tets(box, 5);
    }
  }
  return b;
}

/// Blocks fly through each other, turning; the velocity is that of the last step.
void fly(ContactParts& parts, Random& random, double dt) {
  const Eigen::Matrix3Xd before = parts.x;
  for (const ElementBlock& block : parts.mesh.blocks()) {
    const std::set<std::uint32_t> nodes = [&] {
      std::set<std::uint32_t> made;
      for (const NodeIndex node : block.nodes) made.insert(node.value);
      return made;
    }();
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.1, random_vector(random, 1.0).normalized()).matrix();
    const Vector3d centre = parts.x.col(*nodes.begin()), way = random_vector(random, 0.2);
    for (const std::uint32_t i : nodes) parts.x.col(i) = centre + way + turn * (parts.x.col(i) - centre);
  }
  parts.v = (parts.x - before) / dt;
}

/// What a search must find at least: an interval on each axis, from now and from a step ago, widened.
struct Span {
  Vector3d low = Vector3d::Constant(1e300), high = Vector3d::Constant(-1e300);
  void add(const Vector3d& x) {
    low = low.cwiseMin(x);
    high = high.cwiseMax(x);
  }
  bool meets(const Span& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Corners now and a step ago, corners moved inwards, all that by a margin wider.
Span span_of_face(const ContactParts& parts, FaceIndex index, double dt) {
  const ContactFace& face = parts.contact_mesh.faces[index];
  Span span;
  const double margin = 0.15 * std::sqrt(area_vector(parts.kinematics.face(index).x).norm());
  for (const ContactNodeIndex corner : face.corners) {
    const Vector3d x = parts.kinematics.x(corner);
    span.add(x);
    span.add(x - dt * parts.kinematics.v(corner));
    span.add(x -
             0.8 * face.penalty_properties.thickness * parts.kinematics.bound(index).normal().cast<double>());
  }
  span.low.array() -= margin;
  span.high.array() += margin;
  return span;
}

bool have_common_node(const Mesh& mesh, ElementIndex first, ElementIndex second) {
  const auto nodes = mesh.element_nodes(first);
  return std::ranges::any_of(mesh.element_nodes(second),
                             [&](NodeIndex node) { return std::ranges::find(nodes, node) != nodes.end(); });
}

/// All pairs of faces of bodies whose widened boxes meet.
Pairs sweep_faces(const ContactParts& parts, double dt) {
  Pairs pairs;
  const auto n = static_cast<std::uint32_t>(parts.contact_mesh.faces.size());
  std::vector<Span> spans;
  for (std::uint32_t i = 0; i < n; ++i) spans.push_back(span_of_face(parts, {i}, dt));
  for (std::uint32_t a = 0; a < n; ++a) {
    for (std::uint32_t b = a + 1; b < n; ++b) {
      const ContactFace &first = parts.contact_mesh.faces[{a}], &second = parts.contact_mesh.faces[{b}];
      if (have_common_node(parts.mesh, first.side.element(), second.side.element())) continue;
      if (!parts.rules.find(first.surface, second.surface)) continue;
      if (spans[a].meets(spans[b])) pairs.insert({a, b});
    }
  }
  return pairs;
}

/// Cosine of how two faces look.
double cosine_of(const ContactParts& parts, std::uint32_t a, std::uint32_t b) {
  return area_vector(parts.kinematics.face({a}).x)
      .normalized()
      .dot(area_vector(parts.kinematics.face({b}).x).normalized());
}

}  // namespace

TEST_CASE("the candidates of flying bricks equal a sweep of all pairs of faces",
          "[contact][contact_search]") {
  Random random(1);
  const bool is_self = GENERATE(false, true);
  ContactParts parts(scattered_bricks(random), general_contact(is_self ? "self contact = on\n" : ""));
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  const double dt = 0.01;
  std::size_t n_found = 0;
  for (int step = 0; step < 20; ++step) {
    if (step > 0) fly(parts, random, dt);
    parts.move();
    parts.find_candidates(search, dt);
    const Pairs fast = in_set(parts.face_partners);
    // Faces face each other up to a cosine of -0.3, and may both turn by 0.08 before the next search.
    Pairs slow = sweep_faces(parts, dt);
    std::erase_if(slow, [&](const auto& pair) {
      return cosine_of(parts, pair.first, pair.second) > -0.3 + 0.16 + 0.0064 + 1e-5;
    });
    CHECK(fast == slow);
    n_found += fast.size();
  }
  CHECK(n_found > 400);
  CHECK(search.n_searches() == 20);
}

TEST_CASE("the candidates of nodes equal a sweep of all nodes and faces", "[contact][contact_search]") {
  Random random(1);
  ContactParts parts(scattered_bricks(random), general_contact("constraint formulation = node_face\n"));
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  const double dt = 0.01;
  std::size_t n_needed = 0;
  for (int step = 0; step < 20; ++step) {
    if (step > 0) fly(parts, random, dt);
    parts.move();
    parts.find_candidates(search, dt);
    const Pairs fast = in_set(parts.node_faces);
    CHECK(parts.face_partners.partners.empty());
    // Whatever is within the face's box alone must be there; what is there, within both margins.
    for (std::uint32_t row = 0; row < parts.contact_mesh.surface_nodes.size(); ++row) {
      const SurfaceNode& node = parts.contact_mesh.surface_nodes[{row}];
      Span exact;
      exact.add(parts.kinematics.x(node.node));
      exact.add(parts.kinematics.x(node.node) - dt * parts.kinematics.v(node.node));
      Span wide = exact;
      wide.low.array() -= 0.3;  // above every margin
      wide.high.array() += 0.3;
      for (std::uint32_t f = 0; f < parts.contact_mesh.faces.size(); ++f) {
        const bool is_own = node.surface == parts.contact_mesh.faces[{f}].surface;
        const Span face = span_of_face(parts, {f}, dt);
        const bool is_there = fast.count({row, f}) > 0;
        if (!is_own && face.meets(exact)) ++n_needed;
        if (is_there != (!is_own && face.meets(exact)) && !is_there) FAIL("a node and a face are lost");
        if (is_there && (is_own || !face.meets(wide))) FAIL("a node and a face are too many");
      }
    }
  }
  CHECK(n_needed > 100);
}

TEST_CASE("nothing gets past another in a step larger than the margin", "[contact][contact_search]") {
  // A small cube jumps through a plate, to far behind it, in one step.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 1}, .size = {4, 4, 0.1}});
  b.add_hexes({.id = 2, .origin = {1.7, 1.7, 1.0}, .size = {0.2, 0.2, 0.2}});
  for (const char* formulation : {"", "constraint formulation = node_face\n"}) {
    ContactParts parts(b, general_contact(formulation));
    ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
    parts.find_candidates(search, 0.1);
    CHECK(parts.face_partners.partners.empty());
    CHECK(parts.node_faces.partners.empty());
    for (Eigen::Index i = parts.x.cols() - 8; i < parts.x.cols(); ++i) {
      parts.x(2, i) -= 5.0;
      parts.v(2, i) = -50.0;
    }
    parts.move();
    CHECK(search.is_due(parts.kinematics));
    parts.find_candidates(search, 0.1);
    CHECK(parts.face_partners.partners.size() + parts.node_faces.partners.size() > 5);
  }
}

TEST_CASE("between two searches nothing can come to touch that is no candidate",
          "[contact][contact_search]") {
  // A cube comes down on a plate by small steps, not along an axis.
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 4, 1}, .size = {4, 4, 1}});
  b.add_hexes({.id = 2, .origin = {0.3, 0.3, 2.0}});
  ContactParts parts(b, general_contact());
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  const Vector3d way(0.011, 0.013, -0.017);
  int n_touching = 0;
  for (int step = 0; step < 100; ++step) {
    if (search.is_due(parts.kinematics)) parts.find_candidates(search, 1.0);
    const Pairs candidates = in_set(parts.face_partners);
    for (const auto& pair : sweep_faces(parts, 0.0)) {
      // Of faces that touch: sweep_faces also has those within the margins.
      const MovingFace a = parts.kinematics.face({pair.first}), c = parts.kinematics.face({pair.second});
      if (!(find_face_face_contact(a, c, {1.0, 0.0, 0.5, {}}, 0.0).force > 0.0)) continue;
      ++n_touching;
      if (candidates.count(pair) == 0) FAIL("faces touch that are no candidates");
    }
    for (Eigen::Index i = parts.x.cols() - 8; i < parts.x.cols(); ++i) {
      parts.x.col(i) += way;
      parts.v.col(i) = way;
    }
    parts.move();
  }
  CHECK(n_touching > 20);
  CHECK(search.n_searches() > 5);
  CHECK(search.n_searches() < 40);
}

TEST_CASE("what slides infinitesimally keeps its first partners", "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 1, 1}, .size = {4, 1, 1}});
  b.add_hexes({.id = 2, .origin = {0.1, 0, 1.0}});
  ContactParts parts(b, general_contact("interaction behavior = infinitesimal_sliding\n"));
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.find_candidates(search);
  const Pairs first = in_set(parts.face_partners);
  CHECK(!first.empty());
  for (Eigen::Index i = parts.x.cols() - 8; i < parts.x.cols(); ++i) parts.x(0, i) += 1.0;
  parts.move();
  parts.find_candidates(search);
  const Pairs later = in_set(parts.face_partners);
  CHECK(std::includes(first.begin(), first.end(), later.begin(), later.end()));
  CHECK(later.size() < sweep_faces(parts, 0.0).size());
}
