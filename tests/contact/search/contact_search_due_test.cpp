// SPDX-License-Identifier: BSD-3-Clause
#include <omp.h>

#include <limits>

#include "contact/search/contact_search.hpp"
#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/random_faces.hpp"

using namespace contactsim;
using namespace contactsim::test;

TEST_CASE("a search is due when a node has moved by the margin of its smallest face",
          "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {0, 0, 5}});
  ContactParts parts(b, general_contact());
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  CHECK(search.is_due(parts.kinematics));
  parts.find_candidates(search);
  CHECK(!search.is_due(parts.kinematics));
  // The margin of a corner is 0.15 times the root of its area, 3/4; the body at rest leaves all of its own.
  parts.x(0, 3) += 0.24;
  parts.move();
  CHECK(!search.is_due(parts.kinematics));
  parts.x(0, 3) += 0.03;
  parts.move();
  CHECK(search.is_due(parts.kinematics));
  SearchOptions once;
  once.global_search_once = true;
  ContactSearch lazy(parts.contact_mesh, parts.mesh, parts.rules, once, {});
  parts.find_candidates(lazy);
  parts.x(0, 3) += 10.0;
  parts.move();
  CHECK(!lazy.is_due(parts.kinematics));
}

TEST_CASE("large faces may not use up the margins of small ones", "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .cells = {10, 10, 10}, .origin = {0, 0, 5}});
  ContactParts parts(b, general_contact());
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.find_candidates(search);
  // 0.13 of their own and 0.013 of the others.
  parts.x(0, 3) += 0.15;
  parts.move();
  CHECK(search.is_due(parts.kinematics));
}

TEST_CASE("a search is due when it would be if it had not been asked before", "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {3, 3, 1}, .size = {3, 3, 1}});
  b.add_hexes(
      {.id = 2, .cells = {2, 2, 2}, .origin = {0.5, 0.4, 1.05}, .size = {1, 1, 1}, .share_nodes = false});
  const double warp = GENERATE(0.0, 0.002), turn = GENERATE(0.0, 0.004), way = GENERATE(0.0, 0.003);
  ContactParts parts(b, general_contact());
  const Eigen::Matrix3Xd start = parts.x;
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.find_candidates(search);
  Random random(3);
  bool was_due = false;
  for (int step = 0; step < 60 && !was_due; ++step) {
    auto cube = parts.x.rightCols(27);
    cube = (Eigen::AngleAxisd(turn, Eigen::Vector3d(1, 2, 2).normalized()).toRotationMatrix() * cube).eval();
    cube.row(0).array() += way;
    for (Eigen::Index i = 0; i < cube.cols(); ++i) cube.col(i) += random_vector(random, warp);
    parts.move();
    was_due = search.is_due(parts.kinematics);
    const Eigen::Matrix3Xd now = parts.x;
    parts.x = start;
    parts.move();
    ContactSearch fresh(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
    parts.find_candidates(fresh);
    parts.x = now;
    parts.move();
    REQUIRE(was_due == fresh.is_due(parts.kinematics));
  }
  CHECK(was_due == (turn > 0.0 || way > 0.0));
}

TEST_CASE("a search finds the same with one thread and with two", "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {40, 40, 1}, .size = {40, 40, 1}});
  b.add_hexes({.id = 2, .cells = {40, 40, 1}, .origin = {0.3, 0.2, 1.0}, .size = {40, 40, 1}});
  std::vector<std::vector<std::uint32_t>> found;
  const int before = omp_get_max_threads();
  for (const int n_threads : {1, 2}) {
    omp_set_num_threads(n_threads);
    ContactParts parts(b, general_contact());
    parts.search();
    found.push_back(parts.face_partners.partners);
  }
  omp_set_num_threads(before);
  CHECK(found[0] == found[1]);
  CHECK(found[0].size() > 6000);
}

TEST_CASE("a node that is nowhere is named", "[contact][contact_search]") {
  MeshBuilder b;
  b.add_hexes({.id = 1});
  b.add_hexes({.id = 2, .origin = {0, 0, 5}});
  b.set_node_ids({11, 12, 13, 14, 15, 16, 17, 18, 21, 22, 23, 24, 25, 26, 27, 28});
  ContactParts parts(b, general_contact());
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, {});
  parts.x(1, 10) = std::numeric_limits<double>::quiet_NaN();
  parts.move();
  CHECK_THROWS_WITH(parts.find_candidates(search), Catch::Matchers::Contains("node 23"));
}
