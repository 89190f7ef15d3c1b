// SPDX-License-Identifier: BSD-3-Clause
#include <omp.h>

#include <mutex>

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Two plates of 60 x 60 faces that slide on each other with friction and damping.
struct SlidingPlates : ContactBodies {
  explicit SlidingPlates(const std::string& formulation, Ranks& ranks = one_rank())
      : ContactBodies(
            make(),
            general_contact("penalty stiffness = 1000\ncontact damping fraction = 0.1\n" + formulation +
                            "friction model = rough\nend\nbegin constant friction model rough\n"
                            "friction coefficient = 0.3\n"),
            "", {}, ranks) {
    Random random(1);
    for (Eigen::Index i = 0; i < x.cols(); ++i) x.col(i) += random_vector(random, 0.05);
    ask();
    set_velocity(1, {0.06, 0.03, -0.005});
  }
  static MeshBuilder make() {
    MeshBuilder b;
    b.add_hexes({.id = 1, .cells = {60, 60, 1}, .size = {60, 60, 1}});
    return b.add_hexes(
        {.id = 2, .cells = {55, 55, 1}, .origin = {2, 2, 1}, .size = {53, 53, 1}, .share_nodes = false});
  }
};

}  // namespace

TEST_CASE("forces of contact have the same bits with one thread and with two", "[contact][contact_force]") {
  const std::string formulation =
      GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const int before = omp_get_max_threads();
  std::vector<Eigen::Matrix3Xd> found;
  std::vector<double> works;
  for (const int n_threads : {1, 2}) {
    omp_set_num_threads(n_threads);
    SlidingPlates bodies(formulation);
    for (int step = 0; step < 6; ++step) works.push_back(bodies.step(1.0).friction_work);
    found.push_back(bodies.forces);
    CHECK(bodies.contact.search().n_searches() > 1);
  }
  omp_set_num_threads(before);
  CHECK(found[0].norm() > 100.0);
  CHECK(found[0] == found[1]);
  CHECK(std::equal(works.begin(), works.begin() + 6, works.begin() + 6));
}

TEST_CASE("forces of contact have the same bits on every rank as on one alone", "[contact][contact_force]") {
  const std::string formulation =
      GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const int n_ranks = GENERATE(2, 3);
  SlidingPlates alone(formulation);
  double work = 0.0;
  for (int step = 0; step < 6; ++step) work = alone.step(1.0).friction_work;
  REQUIRE(alone.contact.search().n_searches() > 1);
  std::mutex checking;
  ThreadRanks(n_ranks).run([&](Ranks& ranks) {
    omp_set_num_threads(1);
    SlidingPlates together(formulation, ranks);
    double work_together = 0.0;
    for (int step = 0; step < 6; ++step) work_together = together.step(1.0).friction_work;
    const std::lock_guard lock(checking);
    CHECK(together.forces == alone.forces);
    CHECK(work_together == work);
    CHECK(together.contact.search().bytes() == alone.contact.search().bytes());
    CHECK(together.contact.search().face_counts().visits == alone.contact.search().face_counts().visits);
  });
}

TEST_CASE("looking at the contact points between steps changes no bit", "[contact][contact_force]") {
  const std::string formulation =
      GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  SlidingPlates quiet(formulation), watched(formulation);
  for (int step = 0; step < 6; ++step) {
    const ForceReport one = quiet.step(1.0), other = watched.step(1.0);
    CHECK(quiet.forces == watched.forces);
    CHECK(one.friction_work == other.friction_work);
    CHECK(one.stable_step == other.stable_step);
    CHECK(watched.contact.points().size() > 1000);
  }
}
