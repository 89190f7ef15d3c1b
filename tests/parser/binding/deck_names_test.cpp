// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/deck_names.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/name_at.hpp"

using namespace contactsim;

namespace {

using K = NameKind;

/// A block without content but what it refers to.
void add_block(DeckNames& names, K kind, const DeckName& name,
               const std::vector<NamedKind>& references = {}) {
  names.begin_block("block", kind, name);
  for (const NamedKind& reference : references) names.refer(reference.kind, reference.name);
  names.end_block();
}

std::string resolved(DeckNames& names) {
  Diagnostics diagnostics;
  names.resolve(diagnostics);
  names.report_problems_of_lines(diagnostics);
  return messages(diagnostics);
}

}  // namespace

TEST_CASE("names may be used before they are defined", "[parser][names]") {
  DeckNames names;
  names.refer(K::function, name_at("RAMP", 1));
  add_block(names, K::function, name_at("ramp", 2));
  CHECK(resolved(names) == "");
  CHECK(names.is_used(K::function, name_at("ramp", 2)));
}

TEST_CASE("what stands in an unused definition is not looked up", "[parser][names]") {
  for (const bool is_used : {false, true}) {
    DeckNames names;
    if (is_used) names.refer(K::axis, name_at("spin", 1));
    add_block(names, K::axis, name_at("spin", 2), {{K::point, name_at("p", 3)}});
    CHECK(resolved(names) == (is_used ? "a.i:3:5: error: unknown point 'p'; the deck has no point\n" : ""));
  }
}

TEST_CASE("a chain of definitions is used from its front on", "[parser][names]") {
  DeckNames names;
  add_block(names, K::section, name_at("s", 1), {{K::rigid_body, name_at("b", 1)}});
  add_block(names, K::rigid_body, name_at("b", 2), {{K::axis, name_at("a", 2)}});
  add_block(names, K::axis, name_at("a", 3), {{K::point, name_at("p", 3)}});
  CHECK(resolved(names) == "");
  Diagnostics diagnostics;
  names.use(K::section, name_at("S", 4), diagnostics);
  CHECK(messages(diagnostics) == "a.i:3:5: error: unknown point 'p'; the deck has no point\n");
}

TEST_CASE("problems of a block as a whole count when it is used", "[parser][names]") {
  DeckNames names;
  names.begin_block("spring weld model", K::friction_model, name_at("weld", 1));
  names.add_problem_of_block("has no spring");
  names.end_block();
  names.begin_block("spot weld", std::nullopt, name_at("w", 2));
  names.add_problem_of_block("has no nodes", "give it some");
  names.end_block();
  CHECK(resolved(names) == "a.i:2:5: error: the spot weld 'w' has no nodes; give it some\n");
  Diagnostics diagnostics;
  names.use_all(K::friction_model, diagnostics);
  CHECK(messages(diagnostics) == "a.i:1:5: error: the friction model 'weld' has no spring\n");
}

TEST_CASE("names of a procedure are known in its regions alone", "[parser][names]") {
  DeckNames names;
  for (const char* procedure : {"p", "q"}) {
    names.begin_block("procedure", K::procedure, name_at(procedure, 1));
    names.begin_block("time control", std::nullopt, name_at("", 2));
    add_block(names, K::time_stepping_block, name_at(std::string(procedure) + "_start", 3));
    names.end_block();
    names.begin_block("region", K::region, name_at("r", 4));
    names.refer(K::time_stepping_block, name_at("q_start", 5));
    names.end_block();
    names.end_block();
  }
  CHECK(resolved(names) ==
        "a.i:5:5: error: unknown time stepping block 'q_start'; did you mean 'p_start'?\n");
}

TEST_CASE("a model is one of the material that the same block names", "[parser][names]") {
  DeckNames names;
  names.begin_block("material", K::material, name_at("steel", 1));
  add_block(names, K::model, name_at("elastic", 2));
  names.end_block();
  names.begin_block("parameters", std::nullopt, name_at("", 3));
  names.refer(K::model, name_at("elastik", 4));
  names.refer(K::material, name_at("STEEL", 5));
  names.end_block();
  names.begin_block("parameters", std::nullopt, name_at("", 6));
  names.refer(K::model, name_at("elastic", 7));
  names.end_block();
  CHECK(resolved(names) ==
        "a.i:4:5: error: unknown model 'elastik' of the material 'steel'; did you mean 'elastic'?\n"
        "a.i:7:5: error: the model 'elastic' is chosen without a material; add MATERIAL = <material>\n");
}

TEST_CASE("a dropped block neither defines nor uses anything", "[parser][names]") {
  DeckNames names;
  names.begin_block("contact definition", K::contact_definition, name_at("", 1));
  add_block(names, K::contact_surface, name_at("s", 2));
  names.refer(K::direction, name_at("d", 3));
  names.drop_block();
  names.end_block();
  CHECK(resolved(names) == "");
}

TEST_CASE("names that the mesh gives are not asked for", "[parser][names]") {
  DeckNames names;
  names.refer(K::node_set, name_at("n", 1));
  names.note("skin all blocks", {{}, {}, {K::contact_surface}});
  names.refer(K::contact_surface, name_at("block_1", 2));
  CHECK(resolved(names) == "");
}

TEST_CASE("a material is no friction model", "[parser][names]") {
  DeckNames names;
  add_block(names, K::material, name_at("glue", 1));
  names.refer(K::friction_model, name_at("Glue", 2));
  CHECK(
      resolved(names) ==
      "a.i:2:5: error: 'Glue' is a material, not a friction model; cohesive materials as friction models are "
      "not supported\n");
}
