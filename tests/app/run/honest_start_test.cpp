// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/program.hpp"
#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

// What a run says of a mesh before its first step: overlap, flat elements, what has no size or stiffness.

using Catch::Matchers::Contains;
using contactsim::Mesh;
using contactsim::test::MeshBuilder;
using contactsim::test::ProgramDirectory;

namespace honest_start_test {

namespace {

constexpr const char* general = "begin interaction defaults\ngeneral contact = on\nend\n";

/// A directory with a mesh and a deck in which block_1 and block_2 are elastic.
struct TwoParts : ProgramDirectory {
  ///   of_contact   lines of the contact definition
  ///   of_region    further lines of the region
  ///   of_blocks    lines of the blocks' parameters
  ///   of_sections  sections
  explicit TwoParts(const Mesh& mesh, const std::string& of_contact = "skin all blocks = on\n",
                    const std::string& of_region = "", const std::string& of_blocks = "",
                    const std::string& of_sections = "") {
    contactsim::test::write_exodus(path("a.g"), mesh);
    const std::string material = "material = m\nmodel = elastic\n";
    write("a.i",
          "begin sierra\nbegin material m\ndensity = 1000\nbegin parameters for model elastic\n"
          "youngs modulus = 1e8\npoissons ratio = 0.3\nend\nend\n" +
              of_sections + "begin finite element model f\nbegin parameters for block block_1\n" + material +
              "end\nbegin parameters for block block_2\n" + material + of_blocks +
              "end\nend\n"
              "begin presto procedure p\nbegin time control\nbegin time stepping block t\n"
              "start time = 0\nend\ntermination time = 2e-3\nend\n"
              "begin presto region r\nuse finite element model f\n" +
              of_region + "begin contact definition c\n" + of_contact + general + "end\nend\nend\nend\n");
  }
};

/// A block of cells of 0.25 and a narrower one on top, lowered into it.
Mesh two_blocks(double depth) {
  return MeshBuilder()
      .add_hexes({.id = 1, .cells = {4, 4, 4}})
      .add_hexes({.id = 2,
                  .cells = {2, 2, 4},
                  .origin = {0.25, 0.25, 1.0 - depth},
                  .size = {0.5, 0.5, 1.0},
                  .share_nodes = false})
      .build();
}

const std::string removal = "skin all blocks = on\ninitial overlap removal = on\n";
const std::string held = "begin fixed displacement\nblock = block_1\ncomponents = x y z\nend\n";

std::size_t count(const std::string& text, const std::string& what) {
  std::size_t n = 0;
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1)) ++n;
  return n;
}

}  // namespace

TEST_CASE("overlap at the start is reported with pair, nodes, depth and the line that removes it",
          "[app][overlap]") {
  const TwoParts parts(two_blocks(0.05));
  const bool is_check = GENERATE(true, false);
  const auto [code, out, err] = is_check ? parts.run({"a.i", "--check"}) : parts.run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Overlap at the start\n"));
  CHECK_THAT(err, Contains("'block_1' and 'block_2' overlap at the start: 18 nodes behind") &&
                      Contains("deepest by 0.05 at node ") && Contains("INITIAL OVERLAP REMOVAL = ON") &&
                      Contains("[overlap-at-start]"));
  if (is_check) return;
  CHECK_THAT(out,
             Contains("put in by the start, overlaps") && !Contains("put in by the start, overlaps    0.0"));
  CHECK_THAT(err, !Contains("contact has given out"));
}

TEST_CASE("blocks that only touch start without a word", "[app][overlap]") {
  const auto [code, out, err] = TwoParts(two_blocks(0.0)).run({"a.i"});
  CHECK(code == 0);
  CHECK(err == "");
  CHECK_THAT(out, !Contains("Overlap at the start"));
}

TEST_CASE("overlap deeper than half an element is reported, and removed when asked", "[app][overlap]") {
  const auto reported = TwoParts(two_blocks(0.2)).run({"a.i", "--check"});
  CHECK(reported.exit_code == 0);
  CHECK_THAT(reported.err, Contains("deepest by 0.2 at node ") && Contains("deeper than half an element"));
  const auto removed = TwoParts(two_blocks(0.2), removal, held).run({"a.i"});
  CHECK(removed.exit_code == 0);
  CHECK(removed.err == "");
  CHECK_THAT(removed.out, Contains("bodies that lay deep in others went apart as wholes"));
}

TEST_CASE("overlap removal that would turn elements inside out stops with the pair's name",
          "[app][overlap]") {
  // A node of the upper block is held along x: its surface may go, the block as a whole may not.
  const std::string half_held = held + "begin fixed displacement\nnode = 170\ncomponents = x\nend\n";
  const std::string deep = removal + "begin remove initial overlap\noverlap normal tolerance = 1\nend\n";
  const TwoParts parts(two_blocks(0.3), deep, half_held);
  const auto [code, out, err] = GENERATE(true, false) ? parts.run({"a.i", "--check"}) : parts.run({"a.i"});
  CHECK(code == 4);
  CHECK_THAT(err, Contains("overlap removal between 'block_1' and 'block_2' would turn") &&
                      Contains("inside out") && Contains("of block_2"));
}

TEST_CASE("flat elements end a check and a run with code 3, block and id", "[app][program]") {
  auto parts = MeshBuilder()
                   .add_hexes({.id = 1})
                   .add_hexes({.id = 2, .origin = {0, 0, 2}, .size = {1, 1, 0}, .share_nodes = false})
                   .parts();
  const TwoParts flat{Mesh(parts)};
  const auto [code, out, err] = GENERATE(true, false) ? flat.run({"a.i", "--check"}) : flat.run({"a.i"});
  CHECK(code == 3);
  CHECK_THAT(err, Contains("1 element is without volume:\n  block_2: element 2: volume 0"));
}

TEST_CASE("shells as thick as no number are refused by node, without contact by block", "[app][program]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).add_shells({.id = 2, .origin = {0, 0, 3}}).build();
  const auto run = [&](const std::string& of_contact) {
    const TwoParts sheet(mesh, of_contact, "", "section = s\n",
                         "begin shell section s\nthickness = 1e200\nend\n");
    return sheet.run({"a.i", "--check"});
  };
  const auto searched = run("skin all blocks = on\n");
  CHECK(searched.exit_code == 3);
  CHECK_THAT(searched.err, Contains("farther than contact searches") && Contains("thickness"));
  const auto apart = run("contact surface a contains block_1\n");
  CHECK(apart.exit_code == 2);
  CHECK_THAT(apart.err, Contains("block_2: element 2 is too heavy to move"));
}

TEST_CASE("what a contact offset has overlap at the start is reported, and put in by the start",
          "[app][overlap]") {
  const std::string by_offset =
      "skin all blocks = on\nbegin interaction\nsurfaces = block_1 block_2\ncontact offset = 0.04\n";
  const auto run = [&](const std::string& more) {
    return TwoParts(two_blocks(-0.03), by_offset + more + "end\n", held).run({"a.i"});
  };
  const auto balanced = run("");
  CHECK(balanced.exit_code == 0);
  CHECK_THAT(balanced.err, Contains("'block_1' and 'block_2' overlap by 0.01 at the start, by their CONTACT "
                                    "OFFSET of 0.04") &&
                               Contains("[offset-overlap]") && !Contains("has given out"));
  CHECK_THAT(balanced.out, !Contains("put in by the start, overlaps    0.0"));
  const auto elastic = run("enforcement = penalty\n");
  CHECK_THAT(elastic.err, Contains("[offset-overlap]") && Contains("; contact stores "));
  CHECK_THAT(run("ignore initial overlap = on\n").err, !Contains("offset-overlap"));
}

TEST_CASE("a model of particles alone runs", "[app][transient]") {
  const Mesh mesh = MeshBuilder()
                        .add_spheres(1, "", {{0, 0, 0}})
                        .add_spheres(2, "", {{0, 0, 0.25}})
                        .set_attributes(1, {"radius"}, {0.1})
                        .set_attributes(2, {"radius"}, {0.1})
                        .build();
  const std::string towards =
      "begin initial velocity\nblock = block_2\ncomponent = z\nmagnitude = -100\nend\n";
  const auto [code, out, err] = TwoParts(mesh, "skin all blocks = on\n", towards).run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Contact of pairs in the run") && !Contains("inf"));
}

TEST_CASE("a component of a variable that is written already is an error at its line", "[app][output]") {
  const std::string results =
      "begin results output\ndatabase name = a.e\nat time 0 increment = 1e-3\nelement stress\n"
      "element stress(zz)\nend\n";
  const auto [code, out, err] = TwoParts(two_blocks(0.0), "skin all blocks = on\n", results).run({"a.i"});
  CHECK(code == 2);
  CHECK_THAT(err, Contains("a.i:32:9: error") && Contains("stress_zz"));
}

TEST_CASE("SKIN ALL BLOCKS passes over point masses, and the table tells", "[app][surfaces]") {
  const Mesh mesh = MeshBuilder().add_hexes({.id = 1}).add_spheres(2, "", {{0, 0, 5}}).build();
  const auto [code, out, err] = TwoParts(mesh, "skin all blocks = on\n", "", "section = s\n",
                                         "begin point mass section s\nmass = 1\nend\n")
                                    .run({"a.i", "--check"});
  CHECK(code == 0);
  CHECK_THAT(
      out,
      Contains(
          "passed over, as point masses, springs, dampers and cohesive elements have no surface: block_2"));
}

TEST_CASE("SKIN ALL BLOCKS passes over cohesive elements", "[app][surfaces]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {0, 0, 1}, .size = {1, 1, 0.01}})
                        .build();
  const auto [code, out, err] =
      TwoParts(mesh, "skin all blocks = on\n", "", "section = s\n", "begin cohesive section s\nend\n")
          .run({"a.i", "--check"});
  CHECK_THAT(out, Contains("cohesive elements have no surface: block_2"));
  CHECK_THAT(err, !Contains("surface-empty"));
}

TEST_CASE("a point mass in a contact node set is pushed", "[app][transient]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_spheres(2, "", {{0.4, 0.4, 1.01}})
                        .add_node_set(1, "", [](const Eigen::Vector3d& x) { return x.z() > 1.0; })
                        .build();
  const std::string lines =
      "contact surface box contains block_1\ncontact node set dot contains nodelist_1\n";
  const std::string towards =
      held + "begin initial velocity\nblock = block_2\ncomponent = z\nmagnitude = -10\nend\n";
  const auto [code, out, err] =
      TwoParts(mesh, lines, towards, "section = s\n", "begin point mass section s\nmass = 1\nend\n")
          .run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("Contact of pairs in the run") && !Contains("Pairs that never touched"));
}

TEST_CASE("a surface that is wrong by the deck alone is reported once", "[app][surfaces]") {
  const TwoParts parts(two_blocks(0.0),
                       "contact surface a contains block_1\ncontact surface a contains block_2\n"
                       "begin contact surface nothing\nend\n");
  const auto [code, out, err] = parts.run({"a.i", "--check"});
  CHECK(code == 2);
  CHECK(count(err, "a.i:29:") == 1);
  CHECK(count(err, "a.i:30:") == 1);
}

TEST_CASE("the log tells the memory of contact, per face too", "[app][report]") {
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1, .cells = {20, 20, 20}})
                        .add_hexes({.id = 2, .origin = {0, 0, 9}, .share_nodes = false})
                        .build();
  const auto [code, out, err] = TwoParts(mesh).run({"a.i"});
  CHECK(code == 0);
  CHECK_THAT(out, Contains("block_1               SKIN ALL BLOCKS") && Contains("2400"));
  const std::size_t at = out.find("  contact takes ");
  REQUIRE(at != std::string::npos);
  const std::size_t bytes = std::stoull(out.substr(at + 16));
  // 2406 faces of 411 bytes each, as FACE_FACE takes by the README.
  CHECK(bytes > 0.8 * 411 * 2406);
  CHECK(bytes < 1.2 * 411 * 2406);
}

TEST_CASE("a smoothed surface that is strained by more than a tenth is reported", "[app][smoothing]") {
  const double way = GENERATE(0.05, 0.2);
  const Mesh mesh = MeshBuilder()
                        .add_hexes({.id = 1})
                        .add_hexes({.id = 2, .origin = {0, 0, 1.1}, .share_nodes = false})
                        .build();
  const std::string round =
      "skin all blocks = on\nbegin surface smoothing ball\nsurface = block_1\nspherical center = 0.5 0.5 "
      "0.5\nend\n"
      "begin interaction\nsurfaces = block_1 block_2\nsmoothing = ball\nend\n";
  const std::string stretch =
      "begin prescribed displacement\nnode = 2\ncomponent = x\nfunction = f\nscale factor = " +
      std::to_string(way) + "\nend\n";
  const std::string function =
      "begin function f\ntype is analytic\nevaluate expression is \"500 * x\"\nend\n";
  const auto [code, out, err] = TwoParts(mesh, round, stretch, "", function).run({"a.i"});
  CHECK(code == 0);
  const bool is_reported = err.find("[smoothing-strained]") != std::string::npos;
  CHECK(is_reported == (way > 0.1));
}

}  // namespace honest_start_test
