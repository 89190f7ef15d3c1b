// SPDX-License-Identifier: BSD-3-Clause
// SURFACE SMOOTHING and SMOOTHING = AUTO, as forces of rings of 16 in 24 facets.
#include <omp.h>

#include <numbers>

#include "contact/enforcement/contact_force.hpp"
#include "contact/mesh/smooth_surfaces.hpp"
#include "contact/overlap/overlap_removal.hpp"
#include "contact/overlap/start_overlaps.hpp"
#include "contact/surfaces/surface_tracker.hpp"
#include "support/catch.hpp"
#include "support/ring_mesh.hpp"
#include "support/stacked_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace contact_force_smoothing_test {

namespace {

constexpr double width = 0.2, interference = 1e-3, stiffness = 1e6;
const std::string smooth =
    "begin surface smoothing round\nsurface = inner outer\ncircumferential axis = 0 0 0 0 0 1\nend\n";
const std::string stiff = "penalty stiffness = 1e6\n";

MeshBuilder rings(double turn = 0.0, double more = interference) {
  MeshBuilder b;
  add_ring(b, {1, "inner", 16, 0.8, 1.0 + more, turn, width});
  add_ring(b, {2, "outer", 24, 1.0, 1.2, 0.0, width});
  return b;
}

std::string smoothed(const std::string& more, const std::string& which = "round") {
  return smooth + general_contact("smoothing = " + which + "\n" + more);
}

double area_of(const ContactForce& contact) {
  double area = 0.0;
  for (const ContactPoint& point : contact.points()) area += point.area;
  return area;
}

/// Moment of the forces on a block about z.
double moment_about_axis(const ContactBodies& bodies, std::size_t block) {
  double sum = 0.0;
  std::vector<std::uint8_t> is_of_block(bodies.mesh.n_nodes(), 0);
  const ElementBlock& of = bodies.mesh.blocks()[block];
  for (std::uint32_t e = 0; e < of.n_elements; ++e) {
    for (const NodeIndex node : of.element_nodes(e)) is_of_block[node.value] = 1;
  }
  for (Eigen::Index i = 0; i < bodies.x.cols(); ++i) {
    if (is_of_block[static_cast<std::size_t>(i)] != 0)
      sum += Vector3d(bodies.x.col(i)).cross(Vector3d(bodies.forces.col(i))).z();
  }
  return sum;
}

}  // namespace

TEST_CASE("smoothed rings press on each other evenly, at any angle", "[contact][contact_force][smoothing]") {
  const double turn = GENERATE(0.0, 0.05, 0.13, 0.21);
  const std::string which = GENERATE("round", "auto");
  ContactBodies bodies(rings(turn), smoothed(stiff + formulation(), which));
  bodies.ask();
  for (const ContactPoint& point : bodies.contact.points()) {
    CHECK(point.force / point.area == Approx(stiffness * interference).epsilon(0.01));
    CHECK(point.gap == Approx(-interference).epsilon(0.01));
  }
  CHECK(area_of(bodies.contact) == Approx(2.0 * std::numbers::pi * width).epsilon(0.01));
  CHECK(std::abs(moment_about_axis(bodies, 0)) < 1e-3 * stiffness * interference);
  CHECK(bodies.net_force().norm() < 1e-9);
  CHECK(bodies.net_moment().norm() < 1e-9);
}

TEST_CASE("without smoothing facets press where corners are", "[contact][contact_force][smoothing]") {
  ContactBodies bodies(rings(), general_contact(stiff));
  bodies.ask();
  CHECK(area_of(bodies.contact) < 0.3 * 2.0 * std::numbers::pi * width);
}

TEST_CASE("round surfaces turn along with their bodies", "[contact][contact_force][smoothing]") {
  ContactBodies bodies(rings(), smoothed(stiff + formulation()));
  bodies.ask();
  // Both about an axis askew, in one step; then the inner one in the outer.
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(1.0, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
  bodies.x = turned * bodies.x;
  bodies.step(1.0);
  CHECK(area_of(bodies.contact) == Approx(2.0 * std::numbers::pi * width).epsilon(0.01));
  for (const ContactPoint& point : bodies.contact.points())
    CHECK(point.gap == Approx(-interference).epsilon(0.01));
  CHECK(bodies.net_force().norm() < 1e-9);
  CHECK(bodies.net_moment().norm() < 1e-9);
}

TEST_CASE("what is left of a ring after a death is as round as before",
          "[contact][contact_force][smoothing]") {
  const std::string which = GENERATE("round", "auto");
  ContactBodies bodies(rings(), smoothed(stiff + formulation(), which));
  bodies.ask();
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(1.0, Vector3d(1, 2, 2).normalized()).toRotationMatrix();
  bodies.x = turned * bodies.x;
  bodies.step(1.0);
  const NodeElements elements(bodies.mesh);
  const FaceGroups faces(bodies.mesh, elements);
  Diagnostics diagnostics;
  OwnershipRules rules(make_surface_requests(*bodies.region.contact, {}, bodies.mesh, diagnostics),
                       bodies.mesh, {});
  SurfaceTracker living(std::move(rules), faces, std::vector<std::uint8_t>(bodies.mesh.n_elements(), 0));
  const std::vector<ElementIndex> dead{ElementIndex{3}};
  living.update_for_deaths(dead, bodies.definition.surfaces);
  bodies.contact.rebuild_surfaces(bodies.motion(), {});
  bodies.step(1.0);
  CHECK(area_of(bodies.contact) == Approx(15.0 / 16.0 * 2.0 * std::numbers::pi * width).epsilon(0.02));
  for (const ContactPoint& point : bodies.contact.points())
    CHECK(point.gap == Approx(-interference).epsilon(0.01));
  CHECK(bodies.net_force().norm() < 1e-9);
  CHECK(bodies.net_moment().norm() < 1e-9);
}

TEST_CASE("any number of threads gives smoothed contact the same bits",
          "[contact][contact_force][smoothing]") {
  const std::string form = formulation();
  const int before = omp_get_max_threads();
  std::vector<Eigen::Matrix3Xd> forces;
  for (const int n_threads : {1, 2, 3}) {
    omp_set_num_threads(n_threads);
    ContactBodies bodies(rings(0.07), smoothed(stiff + form, "auto"));
    bodies.ask();
    forces.push_back(bodies.forces);
  }
  omp_set_num_threads(before);
  CHECK(forces[0] == forces[1]);
  CHECK(forces[0] == forces[2]);
}

TEST_CASE("momentum balance of smoothed rings has their gap and no moment",
          "[contact][contact_force][smoothing]") {
  ContactBodies bodies(rings(0.05), smoothed(formulation()));
  State state = make_state(bodies.x, bodies.model.blocks, 0.0);
  state.dt = state.next_dt = 1e-3;
  state.velocity = state.acceleration = Eigen::Matrix3Xd::Zero(3, bodies.x.cols());
  bodies.ask();
  bodies.contact.balance(state, bodies.forces);
  for (const ContactPoint& point : bodies.contact.points())
    CHECK(point.gap == Approx(-interference).epsilon(0.01));
  CHECK(area_of(bodies.contact) == Approx(2.0 * std::numbers::pi * width).epsilon(0.01));
  CHECK(bodies.force_size() > 0.0);
  CHECK(std::abs(moment_about_axis(bodies, 0)) < 1e-4 * bodies.force_size());
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
  CHECK(bodies.net_moment().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("a pressure law presses smoothed rings by their round gap", "[contact][contact_force][smoothing]") {
  const std::string model =
      "end\nbegin exponential pressure model soft\npressure at zero gap = 300\n"
      "clearance at zero pressure = 0.01\n";
  ContactBodies bodies(rings(0.05, 0.0), smoothed("friction model = soft\n" + formulation() + model));
  bodies.ask();
  double force = 0.0;
  for (const ContactPoint& point : bodies.contact.points()) {
    CHECK(point.force / point.area == Approx(300.0).epsilon(0.02));
    force += point.force;
  }
  CHECK(force == Approx(300.0 * 2.0 * std::numbers::pi * width).epsilon(0.01));
  CHECK(bodies.contact.points()[0].stiffness < 10.0 * 300.0 / 0.01 * bodies.contact.points()[0].area);
  CHECK(bodies.net_force().norm() < 1e-9);
  CHECK(bodies.net_moment().norm() < 1e-9);
}

TEST_CASE("round surfaces are found anew where closing gaps has moved their nodes",
          "[contact][contact_force][smoothing]") {
  const std::string lines = general_contact("smoothing = auto\ngap closure tolerance = 0.02\n");
  const Mesh apart = rings(0.05, -0.01).build();
  Modelled model = make_model(apart, lines);
  CHECK(model.messages == "");
  const auto radius_of = [&](std::uint32_t surface) {
    double radius = 0.0;  // of the fit that is nearest the joint
    for (const FittedShape& fit : model.smoothings.at(0).surfaces[SurfaceIndex{surface}].fitted) {
      if (std::abs(fit.radius - 1.0) < 0.05) radius = fit.radius;
    }
    return radius;
  };
  CHECK(radius_of(0) == Approx(0.99));
  CHECK(radius_of(1) == Approx(1.0));
  OverlapRemoved moved = remove_overlap(model, apart, parse_contact(lines), {});
  refit_smoothings(apart.with_coordinates(std::move(moved.coordinates)), model);
  CHECK(radius_of(0) == Approx(radius_of(1)).epsilon(1e-3));
  CHECK(radius_of(0) > 0.992);
}

TEST_CASE("rings that overlap by their facets alone do not overlap at the start",
          "[contact][contact_force][smoothing]") {
  const double more = GENERATE(-1e-3, interference);
  const Mesh mesh = rings(0.05, more).build();
  const std::string lines = smoothed(formulation());
  const Modelled model = make_model(mesh, lines);
  CHECK(model.messages == "");
  const auto overlaps = find_start_overlaps(model, mesh, parse_contact(lines));
  if (more < 0.0) {
    CHECK(overlaps.empty());
  } else {
    REQUIRE(overlaps.size() == 1);
    CHECK(overlaps[0].deepest == Approx(interference).epsilon(1e-6));
    CHECK(overlaps[0].n_deep == 0);
  }
  const Modelled faceted = make_model(mesh, general_contact());
  CHECK_FALSE(find_start_overlaps(faceted, mesh, parse_contact(general_contact())).empty());
}

}  // namespace contact_force_smoothing_test
