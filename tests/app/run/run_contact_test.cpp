// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_contact.hpp"

#include "contact/overlap/start_overlaps.hpp"
#include "core/dynamics/model.hpp"
#include "core/dynamics/state_motion.hpp"
#include "core/mesh/node_elements.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/two_cube_input.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// The contact of a run of two cubes, before its first step.
struct ContactOfRun : TwoCubeInput {
  explicit ContactOfRun(double gap, const std::string& of_contact = "")
      : ContactOfRun(two_cube_mesh(gap).build(), of_contact) {}
  explicit ContactOfRun(const Mesh& of, const std::string& of_contact = "")
      : TwoCubeInput(of, two_cube_deck(text_of({.region = two_cube_contact(of_contact)}))),
        model(make_model(definition, region(), mesh, diagnostics)),
        run_input((overlaps = find_start_overlaps(*contact, mesh, *region().contact), input())),
        run(run_input, model, one_rank()),
        state(make_state(mesh.coordinates(), model.blocks, 0.0)),
        elements(mesh),
        faces(mesh, elements),
        alive(mesh.n_elements(), 1) {
    state.forces.contact = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  }
  /// Elements would allow a step of 0.1.
  ForceReport ask() {
    Motion motion = motion_of(state);
    motion.stable_step = 0.1;
    return run.force().set_forces(motion, state.forces.contact);
  }
  SurfaceChanges kill(const std::vector<ElementIndex>& dead) {
    for (const ElementIndex element : dead) alive[element.value] = 0;
    return run.update_for_deaths(state, dead, alive);
  }
  std::size_t n_faces() const { return run.force().contact_mesh().faces.size(); }

  Model model;
  RunInput run_input;
  RunContact run;
  State state;
  NodeElements elements;
  FaceGroups faces;
  std::vector<std::uint8_t> alive;
};

template <class Set>
std::vector<std::string> names_of_sets(const std::vector<Set>& sets) {
  std::vector<std::string> names;
  for (const Set& set : sets) names.push_back(set.name);
  return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST_CASE("outputs of a run with contact have its variables, groups and a set for each surface",
          "[app][contact]") {
  ContactOfRun cubes(0.1, "contact node set dots contains block_2\n");
  OutputSettings settings;
  cubes.run.add_to(settings);
  CHECK(names_of_sets(settings.side_sets) == Names{"contact_low", "contact_high"});
  CHECK(settings.side_sets[0].sides.size() == 24);
  CHECK(settings.side_sets[1].sides.size() == 6);
  CHECK(names_of_sets(settings.node_sets) == Names{"contact_dots"});
  CHECK(settings.node_sets[0].nodes.size() == 8);
  CHECK(settings.other_names.groups.size() == contact_output_names().groups.size());
  CHECK(std::ranges::count(settings.variables, "contact_force_low_high", &OutputVariable::name) == 1);
}

TEST_CASE("a set gets a number where the mesh, or another surface, has its name", "[app][contact]") {
  MeshBuilder b = two_cube_mesh(0.1);
  b.add_side_set(7, "contact_low", {{{0}, 1}})
      .add_node_set(8, "Contact_Low_2", std::vector<std::uint32_t>{0});
  ContactOfRun cubes(b.build());
  OutputSettings settings;
  cubes.run.add_to(settings);
  CHECK(names_of_sets(settings.side_sets) == Names{"contact_low_3", "contact_high"});
}

TEST_CASE("nodes that no tie reaches make a set of the results", "[app][contact]") {
  // The cube high is lifted at the end of it along x, farther than the tie reaches.
  MeshBuilder b;
  b.add_hexes({.id = 1, .name = "low"});
  b.add_hexes({.id = 2, .name = "high", .cells = {2, 1, 1}, .origin = {0, 0, 1}, .share_nodes = false});
  MeshParts parts = b.parts();
  for (Eigen::Index i = 8; i < parts.coordinates.cols(); ++i) {
    if (parts.coordinates(0, i) == 1.0) parts.coordinates(2, i) += 0.05;
  }
  const std::string ties =
      "begin interaction\nsurfaces = low high\nfriction model = tied\ncapture tolerance = 0.01\nend\n";
  ContactOfRun cubes(Mesh(std::move(parts)), ties);
  OutputSettings settings;
  cubes.run.add_to(settings);
  REQUIRE(names_of_sets(settings.node_sets) == Names{"contact_untied"});
  CHECK(settings.node_sets[0].nodes == cubes.run.untied()[{0}].nodes);
  for (const NodeIndex node : settings.node_sets[0].nodes) {
    const Eigen::Vector3d x = cubes.mesh.coordinates().col(node.value);
    CHECK(x.x() > 0.4);  // the tie ends at a fifth
  }
  ContactOfRun whole(two_cube_mesh(0.0).build(), ties);
  OutputSettings of_whole;
  whole.run.add_to(of_whole);
  CHECK(of_whole.node_sets.empty());
}

TEST_CASE("files that contact is debugged by get the end of a run that goes on", "[app][contact]") {
  ContactOfRun cubes(0.1, "begin debug\nvisualize contact facets = on\nend\n");
  CHECK(cubes.run.paths() == Names{"d_contact_facets.exo"});
  cubes.run.add_suffix("-s0002");
  CHECK(cubes.run.paths() == Names{"d_contact_facets.exo-s0002"});
  CHECK(ContactOfRun(0.1).run.paths().empty());
}

TEST_CASE("surfaces follow deaths, and go back to those of a checkpoint", "[app][contact][death]") {
  const bool erodes = GENERATE(false, true);
  ContactOfRun cubes(0.1);
  CHECK(cubes.run.n_eroded_nodes() == 0);
  cubes.run.follow_deaths(cubes.faces, std::vector<std::uint8_t>(9, erodes ? 1 : 0), true);
  cubes.ask();
  REQUIRE(cubes.n_faces() == 24 + 6);
  const RunContactCheckpoint before = cubes.run.checkpoint(cubes.state);
  const SurfaceChanges changes = cubes.kill({{0}});
  CHECK(cubes.n_faces() == 24 + 6);  // a corner: as many faces show as are gone
  CHECK(changes[{0}].faces_lost == 3);
  CHECK(changes[{0}].faces_gained == 3);
  cubes.kill({{8}});
  CHECK(cubes.n_faces() == 24);
  CHECK(cubes.run.n_eroded_nodes() == (erodes ? 0 : 1 + 8));
  CHECK(cubes.run.model().surfaces.surfaces[{1}].faces.empty());
  cubes.run.restore(cubes.state, before);
  CHECK(cubes.n_faces() == 24 + 6);
  CHECK(cubes.run.n_eroded_nodes() == 0);
  CHECK(cubes.run.model().surfaces.surfaces[{1}].faces.size() == 6);
  CHECK(cubes.contact->surfaces.surfaces[{1}].faces.size() == 6);  // that of the input is another
}

TEST_CASE("the start is told of overlaps with the energy that contact holds in them", "[app][contact]") {
  ContactOfRun cubes(-0.02, "begin interaction\nsurfaces = low high\nenforcement = penalty\nend\n"),
      apart(0.1);
  for (ContactOfRun* each : {&cubes, &apart}) each->ask();
  REQUIRE(cubes.run.force().stored() > 0.0);
  Diagnostics warnings, none;
  cubes.run.warn_of_start(warnings);
  apart.run.warn_of_start(none);
  CHECK_THAT(messages(warnings), Contains("'low' and 'high' overlap at the start") &&
                                     Contains("deepest by 0.02") && Contains("contact stores "));
  CHECK(messages(none).empty());
}

TEST_CASE("bodies that have come to lie in each other are seen at the end", "[app][contact]") {
  ContactOfRun cubes(0.1);
  cubes.ask();
  CHECK(cubes.run.interpenetrations()[{0}].n_nodes == 0);
  for (Eigen::Index i = 27; i < 35; ++i) cubes.state.coordinates(2, i) -= 0.8;
  cubes.state.dt = 0.1;
  cubes.state.time = 0.1;
  cubes.state.step = 1;
  cubes.ask();
  Diagnostics warnings;
  cubes.run.warn_of_end(cubes.state, warnings);
  CHECK_THAT(messages(warnings), Contains("low") && Contains("high"));
}
