// SPDX-License-Identifier: BSD-3-Clause
#include "contact/surfaces/idle_pair_settings.hpp"

#include <algorithm>

#include "support/catch.hpp"
#include "support/contact_deck.hpp"
#include "support/deck_dump.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

std::string said_of(const std::string& lines, bool is_static) {
  ContactDefinition contact = parse_contact(lines);
  contact.enforcement.is_static = is_static;
  Diagnostics said;
  warn_of_idle_pair_settings(contact, said);
  return messages(said);
}

}  // namespace

TEST_CASE("ways of enforcement of other procedures have no effect, which is reported", "[contact][pairs]") {
  const std::string lagrange = "begin interaction defaults\nenforcement = augmented_lagrange\nend\n";
  CHECK(said_of(lagrange, true) == "");
  const std::string said = said_of(lagrange, false);
  CHECK_THAT(said,
             Contains("warning: ENFORCEMENT = AUGMENTED_LAGRANGE has no effect in an explicit procedure") &&
                 Contains("[enforcement-of-other-procedures]"));
  CHECK(std::ranges::count(said, '\n') == 1);
  const std::string balance =
      "enforcement = momentum_balance\nbegin interaction defaults\nenforcement = momentum_balance\nend\n";
  CHECK(said_of(balance, false) == "");
  const std::string both = said_of(balance, true);
  CHECK_THAT(both, Contains("ENFORCEMENT = MOMENTUM_BALANCE has no effect in a quasi-static procedure"));
  CHECK(std::ranges::count(both, '\n') == 2);
  CHECK(said_of("enforcement = penalty\n", true) == "");
}

TEST_CASE("contact stabilization has no effect where inertia holds bodies, which is reported",
          "[contact][pairs]") {
  const auto said = [](bool is_static, double scale) {
    ContactDefinition contact;
    contact.enforcement.is_static = is_static;
    contact.interaction_defaults.emplace();
    contact.interaction_defaults->pair.stabilization.scale = scale;
    Diagnostics diagnostics;
    warn_of_idle_pair_settings(contact, diagnostics);
    return messages(diagnostics);
  };
  CHECK(said(true, 1.0) == "");
  CHECK(said(false, 0.0) == "");
  CHECK_THAT(said(false, 1.0), Contains("[stabilization-of-other-procedures]"));
}
