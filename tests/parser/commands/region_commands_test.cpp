// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/region_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("a region uses a finite element model, before or after other lines", "[parser][region]") {
  const BoundRegion bound = bound_region("begin contact definition\nend\nuse finite element model mesh\n");
  CHECK(bound.messages == "");
  CHECK(bound.region.finite_element_model->text == "mesh");
  CHECK(to_string(bound.region.finite_element_model->location) == "a.i:3:26");
}

TEST_CASE("other model coordinates are refused", "[parser][region]") {
  CHECK(bound_region("use finite element model mesh model coordinates are c\n").messages ==
        "a.i:1:31: error: 'MODEL COORDINATES ARE' is not supported, the mesh's own coordinates are taken\n");
  CHECK(bound_region("use finite element model mesh modl\n").messages ==
        "a.i:1:31: error: expected 'model' in 'use finite element model', found 'modl'; did you mean "
        "'model'?\n");
}

TEST_CASE("a model is used once", "[parser][region]") {
  CHECK(bound_region("use finite element model a\nuse finite element model b\n").messages ==
        "a.i:2:1: warning: 'use finite element model' is given twice in one block, this one "
        "counts; the other stands at a.i:1:1 [deck-repeated]\n");
}

TEST_CASE("lines of a region without effect are ignored", "[parser][region]") {
  const std::string line = GENERATE("logfile precision = 8", "global energy reporting = exact",
                                    "extensive global vars x", "extensive rigid body vars output = on");
  const std::string found = bound_region(line + "\n").messages;
  CHECK(found.find("a.i:1:1: warning: ") == 0);
  CHECK(found.find("[deck-ignored]") != std::string::npos);
}

TEST_CASE("older analytic surfaces are refused with a hint", "[parser][region]") {
  CHECK(bound_region("begin analytic cylinder c\n radius = 1\nend\n").messages ==
        "a.i:1:7: error: block 'analytic cylinder' is not supported and would change the answer; "
        "only planes are known: Write BEGIN ANALYTIC OBJECT, TYPE = PLANE\n");
}

TEST_CASE("an unknown line of a region is reported with the nearest known one, and the rest is read",
          "[parser][region]") {
  const BoundRegion bound = bound_region(
      "begin fixd displacement\n node set = n\nend\nbegin gravity\n componet = z\n gravitational constant = "
      "9.81\nend\n");
  CHECK(
      bound.messages ==
      "a.i:1:7: error: unknown block 'fixd displacement' in the deck's top level; did you mean 'begin fixed "
      "displacement'?\n"
      "a.i:5:2: error: unknown command 'componet = z' in 'gravity'; did you mean 'component'?\n");
  CHECK(bound.region.gravities.at(0).gravitational_constant == 9.81);
}
