// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/known_names.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/name_at.hpp"

using namespace contactsim;

TEST_CASE("names are found in any case", "[parser][names]") {
  KnownNames names("function");
  Diagnostics diagnostics;
  names.define(name_at("Ramp", 1), 7, diagnostics);
  names.define(name_at("hold", 2), 8, diagnostics);
  CHECK(names.look_up(name_at("RAMP", 3), diagnostics) == std::vector<std::size_t>{7});
  CHECK(names.find("hold") == std::vector<std::size_t>{8});
  CHECK(names.find("nothing").empty());
  CHECK(names.knows("HOLD"));
  CHECK(diagnostics.empty());
}

TEST_CASE("an unknown name is reported with the nearest known one", "[parser][names]") {
  KnownNames names("function");
  Diagnostics diagnostics;
  CHECK(names.look_up(name_at("ramp", 1), diagnostics).empty());
  names.define(name_at("Ramp", 2), 0, diagnostics);
  CHECK(names.look_up(name_at("rmap", 3), diagnostics).empty());
  CHECK(messages(diagnostics) ==
        "a.i:1:5: error: unknown function 'ramp'; the deck has no function\n"
        "a.i:3:5: error: unknown function 'rmap'; did you mean 'Ramp'?\n");
}

TEST_CASE("a second definition names the place of the first, and stands for the name too",
          "[parser][names]") {
  KnownNames names("material");
  Diagnostics diagnostics;
  names.add_built_in("air");
  names.add_built_in("water", true);
  names.define(name_at("Steel", 1), 1, diagnostics);
  names.define(name_at("STEEL", 2), 2, diagnostics);
  names.define(name_at("AIR", 3), 3, diagnostics);
  names.define(name_at("Water", 3), 4, diagnostics);
  names.define(name_at("", 4), 5, diagnostics);
  CHECK(names.find("steel") == std::vector<std::size_t>{1, 2});
  CHECK(names.find("water") == std::vector<std::size_t>{4});
  CHECK(messages(diagnostics) ==
        "a.i:2:5: error: the material 'STEEL' is defined a second time; the first stands at a.i:1:5\n"
        "a.i:3:5: error: the material 'AIR' is defined a second time; the name is built in\n");
}

TEST_CASE("names of a fragment may be defined elsewhere", "[parser][names]") {
  KnownNames names("function");
  Diagnostics diagnostics;
  names.allow_unknown();
  CHECK(names.look_up(name_at("ramp", 1), diagnostics).empty());
  CHECK(diagnostics.empty());
}
