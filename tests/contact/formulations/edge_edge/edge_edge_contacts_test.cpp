// SPDX-License-Identifier: BSD-3-Clause
// Friction models between edges: they push with friction, by the half of a HYBRID pair that they are of, and
// leave to ties what these hold.
#include "contact/formulations/edge_edge/edge_edge_contacts.hpp"
#include "contact/mesh/feature_edges.hpp"
#include "contact/search/contact_search.hpp"
#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/lofted_meshes.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

const std::string hybrid =
    "friction model = h\ncapture tolerance = 0.01\nend\n"
    "begin constant friction model rough\nfriction coefficient = 0.5\nend\n"
    "begin hybrid model h\ninitially close = rough\n";
const std::string glued = "friction model = sticky\nend\nbegin glued model sticky\n";

/// Two rods of radius 0.1 that cross, their surfaces so far apart.
MeshBuilder crossed_rods(double gap) {
  MeshBuilder b;
  add_rod(b, {.id = 1, .cells = 3, .from = {-1, 0.05, 0}, .to = {1, 0.05, 0}});
  add_rod(b, {.id = 2, .cells = 3, .from = {0.1, -1, 0.2 + gap}, .to = {0.1, 1, 0.2 + gap}});
  return b;
}

std::size_t n_touching_edges(const ContactBodies& bodies) {
  return static_cast<std::size_t>(
      std::ranges::count_if(bodies.contact.points(),
                            [](const ContactPoint& point) { return point.is_of_edges && point.touches(); }));
}

}  // namespace

TEST_CASE("rods of a HYBRID pair have the friction of the half that they are of", "[contact][edges]") {
  const bool is_close = GENERATE(true, false);
  const double gap = is_close ? 0.005 : 0.05;
  ContactBodies bodies(crossed_rods(gap), general_contact(hybrid));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(gap + 0.005);
  bodies.set_velocity(1, {0.3, 0.2, 0});
  for (int i = 0; i < 20; ++i) bodies.step(1e-3);
  const Eigen::Vector3d force = bodies.force_on(1);
  REQUIRE(force.z() > 0.0);
  CHECK(force.head<2>().norm() == Approx(is_close ? 0.5 * force.z() : 0.0).epsilon(0.02).margin(1e-12));
}

TEST_CASE("sharp edges push under a GLUED model as long as nothing is glued", "[contact][edges]") {
  ContactBodies bodies(crossed_bars(0.01), general_contact(glued));
  bodies.ask();
  bodies.set_velocity(1, {0, 0, -1});
  bodies.step(0.0099);
  CHECK(bodies.force_size() == 0.0);
  bodies.step(0.0002);
  CHECK(n_touching_edges(bodies) == 1);
  CHECK(bodies.force_on(1).z() > 0.0);
  CHECK(bodies.net_force().norm() < 1e-12 * bodies.force_size());
}

TEST_CASE("sharp edges whose faces or nodes a tie holds do not push", "[contact][edges]") {
  ContactParts parts(crossed_bars(-0.01), general_contact("penalty stiffness = 1000\n" + glued));
  choose_feature_edges(parts.definition.surface_options, parts.model.surfaces.surfaces, parts.kinematics,
                       parts.contact_mesh);
  for (ContactEdge& edge : parts.contact_mesh.edges) {
    edge.penalty_properties = parts.contact_mesh.faces[(*edge.faces)[0]].penalty_properties;
    edge.width = 1.0;
  }
  EdgeEdgeContacts edges(parts.setup());
  ContactSearch search(parts.contact_mesh, parts.mesh, parts.rules, {}, parts.definition.dash);
  parts.find_candidates(search);
  edges.find_candidates(search, parts.kinematics, parts.motion());
  edges.begin_step();
  const auto find = [&] {
    std::vector<ContactPoint> contact_points;
    edges.begin_detection(parts.context());
    edges.detect(parts.context(), {0, edges.n_rows()}, contact_points);
    std::erase_if(contact_points, [](const ContactPoint& contact_point) { return !contact_point.touches(); });
    return contact_points;
  };
  const std::vector<ContactPoint> free = find();
  REQUIRE(free.size() == 1);
  const ContactEdge &first = parts.contact_mesh.edges[free[0].first_edge()],
                    &second = parts.contact_mesh.edges[free[0].second_edge()];
  parts.constrained.add_faces((*second.faces)[1], (*first.faces)[0]);
  CHECK(find().empty());
  parts.constrained.remove_faces((*second.faces)[1], (*first.faces)[0]);
  CHECK(find().size() == 1);
  parts.constrained.add_node(parts.contact_mesh.find_row(first.nodes[1], first.surface).value(),
                             free[0].pair);
  CHECK(find().empty());
}
