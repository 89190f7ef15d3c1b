// SPDX-License-Identifier: BSD-3-Clause
#include "parser/deck.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

namespace {

const char* const drop = R"(begin sierra drop
  begin material steel
    density = 7850
    begin parameters for model elastic
      youngs modulus = 206e9
      poissons ratio = 0.3
    end
  end
  begin finite element model mesh
    database name = drop.g
    database type = exodusII
    begin parameters for block block_1 block_2
      material = steel
      model = elastic
    end
  end
  begin presto procedure p
    begin time control
      begin time stepping block t1
        start time = 0.0
        begin parameters for presto region r
          time step scale factor = 0.8
        end
      end
      termination time = 1.0e-3
    end
    begin presto region r
      use finite element model mesh
      begin contact definition
        contact surface patch contains surface_3
        skin all blocks = on
      end
    end
  end
end
)";

}  // namespace

TEST_CASE("a full deck is bound into the definition tree", "[parser][deck]") {
  const auto [simulation, said] = parsed(drop);
  REQUIRE(said == "");
  CHECK(simulation.form == DeckForm::full);
  CHECK(simulation.name.text == "drop");
  CHECK(simulation.deck_base == "a");
  REQUIRE(simulation.materials.size() == 1);
  CHECK(simulation.materials[0].density == 7850.0);
  REQUIRE(simulation.procedures.size() == 1);
  const Procedure& procedure = simulation.procedures[0];
  CHECK_FALSE(procedure.implicit_by);
  REQUIRE(procedure.time_control);
  CHECK(procedure.time_control->termination_time == 1e-3);
  CHECK(procedure.time_control->time_stepping_blocks.at(0).explicit_parameters.at(0).time_step_scale_factor ==
        0.8);
  REQUIRE(regions_with_contact(simulation).size() == 1);
  const Region& region = *regions_with_contact(simulation)[0];
  CHECK(region.contact->surface_commands.size() == 2);
  CHECK(mesh_path(simulation, region) == "drop.g");
}

TEST_CASE("a deck of contact commands alone is accepted", "[parser][deck]") {
  const auto [simulation, said] = parsed(
      "contact surface a contains block_1\n"
      "begin shell section thin\n  thickness = 0.1\nend\n"
      "skin all blocks = on\n");
  REQUIRE(said == "");
  CHECK(simulation.form == DeckForm::contact_commands);
  REQUIRE(regions_with_contact(simulation).size() == 1);
  CHECK(regions_with_contact(simulation)[0]->contact->surface_commands.size() == 2);
  CHECK(simulation.sections.size() == 1);
  CHECK(mesh_path(simulation, *regions_with_contact(simulation)[0]) == "a.g");
}

TEST_CASE("a deck of one contact definition alone is accepted", "[parser][deck]") {
  const auto [simulation, said] = parsed(
      "begin finite element model m\n  database name = %B_fine.g\nend\n"
      "begin analytic object floor\n  type = plane\n  normal direction = 0 0 1\nend\n"
      "begin contact definition c\n  contact surface a contains block_1 floor\nend\n");
  REQUIRE(said == "");
  CHECK(simulation.form == DeckForm::contact_definition);
  REQUIRE(regions_with_contact(simulation).size() == 1);
  const Region& region = *regions_with_contact(simulation)[0];
  CHECK(region.contact->name.text == "c");
  CHECK(region.analytic_planes.size() == 1);
  CHECK(mesh_path(simulation, region) == "a_fine.g");
}

TEST_CASE("contact commands beside a contact definition are not understood", "[parser][deck]") {
  CHECK(parsed("begin contact definition\nend\ncontact surface a contains b\n").messages ==
        "a.i:3:1: error: unknown command 'contact surface a contains ...' in the deck's top level; "
        "it belongs into BEGIN CONTACT DEFINITION\n");
}

TEST_CASE("what stands outside the SIERRA block is not understood", "[parser][deck]") {
  CHECK(parsed("begin sierra\nend\nbegin sierra two\nend\ntitle x\n").messages ==
        "a.i:3:1: error: a second BEGIN SIERRA in one deck; the first stands at a.i:1:1\n"
        "a.i:5:1: error: unknown command 'title x' in the deck's top level; it belongs into BEGIN SIERRA\n");
}

TEST_CASE("a misspelt SIERRA block is recognised", "[parser][deck]") {
  CHECK(parsed("begin siera\nend\n").messages ==
        "a.i:1:7: error: unknown block 'siera' in the deck's top level; did you mean 'begin sierra'?\n");
}

TEST_CASE("an empty deck is an error", "[parser][deck]") {
  CHECK(parsed("# nothing\n").messages ==
        "error: a.i: the deck is empty; it should have a BEGIN SIERRA block\n");
}

TEST_CASE("a deck file that is not there is a file error", "[parser][deck]") {
  Diagnostics diagnostics;
  CHECK_THROWS_AS(parse_deck("no/such/deck.i", {}, diagnostics), FileError);
}

TEST_CASE("all problems of a deck are reported in one run, in the order of its lines", "[parser][deck]") {
  CHECK(
      parsed_sierra("begin material steel\n"
                    "  densty = 1\n"
                    "  density = heavy\n"
                    "end\n"
                    "begin presto procedure p\n"
                    "  begin time control\n"
                    "    termination time = 1\n"
                    "  end\n"
                    "  begin presto region r\n"
                    "    use finite element model m\n"
                    "  end\n"
                    "end\n")
          .messages ==
      "a.i:3:3: warning: unknown command 'densty = 1' in 'material steel', but nothing uses this definition; "
      "did you mean 'density'? [deck-unused]\n"
      "a.i:4:13: warning: expected a number for 'density', found 'heavy', but nothing uses this definition "
      "[deck-unused]\n"
      "a.i:7:3: error: the time control has no TIME STEPPING BLOCK; add BEGIN TIME STEPPING BLOCK <name>\n"
      "a.i:11:30: error: unknown finite element model 'm'; the deck has no finite element model\n");
}

TEST_CASE("a lenient reading turns unknown and refused commands into warnings", "[parser][deck]") {
  ParseOptions options;
  options.is_lenient = true;
  CHECK(parsed_sierra("frobnicate = 3\n", options).messages ==
        "a.i:2:1: warning: unknown command 'frobnicate = 3' in 'sierra', passed over [deck-unknown]\n");
}

TEST_CASE("an END too many is one error, and its cause stands first", "[parser][deck]") {
  std::string deck = drop;
  deck.insert(deck.find("  begin finite element model"), "end\n");
  const auto [simulation, said] = parsed(deck);
  CHECK(said.find("this block stands behind the end of the SIERRA block; an END too many") !=
        std::string::npos);
  CHECK(said.find("unknown") == std::string::npos);
}

TEST_CASE("a deck of another program is refused also where the user is lenient", "[parser][deck]") {
  Diagnostics found;
  ParseOptions options;
  options.is_lenient = true;
  parse_deck_text("a.inp", "*HEADING\n*NODE\n1, 0, 0, 0\n", options, found);
  CHECK(found.error_count() == 1);
  CHECK(messages(found).find(
            "error: a.inp: nothing in this deck is of Sierra/SM; it should have a BEGIN SIERRA") !=
        std::string::npos);
}

TEST_CASE("a BEGIN without a type is reported once, where it stands", "[parser][deck]") {
  CHECK(parsed("begin\nend\n").messages == "a.i:1:1: error: BEGIN needs the type of a block\n");
  CHECK(parsed_sierra("begin # function\nend\n").messages ==
        "a.i:2:1: error: BEGIN needs the type of a block\n");
}
