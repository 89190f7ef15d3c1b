// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/known_names.hpp"

#include "support/catch.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;

namespace {

DeckName name_at(const std::string& text, int line) {
  static const auto file = std::make_shared<const SourceFile>(SourceFile{"a.i", "\n\n\n\n"});
  return {text, {file, line, 5, nullptr}};
}

}  // namespace

TEST_CASE("names are found in any case and marked as used", "[parser][names]") {
  KnownNames names("function");
  Diagnostics diagnostics;
  names.define(name_at("Ramp", 1), diagnostics);
  names.define(name_at("hold", 2), diagnostics);
  CHECK(names.use(name_at("RAMP", 3), diagnostics));
  CHECK(names.is_used("ramp"));
  CHECK_FALSE(names.is_used("hold"));
  CHECK_FALSE(names.is_used("nothing"));
  CHECK(diagnostics.empty());
}

TEST_CASE("an unknown name is told with the nearest known one", "[parser][names]") {
  KnownNames names("function");
  Diagnostics diagnostics;
  CHECK_FALSE(names.use(name_at("ramp", 1), diagnostics));
  names.define(name_at("Ramp", 2), diagnostics);
  CHECK_FALSE(names.use(name_at("rmap", 3), diagnostics));
  CHECK(messages(diagnostics) ==
        "a.i:1:5: error: unknown function 'ramp'; the deck has no function\n"
        "a.i:3:5: error: unknown function 'rmap'; did you mean 'Ramp'?\n");
}

TEST_CASE("a second definition names the place of the first", "[parser][names]") {
  KnownNames names("material");
  Diagnostics diagnostics;
  names.add_built_in("air");
  names.define(name_at("Steel", 1), diagnostics);
  names.define(name_at("STEEL", 2), diagnostics);
  names.define(name_at("AIR", 3), diagnostics);
  names.define(name_at("", 4), diagnostics);
  CHECK(messages(diagnostics) ==
        "a.i:2:5: error: the material 'STEEL' is defined a second time; the first stands at a.i:1:5\n"
        "a.i:3:5: error: the material 'AIR' is defined a second time; the name is built in\n");
}

TEST_CASE("names of a fragment may be defined elsewhere", "[parser][names]") {
  KnownNames names("function");
  Diagnostics diagnostics;
  names.allow_unknown();
  CHECK_FALSE(names.use(name_at("ramp", 1), diagnostics));
  CHECK(diagnostics.empty());
}
