// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/implicit_commands.hpp"

#include "support/catch.hpp"
#include "support/parsed_deck.hpp"

using namespace contactsim;

TEST_CASE("an implicit deck binds, and each implicit block is told once", "[parser][implicit]") {
  const ParsedDeck deck = parsed_sierra(
      "begin adagio procedure p\n"
      "  begin adagio region r\n"
      "    use finite element model m\n"
      "    begin solver\n"
      "      begin cg\n"
      "        target relative residual = 1e-4\n"
      "        begin full tangent preconditioner\n"
      "        end\n"
      "      end\n"
      "    end\n"
      "    begin adaptive time stepping\n"
      "      target iterations = 100\n"
      "    end\n"
      "    begin implicit dynamics\n"
      "    end\n"
      "  end\n"
      "end\n"
      "begin gdsw equation solver g\n"
      "end\n"
      "begin finite element model m\nend\n");
  CHECK(deck.messages ==
        "a.i:5:11: warning: block 'solver' has no effect here; implicit only: how equilibrium is found "
        "[deck-ignored]\n"
        "a.i:12:11: warning: block 'adaptive time stepping' has no effect here; implicit only: how the time "
        "step "
        "adapts [deck-ignored]\n"
        "a.i:15:11: warning: block 'implicit dynamics' has no effect here; implicit only: inertia terms "
        "[deck-ignored]\n"
        "a.i:19:7: warning: block 'gdsw equation solver' has no effect here; implicit only: linear equation "
        "solver [deck-ignored]\n");
  CHECK(deck.simulation.procedures.at(0).implicit_by);
}
