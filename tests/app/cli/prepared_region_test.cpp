// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/prepared_region.hpp"

#include <filesystem>

#include "support/catch.hpp"
#include "support/staged_deck.hpp"
#include "support/two_cube_deck.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

const std::string parts_overlap = two_cube_contact("initial overlap removal = on\n");

/// Two cubes so far apart, a deck of procedures, and what is prepared of each.
struct PreparedDeck : StagedDeck {
  PreparedDeck(double gap, const std::string& procedures)
      : StagedDeck(two_cube_mesh(gap).build(), two_cube_deck(procedures)), regions(chosen()) {}
  PreparedRegion prepare(std::size_t i = 0, bool writes_tables = true) {
    return prepare_region(way(), regions[i], meshes, writes_tables);
  }

  std::vector<ChosenRegion> regions;
  MeshesByModel meshes;
};

/// The least height of the cube high.
double bottom_of(const Mesh& mesh) { return mesh.coordinates().rightCols(8).row(2).minCoeff(); }

}  // namespace

TEST_CASE("a region without contact has its mesh alone, which log and summary tell", "[app][prepare]") {
  PreparedDeck deck(0.1, text_of({}));
  deck.options.summary = "s.json";
  const PreparedRegion prepared = deck.prepare();
  CHECK(prepared.code == ExitCode::done);
  CHECK_FALSE(prepared.contact);
  CHECK(prepared.overlaps.empty());
  REQUIRE(prepared.mesh);
  CHECK(prepared.mesh->n_elements() == 9);
  CHECK(prepared.input(deck.definition).contact == nullptr);
  CHECK(&prepared.input(deck.definition).mesh == prepared.mesh.get());
  CHECK_THAT(deck.logged(), Contains("Mesh " + deck.file("m.g")) && !Contains("Contact surfaces"));
  CHECK(deck.draft.has_mesh);
  REQUIRE(deck.summary.mesh);
  CHECK(deck.summary.mesh->digest.size() == 16);
  CHECK(*deck.summary.mesh->n_elements == 9);
  PreparedDeck quiet(0.1, text_of({}));
  quiet.prepare();
  CHECK_FALSE(quiet.summary.mesh);
}

TEST_CASE("regions of one finite element model share a mesh that is read once", "[app][prepare]") {
  PreparedDeck deck(0.1, text_of({.name = "one"}) + text_of({.name = "two", .start = 0.1, .end = 0.2}));
  REQUIRE(deck.regions.size() == 2);
  const PreparedRegion first = deck.prepare(0);
  std::filesystem::remove(deck.file("m.g"));
  const PreparedRegion second = deck.prepare(1);
  CHECK(first.mesh == second.mesh);
  CHECK(deck.meshes.size() == 1);
}

TEST_CASE("where overlap is removed a region has a mesh of its own, and others theirs as it was",
          "[app][prepare]") {
  PreparedDeck deck(-0.02,
                    text_of({.name = "one", .region = parts_overlap}) +
                        text_of({.name = "two", .start = 0.1, .end = 0.2, .region = two_cube_contact()}));
  const PreparedRegion moved = deck.prepare(0), as_read = deck.prepare(1);
  CHECK(moved.mesh != as_read.mesh);
  CHECK(bottom_of(*as_read.mesh) == Approx(0.98));
  CHECK(bottom_of(*moved.mesh) > 0.985);
  CHECK(moved.overlaps.empty());
  REQUIRE(as_read.overlaps.size() == 1);
  CHECK(as_read.overlaps[0].deepest == Approx(0.02));
  CHECK_THAT(deck.logged(), Contains("Overlap at the start"));
}

TEST_CASE("overlaps are not looked for where a state is taken over", "[app][prepare]") {
  PreparedDeck deck(-0.02, text_of({.name = "one", .region = two_cube_contact()}) +
                               text_of({.name = "two",
                                        .start = 0.1,
                                        .end = 0.2,
                                        .region = two_cube_contact(),
                                        .more = "begin procedural transfer\ninclude all blocks\nend\n"}));
  CHECK(deck.prepare(0).overlaps.size() == 1);
  CHECK(deck.prepare(1).overlaps.empty());
}

TEST_CASE("files of surfaces are those of the region that they are asked of", "[app][prepare]") {
  const bool writes_tables = GENERATE(false, true);
  PreparedDeck deck(-0.02, text_of({.region = two_cube_contact()}));
  deck.options.surfaces_csv = deck.file("no/s.csv");
  const PreparedRegion prepared = deck.prepare(0, writes_tables);
  // One that cannot be written ends the way.
  CHECK(prepared.code == (writes_tables ? ExitCode::file : ExitCode::done));
  CHECK(prepared.overlaps.empty() == writes_tables);
  CHECK(prepared.contact);
  CHECK(deck.summary.n_pairs == 1);
}

TEST_CASE("without contact tables that are asked for are empty, of their region alone", "[app][prepare]") {
  const bool writes_tables = GENERATE(false, true);
  PreparedDeck deck(0.1, text_of({}));
  deck.options.surfaces_csv = deck.file("s.csv");
  CHECK(deck.prepare(0, writes_tables).code == ExitCode::done);
  CHECK(std::filesystem::exists(deck.file("s.csv")) == writes_tables);
}
