// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/foreign_keywords.hpp"

#include <set>

#include "support/catch.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/program_run.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Two cubes, a side set and a node set, by the names that the page uses.
Mesh page_mesh() {
  MeshBuilder b;
  b.add_hexes({.id = 1}).add_hexes({.id = 2, .origin = {0, 0, 1.1}, .share_nodes = false});
  b.add_side_set(3, "",
                 [](const CandidateSide& side) { return side.block_id == 1 && side.normal.z() > 0.5; });
  b.add_node_set(1, "", [](const Eigen::Vector3d& x) { return x.z() > 1.05 && x.z() < 1.2; });
  return b.build();
}

/// Lines of ours at their place in a small deck that has all that they name.
std::string deck_with(const ForeignKeyword& row) {
  const std::string lines = std::string(row.lines) + "\n";
  const auto at = [&](DeckPlace place) { return row.place == place ? lines : std::string(); };
  const auto lacks = [&](const char* text) { return lines.find(text) == std::string::npos; };
  std::string contact;
  if (lacks("SURFACE a") && lacks("SET a")) contact += "contact surface a contains block_1\n";
  contact += "contact surface b contains block_2\n";
  contact += "begin constant friction model rub\nfriction coefficient = 0.1\nend\n" + at(DeckPlace::contact);
  contact += "begin surface options\n" + at(DeckPlace::surface_options) + "end\n";
  if (lacks("BEGIN INTERACTION DEFAULTS"))
    contact +=
        "begin interaction defaults\ngeneral contact = on\n" + at(DeckPlace::interaction_defaults) + "end\n";
  if (row.place == DeckPlace::interaction) {
    const bool has_sides = !lacks("NODE_FACE");
    contact += std::string("begin interaction\n") +
               (has_sides ? "side a = a\nside b = b\n" : "surfaces = a b\n") + lines + "end\n";
  }
  std::string death;
  if (row.place == DeckPlace::death)
    death = "begin element death\nblock = block_1\ndeath on inversion = on\n" + lines + "end\n";
  return "begin sierra page\n" + at(DeckPlace::sierra) +
         "begin function f\ntype is piecewise linear\nbegin values\n0 1\n1 0\nend\nend\n"
         "begin function g\ntype is piecewise linear\nbegin values\n0 0\n1 1\nend\nend\n"
         "begin material m\ndensity = 1000\nbegin parameters for model elastic\nyoungs modulus = 1e6\n"
         "poissons ratio = 0.3\nend\nend\nbegin finite element model fem\n"
         "begin parameters for block block_1 block_2\nmaterial = m\nmodel = elastic\nend\nend\n"
         "begin presto procedure p\nbegin time control\nbegin time stepping block t1\nstart time = 0\nend\n"
         "termination time = 1e-4\nend\nbegin presto region r\nuse finite element model fem\n" +
         at(DeckPlace::region) + death +
         "begin results output\ndatabase name = page.e\nat time 0 increment = 1\n" + at(DeckPlace::results) +
         "end\nbegin heartbeat output\nstream name = page.csv\nat step 0 increment = 1\n" +
         at(DeckPlace::heartbeat) + "end\nbegin contact definition\n" + contact + "end\nend\nend\nend\n";
}

}  // namespace

TEST_CASE("every line of ours on the page for users of others runs", "[app][explain]") {
  ProgramDirectory directory;
  write_exodus(directory.path("page.g"), page_mesh());
  std::size_t n_tried = 0;
  for (const ForeignKeyword& row : foreign_keywords()) {
    if (row.place == DeckPlace::none) continue;
    INFO(row.keyword);
    INFO(row.lines);
    directory.write("page.i", deck_with(row));
    const ProgramOutput run = directory.run({"page.i", "page.g"});
    INFO(run.out + run.err);
    CHECK(run.exit_code == 0);
    for (const char* word : {"unknown", "ignored", "did you mean", "is known here", "refused"})
      CHECK_THAT(run.out + run.err, !Contains(word));
    ++n_tried;
  }
  CHECK(n_tried > 70);
}

TEST_CASE("rows of the page are whole and few mean the same", "[app][explain]") {
  std::set<std::pair<std::string_view, std::string_view>> known;
  for (const ForeignKeyword& row : foreign_keywords()) {
    INFO(row.keyword);
    CHECK(known.emplace(row.program, row.keyword).second);
    CHECK((row.place == DeckPlace::none) == row.lines.empty());
    CHECK((!row.lines.empty() || !row.note.empty()));
    CHECK(to_string(row.place).empty() == (row.place == DeckPlace::none));
  }
  for (const LeftOut& row : left_out_rows()) CHECK((!row.what.empty() && !row.why.empty()));
}
