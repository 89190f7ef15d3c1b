// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/transfer_refusals.hpp"

#include "support/catch.hpp"
#include "support/contact_bodies.hpp"
#include "support/deck_dump.hpp"
#include "support/two_cubes.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

TEST_CASE("contact that is not taken over must hold nothing at the start", "[app][refusals]") {
  const auto said_of = [](const std::string& lines) {
    const ContactParts parts(TwoCubes::cubes(), general_contact(lines));
    Diagnostics said;
    refuse_held_without_transfer(parts.model.pairs, said);
    return messages(said);
  };
  CHECK(said_of("").empty());
  CHECK(said_of("friction model = rough\nend\nbegin constant friction model rough\n"
                "friction coefficient = 0.2\n")
            .empty());
  CHECK_THAT(said_of("friction model = tied\n"),
             Contains("error: contact that holds what is near at the start is not supported where a "
                      "PROCEDURAL TRANSFER takes over no contact"));
}
