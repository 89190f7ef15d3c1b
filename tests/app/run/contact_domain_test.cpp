// SPDX-License-Identifier: BSD-3-Clause
// What is in contact in a run and when: exclusions, periods, rigid bodies, point masses. Numbers by hand.
#include <algorithm>
#include <cmath>

#include "support/catch.hpp"
#include "support/csv_column.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using Catch::Matchers::Contains;
using contactsim::Mesh;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace {

/// A held unit cube "low" and another, "high", 0.03 above it, which falls at 1:
/// they touch at 0.03.
Mesh two_cubes() {
  return MeshBuilder()
      .add_hexes({.id = 1, .name = "low"})
      .add_hexes({.id = 2, .name = "high", .origin = {0, 0, 1.03}, .share_nodes = false})
      .build();
}

const std::string falling =
    "begin fixed displacement\nblock = low\ncomponents = x y z\nend\n"
    "begin initial velocity\nblock = high\ncomponent = z\nmagnitude = -1\nend\n";

struct Setup {
  std::string sections = {};              ///< and rigid bodies
  std::string of_low = {}, of_high = {};  ///< lines of the parameters of the blocks
  std::string region = falling;
  std::string contact = {};  ///< lines of the contact definition
  std::string end_time = "0.06";
  std::string sierra = {};  ///< lines at the top
};

/// A directory with a mesh of blocks "low" and "high", elastic, and a deck with
/// periods t1, until 0.02, and t2.
struct Domain : ProgramDirectory {
  Domain(const Mesh& mesh, const Setup& setup) {
    contactsim::test::write_exodus(path("a.g"), mesh);
    write_deck(setup);
  }
  void write_deck(const Setup& setup) const {
    const std::string material = "material = m\nmodel = elastic\n";
    write("a.i",
          "begin sierra\n" + setup.sierra +
              "begin material m\ndensity = 1000\nbegin parameters for model elastic\n"
              "youngs modulus = 1e6\npoissons ratio = 0\nend\nend\n" +
              setup.sections + "begin finite element model f\nbegin parameters for block low\n" + material +
              setup.of_low + "end\nbegin parameters for block high\n" + material + setup.of_high +
              "end\nend\nbegin presto procedure p\nbegin time control\n"
              "begin time stepping block t1\nstart time = 0\nend\n"
              "begin time stepping block t2\nstart time = 0.02\nend\ntermination time = " +
              setup.end_time + "\nend\nbegin presto region r\nuse finite element model f\n" + setup.region +
              "begin user output\nblock = high\ncompute global vz as average of nodal velocity(z)\nend\n"
              "begin heartbeat output\nstream name = a.csv\nprecision = 17\nat step 0 increment = 1\n"
              "global contact_energy as energy\nglobal contact_force_upper as force\nglobal vz\nend\n"
              "begin contact definition\n" +
              setup.contact + "end\nend\nend\nend\n");
  }

  /// A column of the heartbeat: 0 time, 1 contact energy, 4 the vertical force
  /// on "upper", 5 its velocity.
  std::vector<double> column(std::size_t place) const {
    return contactsim::test::csv_column(read("a.csv"), place);
  }
  double peak_force() const { return std::ranges::max(column(4)); }
};

const std::string surfaces = "contact surface lower contains low\ncontact surface upper contains high\n";

/// Every enforcement and formulation, as lines of the defaults. Call it once a
/// case.
std::string any_form() {
  const std::string enforcement = GENERATE("penalty", "momentum_balance");
  const std::string formulation = GENERATE("face_face", "node_face");
  return "enforcement = " + enforcement + "\nconstraint formulation = " + formulation + "\n";
}

std::string defaults(const std::string& lines) {
  return surfaces + "begin interaction defaults\n" + lines + "end\n";
}

std::string interaction(const std::string& lines) {
  return "begin interaction\nsurfaces = lower upper\n" + lines + "end\n";
}

const std::string off = "interaction behavior = no_interaction\n", general = "general contact = on\n";

/// The peak force of two cubes by a contact definition.
double peak_of(const std::string& contact) {
  const Domain run(two_cubes(), {.contact = contact});
  const auto [code, out, err] = run.run({"a.i"});
  INFO(err);
  REQUIRE(code == 0);
  return run.peak_force();
}

}  // namespace

TEST_CASE("an excluded pair has no force in any order of the deck", "[app][domain]") {
  const std::string plain = defaults(any_form());
  CHECK(peak_of(plain + interaction("")) > 1000.0);
  CHECK(peak_of(plain + interaction("") + interaction(off)) == 0.0);
  CHECK(peak_of(plain + interaction(off) + interaction("")) == 0.0);
  CHECK(peak_of(plain + "begin interaction\nside a = all\nside b = upper\n" + off + "end\n" +
                interaction("")) == 0.0);
}

TEST_CASE("what the defaults exclude has no force", "[app][domain]") {
  const std::string lines = any_form() + general;
  CHECK(peak_of(defaults(lines + "exclude surfaces = upper lower\n") + interaction("")) == 0.0);
  CHECK(peak_of(defaults(lines + "exclude surfaces = upper\n")) > 1000.0);
}

TEST_CASE("outside its periods a pair has the force of general contact", "[app][domain]") {
  const std::string contact = defaults(any_form() + general);
  // A hit's peak depends somewhat on where its steps fall.
  const Approx peak = Approx(peak_of(contact)).epsilon(0.1);
  CHECK(peak_of(contact) > 1000.0);
  const std::string tied = "friction model = tied\nactive periods = t1\n";
  CHECK(peak_of(contact + interaction(tied)) > 1000.0);  // held over the gap in t1, it falls from there
  CHECK(peak_of(contact + interaction("inactive periods = t2\n")) == peak);
  CHECK(peak_of(contact + interaction(off + "active periods = t1\n")) == peak);
  CHECK(peak_of(contact + interaction(off + "active periods = t2\n")) == 0.0);
}

TEST_CASE("outside its periods a pair has the force of an earlier interaction", "[app][domain]") {
  const std::string plain = defaults(any_form()), contact = plain + interaction("");
  const Approx peak = Approx(peak_of(contact)).epsilon(0.1);
  CHECK(peak_of(contact) > 1000.0);
  CHECK(peak_of(contact + interaction("friction model = tied\nactive periods = t1\n")) > 1000.0);
  CHECK(peak_of(contact + interaction(off + "active periods = t1\n")) == peak);
  CHECK(peak_of(plain + interaction(off + "active periods = t1\n") + interaction("")) == peak);
}

TEST_CASE("blocks of one rigid body do not meet each other, nor a block itself", "[app][domain]") {
  const std::string contact = defaults(any_form() + general + "self contact = on\n");
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1, .name = "low", .cells = {2, 2, 2}})
                        .add_hexes({.id = 2, .name = "high", .origin = {0, 0, 0.95}, .share_nodes = false})
                        .build();
  Setup setup{.sections = "begin rigid body b\nend\nbegin solid section s\nrigid body = b\nend\n",
              .of_high = "section = s\n",
              .region = "",
              .contact = contact};
  setup.of_low = setup.of_high;
  const Domain run(mesh, setup);
  const auto [code, out, err] = run.run({"a.i"});
  CHECK(code == 0);
  CHECK(run.peak_force() == 0.0);
  CHECK(std::ranges::max(run.column(1)) == 0.0);
  CHECK_THAT(out, Contains("contact lowers the stable time step by 0 % at most"));
}

TEST_CASE("a point mass of a contact node set is pushed back by a held plate", "[app][domain]") {
  const bool is_elastic = GENERATE(true, false);
  const std::string formulation = GENERATE("face_face", "node_face");
  const double gap = GENERATE(0.0001, 0.004, 0.01, 0.014, 0.018, 0.022);
  CAPTURE(gap, formulation);
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1, .name = "low"})
                        .add_spheres(2, "high", {{0.4, 0.4, 1.0 + gap}})
                        .add_node_set(1, "", [](const Eigen::Vector3d& x) { return x.z() > 1.0; })
                        .build();
  const Domain run(mesh,
                   {.sections = "begin point mass section s\nmass = 5\nend\n",
                    .of_high = "section = s\n",
                    .contact = "contact surface lower contains low\n"
                               "contact node set upper contains nodelist_1\n"
                               "begin interaction\nsurfaces = lower upper\nconstraint formulation = " +
                               formulation + (is_elastic ? "\nenforcement = penalty\nend\n" : "\nend\n"),
                    .end_time = "0.3"});
  const auto [code, out, err] = run.run({"a.i"});
  CHECK(code == 0);
  // Momentum balance takes the motion, a hit without rebound; a spring gives it back, though the hit of a
  // mass on a plate of one element lasts four steps, and wherever these fall.
  const double speed = run.column(5).back();
  if (is_elastic) {
    CHECK(speed == Approx(1.0).epsilon(0.02));
    CHECK_THAT(err, !Contains("contact-energy"));
    const std::vector<double> time = run.column(0), force = run.column(4);
    double impulse = 0.0;
    for (std::size_t i = 1; i + 1 < time.size(); ++i) impulse += 0.5 * (time[i + 1] - time[i - 1]) * force[i];
    CHECK(impulse == Approx(10.0).epsilon(0.02));
  } else {
    CHECK(std::abs(speed) < 1e-6);
  }
}

TEST_CASE("what has touched and may not part pulls, through a restart too", "[app][domain]") {
  const std::string store = "begin restart data\nat step 0 increment = 2\n";
  Setup setup{.region = falling + store + "end\n",
              .contact = defaults(any_form() + general + "separation = off\n"),
              .end_time = "0.4"};
  const Domain run(two_cubes(), setup);
  REQUIRE(run.run({"a.i"}).exit_code == 0);
  CHECK(std::ranges::min(run.column(4)) < -10.0);
  const std::string straight = run.read("a.csv");
  setup.region = falling + store + "restart time = 0.2\nend\n";
  run.write_deck(setup);
  const auto [code, out, err] = run.run({"a.i"});
  INFO(err);
  REQUIRE(code == 0);
  const std::string whole = run.read("a.csv-s0002"), rest = whole.substr(whole.find('\n') + 1);
  REQUIRE(rest.size() > 100);
  CHECK(rest == straight.substr(straight.size() - rest.size()));
}

TEST_CASE("turns of interactions give the same bits for any threads", "[app][domain]") {
  // Pressed in t1, with friction of one and then of the other.
  const std::string contact = defaults(any_form() + general) + interaction("friction coefficient = 0.1\n") +
                              interaction("friction coefficient = 0.4\nactive periods = t2\n");
  const std::string slanting =
      falling + "begin initial velocity\nblock = high\ncomponent = x\nmagnitude = 0.5\nend\n";
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1, .name = "low", .size = {2, 1, 1}})
                        .add_hexes({.id = 2, .name = "high", .origin = {0.3, 0, 1.005}, .share_nodes = false})
                        .build();
  const Domain run(mesh, {.region = slanting, .contact = contact});
  REQUIRE(run.run({"a.i"}).exit_code == 0);
  const std::string straight = run.read("a.csv");
  CHECK(run.peak_force() > 1000.0);
  REQUIRE(run.run({"a.i", "--threads", "2"}).exit_code == 0);
  CHECK(run.read("a.csv") == straight);
}
