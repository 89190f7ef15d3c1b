// SPDX-License-Identifier: BSD-3-Clause
// The overlaps of faces in a load step: what they count as, what presses them, and what their nodes feel.
#include <cmath>

#include "contact/formulations/face_face/face_face_contacts.hpp"
#include "support/catch.hpp"
#include "support/contact_faces.hpp"
#include "support/cube_on_plate.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// A cube over a plate, both 1 thick, in a load step; the cube's nodes weigh the gaps.
struct WeighedCubeOnPlate : CubeOnPlate {
  explicit WeighedCubeOnPlate(const std::string& lines = "", bool cube_first = false)
      : CubeOnPlate(lines, cube_first), gaps(IndexedVector<PairIndex, SurfaceIndex>{SurfaceIndex{cube}}) {}

  WeightedGaps gaps;
  ContactMultipliers multipliers;
  HeldSlips held;

  ContactStepContext load_step() {
    ContactStepContext made = context(1.0);
    made.is_static = true;
    made.weighted_gaps = &gaps;
    made.multipliers = &multipliers;
    made.held_slips = &held;
    return made;
  }
  std::vector<WeightedOverlap> weigh() {
    std::vector<WeightedOverlap> overlaps;
    contacts.begin_step();
    contacts.weigh(load_step(), {0, contacts.n_rows()}, overlaps);
    gaps.clear();
    for (const WeightedOverlap& overlap : overlaps) gaps.add(contact_mesh, overlap);
    gaps.find_tractions(load_step());
    return overlaps;
  }
  std::vector<ContactPoint> pressed() {
    weigh();
    std::vector<ContactPoint> points;
    contacts.detect(load_step(), {0, contacts.n_rows()}, points);
    return points;
  }
  /// Turns the cube about an axis along y through the middle of its bottom.
  void turn_cube(double angle) {
    const Vector3d middle(0.45, 1.35, 1.0);
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitY()).matrix();
    for (const NodeIndex node : mesh.blocks()[cube].nodes)
      x.col(node.value) = middle + turn * (mesh.coordinates().col(node.value) - middle);
    move();
  }
  FaceIndex bottom() const {
    for (const FaceIndex i : indices(contact_mesh.faces)) {
      const ContactFace& face = contact_mesh.faces[i];
      if (face.surface == SurfaceIndex{cube} && face.side == face_below) return i;
    }
    throw std::logic_error("there is no bottom");
  }
  ElementSide face_below =
      contact_mesh.faces[face_of(*this, mesh.blocks()[cube].first_element.value, -Vector3d::UnitZ())].side;
};

const std::string rough_load_step =
    "friction model = rough\nend\nbegin constant friction model rough\nfriction coefficient = 0.5\n";

}  // namespace

TEST_CASE("what of an overlap is open counts as half as wide, and bears less the wider it is",
          "[contact][face_face_weighted]") {
  const bool cube_first = GENERATE(false, true);
  // Of the gap g, of what counts as open w = 0.1 of the thickness: g - g^2 / 2w and 1 - g / w.
  struct Expected {
    double gap, counted, slope, weight;
  };
  const Expected expected = GENERATE(Expected{-0.01, -0.01, 1.0, 1.0}, Expected{0.02, 0.018, 0.8, 1.0},
                                     Expected{0.2, 0.05, 0.0, 1.0}, Expected{0.75, 0.05, 0.0, 0.5});
  WeighedCubeOnPlate parts("normal tolerance = 1\n", cube_first);
  parts.move_cube({0, 0, expected.gap}, false);
  parts.renew_candidates();
  const auto overlaps = parts.weigh();
  CAPTURE(expected.gap, cube_first);
  REQUIRE(overlaps.size() == 1);
  const WeightedOverlap& overlap = overlaps[0];
  CHECK(overlap.is_of_first == cube_first);
  CHECK((overlap.is_of_first ? overlap.first : overlap.second) == parts.bottom());
  CHECK(overlap.weight == Approx(expected.weight));
  REQUIRE(overlap.shares.n == 4);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK(overlap.shares.corners[k].area == Approx(0.0625));
    CHECK(overlap.gaps[k] == Approx(expected.counted));
    CHECK(overlap.slopes[k] == Approx(expected.slope).margin(1e-12));
  }
}

TEST_CASE("faces that lean count less, and nothing where they stand beside each other",
          "[contact][face_face_weighted]") {
  // A quarter up to a cosine of -0.35, the rest by 3 s^2 - 2 s^3 on the way from there to -0.8.
  const double cosine = GENERATE(0.9, 0.6, 0.35, 0.32, 0.25);
  const double way = (cosine - 0.35) / 0.45, faint = (cosine - 0.3) / 0.05;
  const auto rise = [](double s) { return s <= 0.0 ? 0.0 : s >= 1.0 ? 1.0 : 3.0 * s * s - 2.0 * s * s * s; };
  WeighedCubeOnPlate parts("normal tolerance = 1\n");
  parts.turn_cube(std::acos(cosine));
  parts.renew_candidates();
  double weight = 0.0;
  for (const WeightedOverlap& overlap : parts.weigh()) {
    if (overlap.second == parts.bottom()) weight = overlap.weight;
  }
  CAPTURE(cosine);
  CHECK(weight == Approx(0.25 * rise(faint) + 0.75 * rise(way)).margin(1e-9));
}

TEST_CASE("nodes press by their depth on all of their overlaps", "[contact][face_face_weighted]") {
  const bool cube_first = GENERATE(false, true);
  WeighedCubeOnPlate parts("", cube_first);
  parts.move_cube({0.55, 0, -0.01}, false);  // over two cells
  parts.renew_candidates();
  const auto points = parts.pressed();
  CHECK(points.size() > 4);
  CHECK((parts.force_on_cube(points) - Vector3d(0, 0, 1000.0 * 0.25 * 0.01)).norm() < 1e-12);
  double stiffness_sum = 0.0;
  for (const ContactPoint& point : points) {
    CHECK(point.gap == Approx(-0.01));
    CHECK(point.first_entity < point.second_entity);
    stiffness_sum += point.stiffness;
  }
  CHECK(stiffness_sum == Approx(250.0));
  // Without a load step's gaps each point presses for itself; a wide gap presses nothing.
  parts.move_cube({0, 0, 0.06}, false);
  CHECK(parts.pressed().empty());
}

TEST_CASE("the slip of an overlap is that of the side whose nodes weigh it",
          "[contact][face_face_weighted]") {
  const bool cube_first = GENERATE(false, true);
  WeighedCubeOnPlate parts(rough_load_step, cube_first);
  parts.move_cube({0, 0, -0.01}, false);
  parts.move_cube({0.001, 0, 0});
  const auto overlaps = parts.weigh();
  REQUIRE(overlaps.size() == 1);
  for (std::size_t k = 0; k < 4; ++k) {
    CHECK((overlaps[0].slips[k] - Vector3d(0.001, 0, 0)).norm() < 1e-15);
    CHECK(overlaps[0].held_slips[k].isZero(0.0));
  }
  // The plate holds it back.
  CHECK(parts.force_on_cube(parts.pressed()).z() == Approx(2.5));
  Vector3d drag = Vector3d::Zero();
  for (const ContactPoint& point : parts.pressed()) drag += point.tangential;
  CHECK((cube_first ? 1.0 : -1.0) * drag.x() < 0.0);
  CHECK(std::abs(drag.y()) < 1e-12);
}

TEST_CASE("what a node's motion opens is the derivative of the weighted gaps",
          "[contact][face_face_weighted]") {
  const bool cube_first = GENERATE(false, true);
  WeighedCubeOnPlate parts("", cube_first);
  parts.move_cube({0.55, 0, -1e-6}, false);  // hardly deep: normals and areas that change do not matter
  parts.renew_candidates();
  parts.weigh();
  const auto motions = parts.contacts.node_motions(parts.load_step());
  const auto gap_of = [&](SurfaceNodeIndex row) {
    for (const WeightedNode& node : parts.gaps.nodes()) {
      if (node.row == row) return node.gap;
    }
    throw std::logic_error("no such node");
  };
  const double small = 1e-5;
  REQUIRE(parts.gaps.nodes().size() == 4);
  CHECK(motions.size() >= 4 * 5);
  for (const auto& motion : motions) {
    const SurfaceNodeIndex row = parts.gaps.nodes()[motion.number].row;
    const double before = gap_of(row);
    const std::uint32_t mesh_node = parts.contact_mesh.mesh_nodes[motion.node].value;
    const bool is_of_cube = parts.x(2, mesh_node) < 1.0 - 5e-7;
    const double inward = is_of_cube ? -small : small;
    parts.x(2, mesh_node) += inward;
    parts.move();
    parts.weigh();
    CHECK((gap_of(row) - before) / inward == Approx(motion.opens.z()).epsilon(1e-3).margin(1e-6));
    CHECK(motion.opens.head<2>().norm() < 1e-12);
    CHECK(motion.slips == 0.0);
    parts.x(2, mesh_node) -= inward;
    parts.move();
    parts.weigh();
  }
}
