// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/base/contact_indices.hpp"
#include "core/base/indices.hpp"

namespace contactsim {

/// Who owns one face, lofted element or node, and who claims it in vain.
struct Claim {
  /// A surface that claimed in vain, and who had it already.
  struct Lost {
    SurfaceIndex loser, winner;
  };
  std::optional<SurfaceIndex> owner;
  std::vector<Lost> lost;

  /// A request claims, after all that stand before it in the deck.
  ///   surface  the first that the request makes: it counts what is lost
  ///   part     the one that gets the thing: `surface` or a subset of it
  ///   other    who has it already in another way
  void add(SurfaceIndex surface, SurfaceIndex part, std::optional<SurfaceIndex> other = std::nullopt) {
    const auto winner = owner ? owner : other;
    if (winner) {
      lost.push_back({surface, *winner});
    } else {
      owner = part;
    }
  }
};

/// What all requests claim of a lofted element: its body, and its sides that are in side sets. To contact
/// they are one thing: who has a side has the body, and the other way round.
struct LoftedClaim {
  Claim body;
  std::vector<ElementSide> sides;  ///< ascending
  std::vector<Claim> of_sides;     ///< [sides]

  /// The owner of the first side that has one.
  std::optional<SurfaceIndex> owner_of_sides() const {
    for (const Claim& of_side : of_sides) {
      if (of_side.owner) return of_side.owner;
    }
    return std::nullopt;
  }
};

}  // namespace contactsim
