// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/contact_force.hpp"

#include <algorithm>
#include <memory>

#include "contact/mesh/eroded_nodes.hpp"
#include "contact/surfaces/surface_tracker.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"

// Contact that goes over to the surfaces of the living: what it remembers of the rest stays.

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A plate of 6 x 3 x 2 cells under a cube of one cell that lies on its middle.
MeshBuilder cube_on_plate(double depth = 0.01, bool is_of_tets = false) {
  MeshBuilder builder;
  const test::Box plate{.id = 1, .cells = {6, 3, 2}, .size = {6, 3, 2}};
  const test::Box cube{
      .id = 2, .origin = {2.1, 1.1, 2.0 - depth}, .size = {0.8, 0.8, 0.8}, .share_nodes = false};
  if (is_of_tets) return builder.add_ten_node_tets(plate).add_ten_node_tets(cube);
  return builder.add_hexes(plate).add_hexes(cube);
}

const std::string surfaces =
    "skin all blocks = on\n"
    "begin constant friction model rough\nfriction coefficient = 0.5\nend\n";

/// The bodies, and surfaces that follow deaths.
struct DyingBodies : ContactBodies {
  explicit DyingBodies(const std::string& more, bool erodes = false)
      : DyingBodies(cube_on_plate(), general_contact(more, surfaces), erodes) {}
  DyingBodies(const MeshBuilder& builder, const std::string& contact_lines, bool erodes)
      : ContactBodies(builder, contact_lines),
        alive(mesh.n_elements(), 1),
        elements(mesh),
        faces(mesh, elements),
        living(make_rules(), faces, std::vector<std::uint8_t>(mesh.n_elements(), erodes ? 1 : 0)),
        eroded_nodes(faces, std::vector<std::uint8_t>(mesh.n_elements(), erodes ? 1 : 0)) {}

  void kill(const std::vector<ElementIndex>& dead, bool makes_new_edges = true) {
    for (const ElementIndex element : dead) alive[element.value] = 0;
    living.update_for_deaths(dead, definition.surfaces);
    eroded_nodes.add(living.rules(), dead, alive);
    contact.rebuild_surfaces(motion(), eroded_nodes.nodes(), makes_new_edges);
  }
  std::size_t n_free_rows() const {
    std::size_t n = 0;
    for (const SurfaceNode& node : contact.contact_mesh().surface_nodes) n += node.is_free ? 1 : 0;
    return n;
  }

  std::vector<std::uint8_t> alive;
  NodeElements elements;
  FaceGroups faces;
  SurfaceTracker living;
  ErodedNodes eroded_nodes;

 private:
  OwnershipRules make_rules() const {
    Diagnostics diagnostics;
    return {make_surface_requests(*region.contact, {}, mesh, diagnostics), mesh, region.contact->subdomain};
  }
};

}  // namespace

TEST_CASE("friction goes on without a jump when a far element dies", "[contact][death]") {
  const std::string node_face = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const auto make = [&] {
    auto bodies = std::make_unique<DyingBodies>("friction model = rough\n" + node_face);
    bodies->ask();
    bodies->set_velocity(1, {1e-3, 0, 0});
    for (int i = 0; i < 5; ++i) bodies->step(0.1);
    return bodies;
  };
  const auto untouched = make(), dying = make();
  dying->kill({{0}, {35}});  // corners of the plate
  REQUIRE(dying->n_free_rows() == 2);
  for (int i = 0; i < 5; ++i) {
    untouched->step(0.1);
    dying->step(0.1);
    CHECK(dying->forces == untouched->forces);
  }
  CHECK(dying->force_on(1).x() < 0.0);
}

TEST_CASE("friction on six-node faces goes on without a jump when a far element dies", "[contact][death]") {
  const std::string node_face = GENERATE(std::string(), std::string("constraint formulation = node_face\n"));
  const auto make = [&] {
    auto bodies = std::make_unique<DyingBodies>(
        cube_on_plate(0.01, true), general_contact("friction model = rough\n" + node_face, surfaces), false);
    bodies->ask();
    bodies->set_velocity(1, {1e-3, 0, 0});
    for (int i = 0; i < 5; ++i) bodies->step(0.1);
    return bodies;
  };
  const auto untouched = make(), dying = make();
  const std::size_t n_faces = dying->contact.contact_mesh().faces.size();
  dying->kill({{0}, {215}});
  CHECK(dying->contact.contact_mesh().faces.size() != n_faces);
  for (int i = 0; i < 5; ++i) {
    untouched->step(0.1);
    dying->step(0.1);
    CHECK(dying->forces == untouched->forces);
  }
  CHECK(dying->force_on(1).x() < 0.0);
}

TEST_CASE("deaths make new sharp edges unless the deck says otherwise", "[contact][death]") {
  const bool makes_new_edges = GENERATE(true, false);
  DyingBodies bodies("");
  bodies.ask();
  const std::size_t n_edges = bodies.contact.contact_mesh().edges.size();
  // An element of the upper layer inside the border: its hole has four sharp edges above and four corners
  // that go down.
  bodies.kill({{18 + 6 + 3}}, makes_new_edges);
  const std::size_t n_now = bodies.contact.contact_mesh().edges.size();
  if (makes_new_edges) CHECK(n_now >= n_edges + 4);
  if (!makes_new_edges) CHECK(n_now == n_edges);
}

TEST_CASE("contact goes back to what it was before deaths", "[contact][death]") {
  const std::string lines =
      GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n", "enforcement = penalty\n",
               "interaction behavior = infinitesimal_sliding\n");
  const bool has_died_before = GENERATE(false, true), makes_new_edges = GENERATE(true, false);
  const auto make = [&] {
    auto bodies = std::make_unique<DyingBodies>("friction model = rough\n" + lines);
    bodies->ask();
    bodies->set_velocity(1, {1e-3, 0, 0});
    for (int i = 0; i < 3; ++i) bodies->step(0.1);
    if (has_died_before) bodies->kill({{0}, {1}}, makes_new_edges);
    for (int i = 0; i < 3; ++i) bodies->step(0.1);
    return bodies;
  };
  const auto untouched = make(), dying = make();
  const ContactSurfaces surfaces = dying->definition.surfaces;
  const ContactCheckpoint before = dying->contact.checkpoint(dying->motion());
  // Below the cube, and a corner.
  dying->kill({{2 + 6 * 1 + 18}, {35}}, makes_new_edges);
  REQUIRE(dying->contact.contact_mesh().faces.size() != before.contact_mesh.faces.size());
  dying->definition.surfaces = surfaces;
  dying->contact.restore(dying->motion(), before);

  CHECK(dying->contact.contact_mesh().faces.size() == untouched->contact.contact_mesh().faces.size());
  CHECK(dying->contact.contact_mesh().edges.size() == untouched->contact.contact_mesh().edges.size());
  CHECK(dying->contact.points().size() == untouched->contact.points().size());
  const ContactCheckpoint after = dying->contact.checkpoint(dying->motion());
  REQUIRE(after.memory.arrays().size() == before.memory.arrays().size());
  for (const SavedArray& array : before.memory.arrays()) {
    CAPTURE(array.name);
    const SavedArray* now = after.memory.find(array.name);
    REQUIRE(now != nullptr);
    CHECK(std::ranges::equal(now->bytes, array.bytes));
  }
  for (int i = 0; i < 5; ++i) {
    untouched->step(0.1);
    dying->step(0.1);
    CHECK(dying->forces == untouched->forces);
  }
}

TEST_CASE("an overlap of the start stays that of a spring when a far element dies", "[contact][death]") {
  DyingBodies bodies(cube_on_plate(0.3),
                     general_contact(GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n")),
                     false);
  bodies.ask();
  const double at_start = bodies.force_on(1).z();
  bodies.kill({{0}});
  bodies.step(0.1);
  CHECK(bodies.force_on(1).z() == Approx(at_start));
}

TEST_CASE("an overlap of the start stays ignored when a far element dies", "[contact][death][gaps]") {
  const std::string formulation = GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n");
  DyingBodies bodies("penalty stiffness = 1e4\nignore initial overlap = on\n" + formulation);
  bodies.ask();
  CHECK(bodies.force_size() == 0.0);
  bodies.kill({{0}});
  bodies.step(0.1);
  CHECK(bodies.force_size() == 0.0);
  bodies.set_velocity(1, {0, 0, -0.0005});
  for (int i = 0; i < 10; ++i) bodies.step(1.0);
  CHECK(bodies.force_on(1).z() == Approx(1e4 * 0.005 * 0.64).epsilon(0.01));
}

TEST_CASE("what may not part stays held when a far element dies", "[contact][death][separation]") {
  const std::string formulation = GENERATE(as<std::string>{}, "", "constraint formulation = node_face\n");
  DyingBodies bodies("penalty stiffness = 1e4\nseparation = off\n" + formulation);
  bodies.ask();
  bodies.set_velocity(1, {0, 0, 0.0011});
  for (int i = 0; i < 10; ++i) bodies.step(1.0);
  CHECK(bodies.force_on(1).z() == Approx(-1e4 * 0.001 * 0.64).epsilon(0.01));
  bodies.kill({{0}, {35}});
  bodies.set_velocity(1, {0, 0, 0.0001});
  for (int i = 0; i < 10; ++i) bodies.step(1.0);
  CHECK(bodies.force_on(1).z() == Approx(-1e4 * 0.002 * 0.64).epsilon(0.01));
}

TEST_CASE("contact passes to what a death exposes, also where first partners are kept", "[contact][death]") {
  DyingBodies bodies(
      GENERATE(as<std::string>{}, "", "interaction behavior = infinitesimal_sliding\n",
               "interaction behavior = infinitesimal_sliding\nconstraint formulation = node_face\n"));
  bodies.ask();
  bodies.dt = 0.1;
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
  const ElementIndex under{2 + 6 * 1 + 18};  // of the upper layer, at x 2 to 3, y 1 to 2
  bodies.kill({under});
  bodies.step(0.1);
  CHECK(bodies.force_on(1).norm() == 0.0);
  CHECK(bodies.forces.isZero(0.0));  // nodes that have left contact keep no force
  bodies.shift(1, {0, 0, -0.985});
  bodies.set_velocity(1, {0, 0, -0.1});
  for (int i = 0; i < 2; ++i) bodies.step(0.1);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12);
}

TEST_CASE("ties whose face died are gone, the others stay", "[contact][death]") {
  DyingBodies bodies("friction model = tied\n");
  bodies.ask();
  const std::size_t n_before = bodies.contact.ties().size();
  REQUIRE(n_before > 0);
  bodies.kill({{35}});
  CHECK(bodies.contact.ties().size() == n_before);
  bodies.shift(1, {1e-3, 0, 0});
  bodies.step(0.1);
  CHECK(bodies.force_on(1).x() < 0.0);
  bodies.kill({{2 + 6 * 1 + 18}});
  CHECK(bodies.contact.ties().empty());
}

TEST_CASE("nodes of dead elements only stay as free masses, or leave with NODAL EROSION",
          "[contact][death]") {
  DyingBodies staying(""), eroding("", true);
  for (DyingBodies* bodies : {&staying, &eroding}) {
    bodies->ask();
    bodies->kill({{0}});  // the lower layer's corner: one node is its own
  }
  REQUIRE(staying.n_free_rows() == 1);
  CHECK(eroding.n_free_rows() == 0);
  CHECK(staying.eroded_nodes.nodes()[0].surface == SurfaceIndex{0});
  CHECK(staying.mesh.coordinates().col(staying.eroded_nodes.nodes()[0].node.value).isZero());
}

TEST_CASE("a free node meets faces as a mass of its own", "[contact][death]") {
  DyingBodies bodies("");
  bodies.ask();
  bodies.kill({{0}});
  const std::uint32_t node = bodies.eroded_nodes.nodes()[0].node.value;
  // It comes down on the middle of the cube's top, 2.79 high.
  bodies.x.col(node) = Eigen::Vector3d(2.5, 1.5, 2.7901);
  bodies.v.col(node) = Eigen::Vector3d(0, 0, -0.01);
  for (int i = 0; i < 3; ++i) bodies.step(0.1);
  CHECK(bodies.forces(2, node) > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12);
}

TEST_CASE("nodes of a surface of nodes stay as free masses when their block dies, or leave",
          "[contact][death]") {
  const bool erodes = GENERATE(false, true), is_of_block = GENERATE(true, false);
  MeshBuilder set_of_cube = cube_on_plate();
  const std::uint32_t first = 7 * 4 * 3;  // of the cube
  set_of_cube.add_node_set(7, "", {{first}, {first + 1}, {first + 2}, {first + 3}});
  DyingBodies bodies(set_of_cube,
                     "contact surface plate contains block_1\n"
                     "contact node set nodes contains " +
                         std::string(is_of_block ? "block_2" : "nodelist_7") +
                         "\nbegin interaction\nside a = plate\nside b = nodes\n"
                         "constraint formulation = node_face\nend\n",
                     erodes);
  bodies.ask();
  bodies.dt = 0.1;
  bodies.ask();
  CHECK(bodies.force_on(1).z() > 0.0);
  bodies.kill({{36}});
  bodies.step(0.1);
  CHECK((bodies.force_on(1).z() > 0.0) == !erodes);
  CHECK(bodies.net_force().norm() < 1e-12);
  CHECK(bodies.n_free_rows() == (is_of_block && !erodes ? 8 : 0));
}
