// SPDX-License-Identifier: BSD-3-Clause
#include "contact/formulations/near_pairs.hpp"

#include "support/catch.hpp"
#include "support/random_faces.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using Eigen::Vector3d;
using test::ContactParts;
using test::make_square;

namespace {

/// Two unit cubes with a gap, whose surfaces are tied by nodes of the upper one.
struct TiedCubes : ContactParts {
  TiedCubes(double gap, double aside, const std::string& more = "")
      : ContactParts(test::stacked_cubes(gap, 1, aside),
                     "skin all blocks = on\nbegin interaction\nside a = block_1\nside b = block_2\n"
                     "friction model = tied\n" +
                         test::node_face + more + "end\n") {
    search();
  }
  std::vector<NearPair> find(double size_share) const {
    return find_near_pairs(context(), face_partners, node_faces, size_share,
                           [](const PairRule&) { return true; });
  }
};

}  // namespace

TEST_CASE("a capture tolerance comes before a normal tolerance, and both before a share of the size",
          "[contact][near_pairs]") {
  const TiedCubes cubes(0.0, 0.0);
  const FaceBound& bound = cubes.kinematics.bound({0});
  SurfacePair pair;
  // A unit square's radius is half of its diagonal, and root 2 times that its edge.
  CHECK(capture_tolerance_of(pair, bound, 0.05) == Approx(0.05).epsilon(1e-5));
  pair.normal_tolerance = 0.3;
  CHECK(capture_tolerance_of(pair, bound, 0.05) == 0.3);
  pair.capture_tolerance = 0.0;
  CHECK(capture_tolerance_of(pair, bound, 0.05) == 0.0);
}

TEST_CASE("nodes within the tolerance of a face are held, each to the nearest", "[contact][near_pairs]") {
  const TiedCubes cubes(0.04, 0.0);
  const auto near = cubes.find(0.05);
  REQUIRE(near.size() == 4);
  for (const NearPair& pair : near) {
    CHECK(pair.is_node);
    CHECK(pair.is_facing);
    CHECK(pair.share == 1.0);  // one way: sides are given
    const ContactFace& face = cubes.contact_mesh.faces[pair.second];
    CHECK(cubes.kinematics.area(face).normalized().isApprox(Vector3d::UnitZ()));
    CHECK(cubes.contact_mesh.surface_nodes[pair.row()].surface == SurfaceIndex{1});
  }
  CHECK(TiedCubes(0.06, 0.0).find(0.05).empty());
  CHECK(TiedCubes(0.06, 0.0, "capture tolerance = 0.07\n").find(0.05).size() == 4);
}

TEST_CASE("nodes beside a face are held by a twentieth of its radius, and no farther",
          "[contact][near_pairs]") {
  // The radius of a unit square is 0.707: 0.05 of it is 0.035. The side of the lower cube is beyond 0.02.
  CHECK(TiedCubes(0.0, 0.03).find(0.02).size() == 4);
  CHECK(TiedCubes(0.0, 0.04).find(0.02).size() == 2);
}

TEST_CASE("a node that is beside the face below may be held by the side of the body",
          "[contact][near_pairs]") {
  const TiedCubes cubes(0.0, 0.04);
  const auto near = cubes.find(0.05);
  REQUIRE(near.size() == 4);
  int n_on_side = 0;
  for (const NearPair& pair : near) {
    const Vector3d normal = cubes.kinematics.area(cubes.contact_mesh.faces[pair.second]).normalized();
    n_on_side += normal.x() > 0.9 ? 1 : 0;
  }
  CHECK(n_on_side == 2);
}

TEST_CASE("nothing is near that no rule holds", "[contact][near_pairs]") {
  const TiedCubes cubes(0.0, 0.0);
  CHECK(find_near_pairs(cubes.context(), cubes.face_partners, cubes.node_faces, 0.05, [](const PairRule&) {
          return false;
        }).empty());
}

TEST_CASE("the mean of an overlap by hand", "[contact][near_pairs]") {
  // The upper square lies over the right half of the lower one: the middle of what they share is (0.75, 0.5).
  const auto mean = find_mean_overlap(make_square(0, 0, true), make_square(0.5, 0.01, false), 0.02);
  REQUIRE(mean);
  CHECK(mean->area == Approx(0.5));
  CHECK(mean->weights_1.isApprox(Eigen::Vector4d(0.125, 0.375, 0.375, 0.125)));
  // Of the upper one, whose corners are (0.5, 0), (0.5, 1), (1.5, 1), (1.5, 0), it is a quarter along x.
  CHECK(mean->weights_2.isApprox(Eigen::Vector4d(0.375, 0.375, 0.125, 0.125)));
}

TEST_CASE("an overlap counts where its gap is within the tolerance either way", "[contact][near_pairs]") {
  CHECK(find_mean_overlap(make_square(0, 0, true), make_square(0, -0.01, false), 0.02));
  CHECK_FALSE(find_mean_overlap(make_square(0, 0, true), make_square(0, 0.03, false), 0.02));
  CHECK_FALSE(find_mean_overlap(make_square(0, 0, true), make_square(0, -0.03, false), 0.02));
  CHECK_FALSE(find_mean_overlap(make_square(0, 0, true), make_square(1.5, 0, false), 0.02));
}
