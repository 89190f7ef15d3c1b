// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/stabilization_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

TEST_CASE("pairs and their defaults say how much stabilization load steps have", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction defaults\ncontact stabilization = on\nstabilization tangential fraction = 0.5\n"
      "stabilization remaining fraction = 0.01\nstabilization range = 0.3\nend\n"
      "begin interaction\nsurfaces = a b\ncontact stabilization = 20\nstabilization range = auto\nend\n"
      "begin interaction\nsurfaces = a b\ncontact stabilization = off\nend\n");
  CHECK(bound.messages == "");
  const StabilizationSettings& defaults = bound.contact.interaction_defaults.value().pair.stabilization;
  CHECK(defaults == StabilizationSettings{1.0, 0.5, 0.01, 0.3});
  CHECK(defaults.is_on());
  CHECK(bound.contact.interactions.at(0).pair.stabilization.scale == 20.0);
  CHECK_FALSE(bound.contact.interactions.at(1).pair.stabilization.is_on());
  const PairSettings own =
      with_defaults(bound.contact.interactions.at(0).pair, bound.contact.interaction_defaults.value().pair);
  CHECK(own.stabilization.tangential_fraction == 0.5);
  CHECK(own.stabilization.scale == 20.0);
}

TEST_CASE("stabilization is not negative, nor more than whole at its end", "[parser][interaction]") {
  CHECK(bound_contact("begin interaction\nsurfaces = a b\ncontact stabilization = -1\n"
                      "stabilization tangential fraction = -0.1\nstabilization remaining fraction = 1.5\n"
                      "stabilization range = 0\nend\n")
            .messages ==
        "a.i:4:25: error: 'contact stabilization' must not be negative, found '-1'\n"
        "a.i:5:37: error: 'stabilization tangential fraction' must not be negative, found '-0.1'\n"
        "a.i:6:36: error: 'stabilization remaining fraction' must be from 0 to 1, found '1.5'\n"
        "a.i:7:23: error: 'stabilization range' must be greater than 0, found '0'\n");
  CHECK_THAT(
      bound_contact("begin interaction\nsurfaces = a b\nstabilization remaining fraction\nend\n").messages,
      Catch::Contains("a.i:4:") && Catch::Contains("expected a number"));
}

TEST_CASE("stabilization is switched by any word of a switch, or scaled", "[parser][interaction]") {
  const auto scale_of = [](const std::string& value) {
    const BoundContact bound =
        bound_contact("begin interaction\nsurfaces = a b\ncontact stabilization = " + value + "\nend\n");
    CHECK(bound.messages == "");
    return bound.contact.interactions.at(0).pair.stabilization.scale;
  };
  for (const char* word : {"on", "YES", "true"}) CHECK(scale_of(word) == 1.0);
  for (const char* word : {"off", "No", "false"}) CHECK(scale_of(word) == 0.0);
  CHECK(scale_of("0") == 0.0);
  CHECK(scale_of("2.5") == 2.5);
  CHECK(bound_contact("begin interaction\nsurfaces = a b\ncontact stabilization = some\nend\n").messages ==
        "a.i:4:25: error: expected a number for 'contact stabilization', found 'some'\n");
}

TEST_CASE("a range of stabilization may be automatic again", "[parser][interaction]") {
  const BoundContact bound = bound_contact(
      "begin interaction\nsurfaces = a b\nstabilization range = 0.5\nstabilization range = auto\nend\n");
  CHECK_FALSE(bound.contact.interactions.at(0).pair.stabilization.range);
}
