// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/node_face/node_reach.hpp"

#include <algorithm>
#include <cmath>

#include "contact/formulations/contact_point_law.hpp"
#include "contact/formulations/near_pairs.hpp"
#include "contact/geometry/node_face.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A slab of 3 x 3 cells, its nodes moved at random, and a cube, of which the first node is looked at.
struct CubeOverSlab : ContactParts {
  explicit CubeOverSlab(const std::string& lines = "")
      : ContactParts(make(), general_contact("constraint formulation = node_face\n" + lines)), start(x) {}
  static MeshBuilder make() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
    b.add_hexes({.id = 2, .origin = {1, 1, 1.5}, .share_nodes = false});
    return b;
  }
  void throw_at_random(Random& random, double warp, double far) {
    const Eigen::Matrix3d turn = random_rotation(random);
    for (Eigen::Index i = 0; i < x.cols(); ++i) {
      x.col(i) = start.col(i) + random_vector(random, warp);
      v.col(i) = random_vector(random, 0.3);
    }
    const Eigen::Index first = x.cols() - 8;
    x.rightCols(8).colwise() += Vector3d(uniform(random, -1.5, 1.5), uniform(random, -1.5, 1.5),
                                         1.0 - x(2, first) + uniform(random, -0.3, 0.3));
    x = (turn * x).eval();
    v = (turn * v).eval();
    x.colwise() += far * Vector3d(1, -2, 3);
    move();
  }
  /// The surface node of the second block's first node.
  SurfaceNodeIndex row() const {
    const auto node = static_cast<std::uint32_t>(x.cols() - 8);
    for (const SurfaceNodeIndex i : indices(contact_mesh.surface_nodes)) {
      if (contact_mesh.mesh_nodes[contact_mesh.surface_nodes[i].node].value == node) return i;
    }
    FAIL("the node has no row");
    return {};
  }

  Eigen::Matrix3Xd start;
};

/// Whether a node may count for a face, by its exact projection.
bool may_count(const CubeOverSlab& parts, const ContactStepContext& context, FaceIndex index, bool is_known) {
  const ContactFace& face = parts.contact_mesh.faces[index];
  const SurfaceNode& node = parts.contact_mesh.surface_nodes[parts.row()];
  const MovingFace moving = parts.kinematics.face(index);
  const auto point = project_onto_face(moving.x, moving.is_triangle, parts.kinematics.x(node.node));
  const FaceBound& bound = parts.kinematics.bound(index);
  if (!point || point->beyond > automatic_beyond * bound.radius()) return false;
  const Eigen::VectorXd closing =
      (moving.v.colwise() - parts.kinematics.v(node.node)).transpose() * point->normal;
  const double soonest = std::max(0.0, closing.maxCoeff());
  const double reach = std::max({context.dt > 0.0 ? 0.0 : double(bound.radius()), soonest * context.ahead()});
  if (point->gap > reach) return false;
  const double shallow = context.dt > 0.0 && !is_known
                             ? shallow_depth * node.penalty_properties.thickness + soonest * context.dt
                             : face.penalty_properties.thickness;
  return -point->gap < shallow;
}

}  // namespace

TEST_CASE("no face that a node may touch is out of its reach, and most others are", "[contact][node_face]") {
  const double warp = GENERATE(0.0, 0.002, 0.1), far = GENERATE(0.0, 1e4), dt = GENERATE(0.0, 0.05);
  const bool is_known = GENERATE(false, true);
  Random random(3);
  CubeOverSlab parts;
  int n_all = 0, n_may = 0, n_count = 0;
  for (int i = 0; i < 300; ++i) {
    parts.throw_at_random(random, warp, far);
    ContactStepContext context = parts.context(dt);
    context.first_dt = 0.05;
    ReachBounds bounds;
    bounds.update(context);
    NodeReach::Faces faces;
    std::vector<FaceIndex> of_slab;
    for (const FaceIndex face : indices(parts.contact_mesh.faces)) {
      if (parts.contact_mesh.faces[face].surface == SurfaceIndex{0}) of_slab.push_back(face);
    }
    REQUIRE(of_slab.size() == 30);
    const NodeReach reach(context, bounds, parts.row(), {0}, is_known);
    for (std::size_t begin = 0; begin < of_slab.size(); begin += n_float_lanes) {
      faces.clear();
      const std::size_t n = std::min(n_float_lanes, of_slab.size() - begin);
      for (std::size_t k = 0; k < n; ++k) faces.add(of_slab[begin + k]);
      const std::uint32_t in_reach = reach.find(bounds, faces);
      CHECK(in_reach >> n == 0);
      for (std::size_t k = 0; k < n; ++k) {
        const bool may = (in_reach >> k & 1) != 0,
                   counts = may_count(parts, context, faces.face(k), is_known);
        if (counts && !may) FAIL("a face that counts is left out");
        n_may += may ? 1 : 0;
        n_count += counts ? 1 : 0;
        ++n_all;
      }
    }
  }
  CHECK(n_count >= 10);
  if (!is_known) CHECK(n_may < n_all / 3);
}

TEST_CASE("tolerances of a pair widen what is in reach", "[contact][node_face]") {
  const auto limits_of = [](const std::string& lines) {
    CubeOverSlab parts(lines);
    parts.move();
    const ContactStepContext context = parts.context(0.0);
    ReachBounds bounds;
    bounds.update(context);
    NodeReach::Faces faces;
    for (const FaceIndex face : indices(parts.contact_mesh.faces)) {
      if (parts.contact_mesh.faces[face].surface == SurfaceIndex{0} && !faces.are_full()) faces.add(face);
    }
    const NodeReach reach(context, bounds, parts.row(), {0}, false);
    reach.find(bounds, faces);
    return faces.limits(0);
  };
  const auto plain = limits_of(""), wide = limits_of("normal tolerance = 4.0\ntangential tolerance = 0.5\n");
  CHECK(wide.below == Approx(4.0).epsilon(1e-4));
  CHECK(plain.below < 2.0);
  // The faces of the slab are squares of edge 1.
  CHECK(wide.beyond - plain.beyond == Approx(0.5 - automatic_beyond * std::sqrt(0.5)).epsilon(1e-3));
}
