// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/read_run_deck.hpp"

#include <algorithm>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

using Definitions = std::vector<std::pair<std::string, std::string>>;

/// A deck a.i in a folder of its own, whose includes are there too.
struct DeckFolder : TemporaryDirectory {
  explicit DeckFolder(const std::string& text) { write_bytes(file("a.i"), text); }
  RunDeck read(const std::vector<std::string>& definitions = {}) {
    return read_run_deck({file("a.i"), definitions, false, path().string()}, found);
  }
  Diagnostics found;
};

/// A procedure of these regions: "name", with a + behind it for contact.
Procedure procedure_of(const std::string& name, const std::vector<std::string>& regions,
                       bool is_implicit = false) {
  Procedure procedure;
  procedure.name.text = name;
  if (is_implicit) procedure.implicit_by = ImplicitCause{};
  for (std::string region_name : regions) {
    Region& region = procedure.regions.emplace_back();
    if (region_name.ends_with('+')) {
      region.contact.emplace();
      region_name.pop_back();
    }
    region.name.text = region_name;
  }
  return procedure;
}

/// "procedure/region" of the one that is chosen, then what is said.
std::string chosen_of(const std::vector<Procedure>& procedures, bool may_pass_over = true) {
  SimulationDefinition definition;
  definition.procedures = procedures;
  Diagnostics said;
  const ChosenRegion chosen = choose_region(definition, may_pass_over, said);
  return chosen.procedure.name.text + "/" + chosen.region.name.text + "\n" + messages(said);
}

std::string all_chosen_of(const std::vector<Procedure>& procedures, bool may_pass_over = true) {
  SimulationDefinition definition;
  definition.procedures = procedures;
  Diagnostics said;
  std::string text;
  for (const ChosenRegion& chosen : choose_regions(definition, may_pass_over, said))
    text += chosen.procedure.name.text + "/" + chosen.region.name.text + "\n";
  return text + messages(said);
}

}  // namespace

TEST_CASE("definitions are cut at their first =", "[app][deck]") {
  CHECK(split_definitions({}).empty());
  CHECK(split_definitions({"a=1", "b=x = y", "c="}) == Definitions{{"a", "1"}, {"b", "x = y"}, {"c", ""}});
  for (const char* wrong : {"", "a", "=1", "="}) {
    try {
      split_definitions({"a=1", wrong});
      FAIL(wrong);
    } catch (const DeckError& error) {
      CHECK(messages(error.diagnostics()) == "error: -D " + std::string(wrong) + ": expected name=value\n");
    }
  }
}

TEST_CASE("includes start from their folder, unless they say from where", "[app][deck]") {
  CHECK(include_path(std::nullopt, "b.i") == "b.i");
  CHECK(include_path("decks", "b.i") == "decks/b.i");
  CHECK(include_path("decks", "/tmp/b.i") == "/tmp/b.i");
}

TEST_CASE("a deck is read with all files that it includes, each listed once", "[app][deck]") {
  DeckFolder folder("{include(\"b.i\")}\n{include(\"b.i\")}\ncontact surface s contains {name}\n");
  write_bytes(folder.file("b.i"), "# {name}\n");
  const RunDeck deck = folder.read({"name=left"});
  CHECK(messages(folder.found) == "");
  REQUIRE(deck.sources.size() == 2);
  CHECK(deck.sources[0].name == folder.file("a.i"));
  CHECK(deck.sources[1].name == "b.i");
  CHECK(deck.sources[1].text == "# {name}\n");
  CHECK(deck.definition.procedures.at(0).regions.at(0).contact);
}

TEST_CASE("the fingerprint of a deck is that of its bytes and of what it includes", "[app][deck]") {
  const auto digest_of_deck = [](const std::string& text, const std::string& included,
                                 const std::vector<std::string>& definitions = {}) {
    DeckFolder folder(text);
    write_bytes(folder.file("b.i"), included);
    return folder.read(definitions).digest;
  };
  const std::string text = "{include(\"b.i\")}\ncontact surface s contains left\n";
  const std::uint64_t digest = digest_of_deck(text, "# b\n");
  CHECK(digest_of_deck(text, "# b\n") == digest);
  CHECK(digest_of_deck(text, "# c\n") != digest);
  CHECK(digest_of_deck(text + " ", "# b\n") != digest);
}

TEST_CASE("a deck that cannot be read says why", "[app][deck]") {
  Diagnostics said;
  const TemporaryDirectory directory;
  CHECK_THROWS_WITH(read_run_deck({directory.file("no.i"), {}, false, std::nullopt}, said),
                    directory.file("no.i") + ": there is no such file");
  DeckFolder folder("{include(\"none.i\")}\n");
  folder.read();
  CHECK(messages(folder.found).find("cannot include 'none.i': there is no such file") != std::string::npos);
  CHECK_THROWS_AS(DeckFolder("x = 1\n").read({"nonsense"}), DeckError);
}

TEST_CASE("contact goes before explicit, explicit before the first", "[app][deck]") {
  const Procedure explicit_one = procedure_of("p", {"r"}), implicit_one = procedure_of("q", {"s"}, true);
  CHECK(merit_of(explicit_one, explicit_one.regions[0]) == 1);
  CHECK(merit_of(implicit_one, implicit_one.regions[0]) == 0);
  CHECK(chosen_of({}) == "/\n");
  CHECK(chosen_of({procedure_of("p", {})}) == "/\n");
  CHECK(chosen_of({procedure_of("p", {"r"})}) == "p/r\n");
  CHECK(chosen_of({implicit_one, explicit_one}).starts_with("p/r\n"));
  CHECK(chosen_of({explicit_one, procedure_of("q", {"s+"}, true)}).starts_with("q/s\n"));
  CHECK(chosen_of({procedure_of("p", {"a", "b"})}).starts_with("p/a\n"));
  CHECK(chosen_of({procedure_of("p", {"a", "b+", "c+"})}).starts_with("p/b\n"));
}

TEST_CASE("regions that are not chosen are reported, or refused", "[app][deck]") {
  const std::vector<Procedure> procedures{procedure_of("p", {"a", "b+"}), procedure_of("q", {"c"})};
  CHECK(chosen_of(procedures) ==
        "p/b\n"
        "warning: the region 'a' is passed over; that of 'b' is taken [deck-region]\n"
        "warning: the procedure 'q' is passed over; that of 'p' is taken [deck-region]\n");
  CHECK(chosen_of(procedures, false) ==
        "p/b\n"
        "error: a second region is not supported here; 'b' would be run without it: make it a deck of its "
        "own, or "
        "pass it over with --lenient\n"
        "error: a second procedure is not supported here; 'p' would be run without it: make it a deck of its "
        "own, "
        "or pass it over with --lenient\n");
}

TEST_CASE("every procedure has a region of its own chosen, one without any is an error", "[app][deck]") {
  CHECK(all_chosen_of({}) == "/\n");
  CHECK(all_chosen_of({procedure_of("p", {})}) == "/\n");
  CHECK(all_chosen_of({procedure_of("p", {"a"}), procedure_of("q", {"b"}, true)}) == "p/a\nq/b\n");
  CHECK(all_chosen_of({procedure_of("p", {"a", "b+"}), procedure_of("q", {"c"})}) ==
        "p/b\nq/c\nwarning: the region 'a' is passed over; that of 'b' is taken [deck-region]\n");
  CHECK(all_chosen_of({procedure_of("p", {"a"}), procedure_of("q", {})}) ==
        "p/a\nerror: the procedure 'q' has no region\n");
}
