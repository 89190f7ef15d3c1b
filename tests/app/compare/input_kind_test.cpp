// SPDX-License-Identifier: BSD-3-Clause
#include "app/compare/input_kind.hpp"

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("the content of a file shows what it is", "[app][compare]") {
  CHECK(find_input_kind("f", "{\"schema\": \"contactsim-surfaces/1\"}") == InputKind::surfaces_json);
  CHECK(find_input_kind("f", "\n {\"schema\": \"contactsim-summary/1\"}") == InputKind::summary);
  CHECK(find_input_kind("f", "surface,block,element,side,kind,area\r\n") == InputKind::surfaces_csv);
  CHECK(find_input_kind("f", "Time, a\n0, 1\n") == InputKind::heartbeat);
  CHECK(find_input_kind("f", "% Sierra SPYHIS Output\nTIME, a\n") == InputKind::heartbeat);
  CHECK(find_input_kind("f", "# a deck\nBegin  Sierra x\nend\n") == InputKind::deck);
  CHECK(find_input_kind("f", "contact surface a contains b\n") == InputKind::deck);
}

TEST_CASE("what cannot be compared is refused with a reason", "[app][compare]") {
  CHECK_THROWS_WITH(find_input_kind("f", " \n"), "f: the file is empty");
  CHECK_THROWS_WITH(find_input_kind("f", "{\"schema\": \"x/1\"}"),
                    "f: JSON of the schema 'x/1', which cannot be compared");
  CHECK_THROWS_WITH(find_input_kind("f", "{\"a\": 1}"), "f: JSON without a schema of contactsim");
  CHECK_THROWS_WITH(find_input_kind("f", "{\"a\": "), "f: no whole JSON, wrong at byte 7 of 6");
  CHECK_THROWS_AS(find_input_kind("f", "%"), FileError);
  CHECK_THROWS_AS(find_input_kind("f", std::string("CDF\1begin \0", 11)), FileError);
}
