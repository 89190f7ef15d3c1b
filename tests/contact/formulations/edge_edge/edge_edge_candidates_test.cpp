// SPDX-License-Identifier: BSD-3-Clause
// The candidates of edges, and what is remembered of them from search to search, over deaths and restarts.
#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "contact/search/contact_search.hpp"
#include "core/base/state_archive.hpp"
#include "support/catch.hpp"
#include "support/contact_death.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string stiff_edges = general_contact("penalty stiffness = 1000\n");
const std::string rough_edges = general_contact(
    "penalty stiffness = 1000\nfriction model = rough\nend\n"
    "begin constant friction model rough\nfriction coefficient = 0.5\n");

/// Edges of bodies whose strips are 0.2 wide, of elements 0.5 thick.
struct EdgeBodies : ContactParts {
  EdgeBodies(const MeshBuilder& builder, const std::string& lines)
      : ContactParts(builder, lines),
        edges((choose_edges(), setup())),
        contact_search(contact_mesh, mesh, rules, {}, {}) {}
  void choose_edges() {
    choose_feature_edges(definition.surface_options, model.surfaces.surfaces, kinematics, contact_mesh);
    for (ContactEdge& edge : contact_mesh.edges) {
      edge.penalty_properties.thickness = 0.5;
      edge.penalty_properties.mass_per_area = 4.0;
      edge.width = 0.2;
    }
  }

  EdgeEdgeContacts edges;
  ContactSearch contact_search;
  double dt = 1.0;

  void search_edges() {
    ContactParts::find_candidates(contact_search, dt);
    edges.find_candidates(contact_search, kinematics, motion(dt));
  }
  /// Moves a block by its velocity in a step.
  void advance(std::size_t block, const Eigen::Vector3d& way) {
    v.setZero();
    for (const NodeIndex node : mesh.blocks()[block].nodes) v.col(node.value) = way;
    x += v;
    move();
  }
  /// What touches in a step of this size.
  std::vector<ContactPoint> touching() {
    std::vector<ContactPoint> points;
    edges.begin_step();
    edges.begin_detection(context(dt));
    edges.detect(context(dt), {0, edges.n_rows()}, points);
    edges.update(context(dt), {0, edges.n_rows()}, points);
    std::erase_if(points, [](const ContactPoint& point) { return !point.touches(); });
    return points;
  }
};

/// A rod of three elements along x from -1.5 to 1.5, radius 0.1, and one of one element across it at x.
MeshBuilder rod_across(double x, double height) {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1.5, 0, 0}, .to = {1.5, 0, 0}});
  add_rod(b, {.id = 2, .from = {x, -1, height}, .to = {x, 1, height}});
  return b;
}

}  // namespace

TEST_CASE("candidates of edges are those that are near now", "[contact][edges]") {
  EdgeBodies rods(rod_across(0.1, 0.25), stiff_edges);
  CHECK(rods.edges.n_candidates() == 0);
  rods.search_edges();
  CHECK(rods.edges.n_rows() == 4);
  CHECK(rods.edges.n_candidates() == 1);  // the middle one of three
  rods.advance(1, {0.4, 0, 0});
  rods.search_edges();
  CHECK(rods.edges.n_candidates() == 2);  // beside the node between two
  rods.advance(1, {0, 0, 2});
  rods.dt = 0.0;
  rods.search_edges();
  CHECK(rods.edges.n_candidates() == 0);
}

TEST_CASE("edges that touch stay candidates however deep they get", "[contact][edges]") {
  EdgeBodies bars(crossed_bars(0.01), stiff_edges);
  bars.search_edges();
  bars.advance(1, {0, 0, -0.02});
  REQUIRE(bars.touching().size() == 1);
  for (int step = 1; step <= 9; ++step) {
    bars.advance(1, {0, 0, -0.05});
    bars.search_edges();
    const auto points = bars.touching();
    CAPTURE(step);
    REQUIRE(points.size() == 1);
    CHECK(points[0].gap == Approx(-0.01 - 0.05 * step));
  }
  // A step that is undone for a search has forgotten nothing.
  bars.edges.begin_step();
  bars.edges.undo_begin_step();
  bars.search_edges();
  CHECK(bars.touching().size() == 1);
  bars.search_edges();
  bars.edges.begin_step();
  bars.search_edges();  // one that is not undone has
  CHECK(bars.touching().empty());
}

TEST_CASE("edges that are left after a death go on with their slip under their new numbers",
          "[contact][edges]") {
  EdgeBodies rods(rod_across(0.5, 0.19), rough_edges);
  rods.search_edges();
  REQUIRE(rods.touching().size() == 1);
  rods.advance(1, {0, 0.001, 0});
  const auto before = rods.touching();
  REQUIRE(before.size() == 1);  // at the node of two edges, the first of which has it
  CHECK(before[0].first_entity == 1);
  CHECK(before[0].second_entity == 3);
  CHECK(before[0].elastic_slip.norm() == Approx(0.001));

  const ContactRemap remap = let_die(rods, rough_edges, {1});
  REQUIRE(rods.contact_mesh.edges.size() == 3);
  rods.edges.remap(remap);
  CHECK(rods.edges.n_rows() == 3);
  CHECK(rods.edges.n_candidates() == 2);
  rods.advance(1, {0, 0.001, 0});
  const auto after = rods.touching();
  REQUIRE(after.size() == 1);
  CHECK(after[0].first_entity == 0);
  CHECK(after[0].second_entity == 2);
  CHECK(after[0].gap == Approx(-0.01));
  CHECK(after[0].elastic_slip.norm() == Approx(0.002));
}

TEST_CASE("edges that die take their candidates with them", "[contact][edges]") {
  EdgeBodies rods(rod_across(0.5, 0.19), rough_edges);
  rods.search_edges();
  REQUIRE(rods.touching().size() == 1);
  rods.edges.remap(let_die(rods, rough_edges, {2}));
  CHECK(rods.edges.n_candidates() == 1);
  const auto points = rods.touching();
  REQUIRE(points.size() == 1);  // the other edge at that node has the point now
  CHECK(points[0].first_entity == 1);
  rods.edges.remap(let_die(rods, rough_edges, {2, 4}));
  CHECK(rods.edges.n_rows() == 2);
  CHECK(rods.edges.n_candidates() == 0);
}

TEST_CASE("edges go on from a stored state as deep as they were", "[contact][edges]") {
  EdgeBodies bars(crossed_bars(0.01), rough_edges);
  bars.search_edges();
  for (const double down : {0.02, 0.2, 0.2}) {
    bars.advance(1, {0.001, 0, -down});
    bars.search_edges();
    REQUIRE(bars.touching().size() == 1);
  }
  StateArchive saves;
  bars.edges.archive(saves);
  const SavedState stored = saves.take();
  EdgeEdgeContacts other(bars.setup());
  StateArchive restores(stored);
  other.archive(restores);
  CHECK(other.n_candidates() == bars.edges.n_candidates());
  bars.advance(1, {0, 0, 0});
  const auto points_of = [&](EdgeEdgeContacts& edges) {
    std::vector<ContactPoint> points;
    edges.begin_step();
    edges.begin_detection(bars.context(1.0));
    edges.detect(bars.context(1.0), {0, edges.n_rows()}, points);
    std::erase_if(points, [](const ContactPoint& point) { return !point.touches(); });
    return points;
  };
  const auto points = points_of(other);
  REQUIRE(points.size() == 1);
  CHECK(points[0].gap == Approx(-0.41));  // far deeper than what has just begun to touch may be
  CHECK(points[0].elastic_slip.norm() > 0.0);
  CHECK(points[0].elastic_slip == points_of(bars.edges)[0].elastic_slip);
}
