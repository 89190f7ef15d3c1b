// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "app/run/run_input.hpp"
#include "contact/mesh/contact_model.hpp"
#include "core/definition/simulation.hpp"
#include "parser/deck.hpp"
#include "support/two_cube_deck.hpp"

namespace contactsim::test {

/// What a run of two cubes is made from, in code; the deck is "d.i".
struct TwoCubeInput {
  ///   deck  of two_cube_deck(); of its first procedure
  TwoCubeInput(const Mesh& of, const std::string& deck)
      : mesh(of), definition(parse_deck_text("d.i", deck, {}, diagnostics)) {
    if (region().contact) contact = make_contact_model(definition, region(), mesh, diagnostics);
  }
  TwoCubeInput(const TwoCubeInput&) = delete;
  TwoCubeInput& operator=(const TwoCubeInput&) = delete;

  const Procedure& procedure() const { return definition.procedures.front(); }
  const Region& region() const { return procedure().regions.front(); }
  RunInput input() const {
    return {definition, procedure(), region(), mesh, contact ? &*contact : nullptr, overlaps};
  }

  Diagnostics diagnostics;
  Mesh mesh;
  SimulationDefinition definition;
  std::optional<ContactModel> contact;
  std::vector<StartOverlap> overlaps;
};

}  // namespace contactsim::test
