// SPDX-License-Identifier: BSD-3-Clause
// The nodal forces of contact and the totals of surfaces and pairs are sums of the same contact points.
#include <map>

#include "contact/output/contact_output.hpp"
#include "core/interface_laws/interface_law_table.hpp"
#include "support/catch.hpp"
#include "support/law_bodies.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Eigen::Vector3d;

namespace {

/// Friction models called m, by name.
const std::map<std::string, std::string> laws{
    {"frictionless", "begin frictionless model m\nend\n"},
    {"constant friction", "begin constant friction model m\nfriction coefficient = 0.3\nend\n"},
    {"stick", "begin stick model m\nend\n"},
    {"pv dependent",
     "begin pv_dependent model m\nstatic coefficient = 0.5\ndynamic coefficient = 0.1\nvelocity decay = 2\n"
     "reference pressure = 10\npressure exponent = 2\nend\n"},
    {"pressure function",
     "begin pressure function model m\nfunction = rise\nfriction coefficient = 0.3\nend\n"},
    {"exponential pressure",
     "begin exponential pressure model m\npressure at zero gap = 10\nclearance at zero pressure = 0.01\n"
     "end\n"},
    {"tied", "begin tied model m\nend\n"},
    {"glued", "begin glued model m\nend\n"},
    {"adhesion", "begin adhesion model m\nadhesion function = fall\nend\n"},
    {"junction",
     "begin junction model m\nnormal traction function = rise\ntangential traction function = rise\nend\n"},
    {"cohesive zone",
     "begin cohesive zone model m\ntraction displacement function = zone\ncritical normal gap = 0.1\n"
     "critical tangential gap = 0.2\nend\n"},
    {"threaded",
     "begin threaded model m\nnormal traction function = rise\ntangential traction function = rise\n"
     "normal capacity = 20\ntangential capacity = 100\nend\n"},
    {"spring weld",
     "begin spring weld model m\nnormal displacement function = rise\n"
     "tangential displacement function = rise\nend\n"},
    {"surface weld", "begin surface weld model m\nnormal capacity = 8\ntangential capacity = 4\nend\n"},
    {"area weld", "begin area weld model m\nnormal capacity = 8\ntangential capacity = 4\nend\n"},
    {"hybrid",
     "begin constant friction model rub\nfriction coefficient = 0.3\nend\n"
     "begin hybrid model m\ninitially close = tied\ninitially far = rub\nend\n"},
    {"time variant",
     "begin constant friction model rub\nfriction coefficient = 0.3\nend\n"
     "begin time variant model m\nmodel = rub during periods first\nmodel = tied during periods "
     "second\nend\n"},
};

std::vector<TimeSteppingBlock> two_periods() {
  std::vector<TimeSteppingBlock> blocks(2);
  blocks[0].name = {"first", {}};
  blocks[0].start_time = 0.0;
  blocks[1].name = {"second", {}};
  blocks[1].start_time = 0.25;
  return blocks;
}

/// A block of 2 x 3 cells on a plate of 4 x 3, askew, so that no weight of a point is a round number.
MeshBuilder block_on_plate() {
  MeshBuilder b;
  b.add_hexes({.id = 1, .cells = {4, 3, 1}, .size = {3, 3, 1}});
  return b.add_hexes({.id = 2,
                      .cells = {2, 3, 1},
                      .origin = {0.71, 0.93, 1.001},
                      .size = {1.37, 1.59, 1},
                      .share_nodes = false});
}

}  // namespace

TEST_CASE("the list of laws is that of the table", "[contact][contact_output]") {
  for (const InterfaceLawRow& row : interface_law_rows()) CHECK(laws.count(row.name) == 1);
}

TEST_CASE("nodal forces add up to the totals of surfaces and pairs within round-off, for every law",
          "[contact][contact_output]") {
  const std::string formulation = GENERATE(std::string(), by_nodes, both_ways);
  // A point's force reaches eight nodes by weights that add up to one within round-off, and either sum goes
  // over all of its terms: some epsilon per force that is summed.
  constexpr double share = 2.0 * std::numeric_limits<double>::epsilon();
  for (const auto& [name, model] : laws) {
    INFO(name << ", " << formulation);
    ContactBodies bodies(block_on_plate(), law_deck(model, formulation),
                         line_function("rise", "0 0\n0.1 50\n") + line_function("fall", "0 2\n0.1 0\n") +
                             line_function("zone", "0 0\n0.5 10\n1 0\n"),
                         two_periods());
    ContactOutput output(bodies.contact, bodies.definition, bodies.model);
    const std::vector<OutputVariable> variables = output.variables();
    State state = make_state(bodies.x, bodies.model.blocks, 0.0);
    const auto total = [&](const std::string& of) {
      const auto found = std::ranges::find(variables, "contact_force_" + of, &OutputVariable::name);
      REQUIRE(found != variables.end());
      Vector3d force = Vector3d::Zero();
      found->fill({bodies.model, state}, {}, std::span(force.data(), 3));
      return force;
    };
    bodies.ask();
    double largest = 0.0;
    const std::vector<Vector3d> path{
        {0.004, 0.003, 0.002}, {0.001, -0.002, 0.001}, {0.003, 0.001, -0.009}, {0.01, 0.007, 0.0}};
    for (std::size_t i = 0; i < path.size(); ++i) {
      const Vector3d on_block = force_after(bodies, path[i]);
      state.step = static_cast<std::int64_t>(i) + 1;
      state.time = bodies.time;
      state.dt = bodies.dt;
      state.coordinates = bodies.x;
      const double bound = share * bodies.force_size();
      CHECK((total("block_2") - on_block).norm() <= bound);
      CHECK((total("block_1") - bodies.force_on(0)).norm() <= bound);
      CHECK((total("block_1_block_2") - bodies.force_on(0)).norm() <= bound);
      CHECK((total("block_1") + total("block_2")).norm() == 0.0);
      largest = std::max(largest, bodies.force_size());
    }
    CHECK(largest > 0.1);
  }
}
