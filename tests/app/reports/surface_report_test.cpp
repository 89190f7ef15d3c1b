// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/surface_report.hpp"

#include <fmt/format.h>

#include "support/catch.hpp"
#include "support/program_run.hpp"

using contactsim::test::ProgramDirectory;
using contactsim::test::read_bytes;

namespace {

/// The files that one run with these arguments makes, and what it prints.
struct Run {
  std::string out, err, json, csv, exodus;
  bool operator==(const Run&) const = default;
};

Run run_two_blocks(const std::string& order, const std::string& n_threads) {
  const contactsim::test::TwoBlocks directory;
  const auto [code, out, err] =
      directory.run({"two_blocks.i", "--tables", "-D", "order=" + order, "--threads", n_threads,
                     "--surfaces-json", "s.json", "--surfaces-csv", "s.csv", "--surfaces", "s.exo"});
  REQUIRE(code == 0);
  return {out, err, directory.read("s.json"), directory.read("s.csv"), directory.read("s.exo")};
}

std::string expected(const std::string& file) {
  return read_bytes(std::string(CONTACTSIM_SOURCE_DIR) + "/tests/app/reports/expected/" + file);
}

/// A brick of decks/two_blocks.g: 4 x 4 x 2 cells of size 1, i fastest, then j, then k.
struct Brick {
  std::string name;
  int first_element;  ///< Exodus id
  int joint_side;     ///< side 2 (+x) or 4 (-x) of the cells at the joint
  int first_covered;  ///< cells of the top with i from here on lie under the shell
};

bool is_patch(const Brick& brick, int i, int j) {
  return (j == 1 || j == 2) && (brick.joint_side == 2 ? i >= 2 : i < 2);
}

/// Whether a side of a cell is on the outside: the sides of a HEX8 are -y, +x, +y, -x, -z, +z.
bool is_skin(const Brick& brick, int i, int j, int k, int side) {
  if (side == brick.joint_side) return false;
  const bool is_outside[] = {j == 0, i == 3, j == 3, i == 0, k == 0, k == 1 && i < brick.first_covered};
  return is_outside[side - 1];
}

std::string brick_rows(const Brick& brick, const std::string& surface, bool is_patch_surface,
                       bool has_patch) {
  std::string rows;
  for (int element = 0; element < 32; ++element) {
    const int i = element % 4, j = element / 4 % 4, k = element / 16;
    for (int side = 1; side <= 6; ++side) {
      if (!is_skin(brick, i, j, k, side)) continue;
      const bool is_in_patch = side == 6 && k == 1 && is_patch(brick, i, j);
      if (is_patch_surface ? !is_in_patch : is_in_patch && !has_patch) continue;
      rows += fmt::format("{},{},{},{},face,1\n", surface, brick.name, brick.first_element + element, side);
    }
  }
  return rows;
}

/// The lofted sheet of 2 x 4 shells, 0.1 thick: top, bottom, and the edges that no other shell shares.
std::string cladding_rows() {
  std::string rows;
  for (int shell = 0; shell < 8; ++shell) {
    const int i = shell % 2, j = shell / 2;
    const bool is_rim[] = {j == 0, i == 1, j == 3, i == 0};
    rows += fmt::format("cladding,cladding,{0},1,top,1\ncladding,cladding,{0},2,bottom,1\n", 65 + shell);
    for (int edge = 0; edge < 4; ++edge) {
      if (is_rim[edge]) rows += fmt::format("cladding,cladding,{},{},side,0.1\n", 65 + shell, edge + 3);
    }
  }
  return rows;
}

/// Worked out from the mesh's shape, apart from all code of the program.
std::string expected_csv(bool is_patch_first) {
  const Brick left{"left", 1, 2, 4}, right{"right", 33, 4, 2};
  const std::string skins = brick_rows(left, "left", false, !is_patch_first) +
                            brick_rows(right, "right", false, !is_patch_first) + cladding_rows();
  const std::string patch = brick_rows(left, "top", true, true) + brick_rows(right, "top", true, true);
  return "surface,block,element,side,kind,area\n" + (is_patch_first ? patch + skins : skins);
}

}  // namespace

// The counts in the expected files, by hand: a 4 x 4 x 2 brick has 2 * (16 + 8 + 8) = 64 faces, of which 8
// are the joint: 56. The shell covers 2 x 4 of the right brick's: 48. The patch has 4 on each brick. Nodes: a
// brick has 75, the 9 inside it (3 x 3 x 1) belong to no face, and of the 15 at the joint the 3 off its rim:
// 63 for left; right also loses those only under the shell. The sheet has 8 + 8 facets of area 1 and 12 of
// 0.1.
TEST_CASE("the table of two_blocks.i is as expected in both orders", "[app][report]") {
  CHECK(run_two_blocks("1", "1").out == expected("two_blocks_order1.txt"));
  CHECK(run_two_blocks("2", "1").out == expected("two_blocks_order2.txt"));
}

TEST_CASE("the JSON of two_blocks.i is as expected in both orders", "[app][report]") {
  CHECK(run_two_blocks("1", "1").json == expected("two_blocks_order1.json"));
  CHECK(run_two_blocks("2", "1").json == expected("two_blocks_order2.json"));
}

TEST_CASE("the CSV of two_blocks.i lists exactly the facets that its shape asks for", "[app][report]") {
  CHECK(run_two_blocks("1", "1").csv == expected_csv(true));
  CHECK(run_two_blocks("2", "1").csv == expected_csv(false));
}

TEST_CASE("tables and files are the same bytes on every run and number of threads", "[app][report]") {
  const std::string order = GENERATE("1", "2");
  const Run first = run_two_blocks(order, "1");
  for (const char* n_threads : {"1", "2", "4"}) CHECK(run_two_blocks(order, n_threads) == first);
}

TEST_CASE("names with commas and quotes are quoted in the CSV", "[app][report]") {
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.g"});
  directory.write("a.i",
                  "contact surface 'a,\"b' contains cladding\n"
                  "begin interaction defaults\nself contact = on\nend\n");
  const auto [code, out, err] = directory.run(
      {"a.i", "two_blocks.g", "--check", "--surfaces-csv", "s.csv", "--surfaces-json", "s.json"});
  CHECK(err == "");
  REQUIRE(code == 0);
  CHECK(directory.read("s.csv").starts_with(
      "surface,block,element,side,kind,area\n\"a,\"\"b\",cladding,65,1,top,1\n"));
}

TEST_CASE("the table tells of analytic facets", "[app][report]") {
  const ProgramDirectory directory;
  directory.copy_decks({"two_blocks.g"});
  directory.write("floor.i",
                  "begin analytic object floor\nnormal direction = 0 0 1\nend\n"
                  "begin contact definition\ncontact surface ground contains floor\nend\n");
  const auto [code, out, err] = directory.run({"floor.i", "two_blocks.g", "--check"});
  CHECK(code == 0);
  CHECK_THAT(out, Catch::Contains("\n      analytic facets of ground: 1\n"));
}
