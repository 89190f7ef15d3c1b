// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "app/manual/foreign_keywords.hpp"

namespace contactsim {

using P = DeckPlace;

std::span<const ForeignKeyword> optistruct_keywords() {
  static constexpr std::array rows{
      ForeignKeyword{"OptiStruct", "CONTACT, TYPE=SLIDE", P::interaction, "FRICTION MODEL = FRICTIONLESS",
                     "the default; by MU1 FRICTION COEFFICIENT"},
      ForeignKeyword{"OptiStruct", "CONTACT, TYPE=STICK", P::interaction, "FRICTION MODEL = STICK", ""},
      ForeignKeyword{"OptiStruct", "CONTACT, TYPE=FREEZE; TIE", P::interaction, "FRICTION MODEL = FREEZE",
                     "a tie keeps the gap of the start, unless GAP CLOSURE TOLERANCE moves its nodes"},
      ForeignKeyword{"OptiStruct", "PCONT, MU1 and MU2", P::contact,
                     "BEGIN PV DEPENDENT MODEL m\nSTATIC COEFFICIENT = 0.3\nDYNAMIC COEFFICIENT = 0.2\n"
                     "VELOCITY DECAY = 1.0\nREFERENCE PRESSURE = 1.0\nPRESSURE EXPONENT = 0\nEND",
                     "the kinetic coefficient is reached with the slip rate, not at once"},
      ForeignKeyword{"OptiStruct", "PCONT, STIFF", P::interaction, "PENALTY STIFFNESS = 1e9",
                     "per area; AUTO by the elements behind the faces"},
      ForeignKeyword{"OptiStruct", "DISCRET=N2S, S2S", P::interaction, "CONSTRAINT FORMULATION = NODE_FACE",
                     "N2S; S2S is FACE_FACE, the default"},
      ForeignKeyword{"OptiStruct", "ADJUST=NO", P::none, "", "the default"},
      ForeignKeyword{"OptiStruct", "ADJUST=AUTO", P::interaction, "GAP CLOSURE TOLERANCE = AUTO",
                     "0.05 of the mean edge of the side that gives the faces"},
      ForeignKeyword{
          "OptiStruct", "ADJUST=real", P::interaction, "GAP CLOSURE TOLERANCE = 0.01",
          "nodes move along the normal of the face, with any formulation; nodes over no face stay"},
      ForeignKeyword{"OptiStruct", "ADJUST=set", P::interaction, "ADJUST NODE SET = nodelist_1",
                     "pairs one after the other in the order of the deck"},
      ForeignKeyword{"OptiStruct", "CLEARANCE; PGAP U0", P::interaction, "INITIAL CLEARANCE = 0.001",
                     "not together with CONTACT OFFSET; places far from each other are told"},
      ForeignKeyword{"OptiStruct", "PCONT, GPAD=real", P::interaction, "CONTACT OFFSET = 0.001", ""},
      ForeignKeyword{"OptiStruct", "PCONT, GPAD=THICK", P::none, "",
                     "the rule: shells touch with their thickness and offset"},
      ForeignKeyword{"OptiStruct", "SFPRPEN=NO", P::interaction, "IGNORE INITIAL OVERLAP = ON",
                     "for any pair; overlaps that are not removed are told"},
      ForeignKeyword{"OptiStruct", "press fit by load steps", P::interaction, "OVERLAP RAMP TIME = 0.1", ""},
      ForeignKeyword{
          "OptiStruct", "SRCHDIS", P::interaction, "SEARCH DISTANCE = AUTO",
          "two mean edges of the side that gives the faces; what is farther at the start is never met"},
      ForeignKeyword{"OptiStruct", "PCONT, SEPARATION=NO", P::interaction, "SEPARATION = OFF", ""},
      ForeignKeyword{"OptiStruct", "MORIENT=NORM, REVNORM", P::interaction, "SIDES = TOP",
                     "NORM is TOP and REVNORM is BOTTOM; both words are taken"},
      ForeignKeyword{"OptiStruct", "SMOOTH, SMREG", P::interaction, "SMOOTHING = AUTO",
                     "or BEGIN SURFACE SMOOTHING with axes"},
      ForeignKeyword{"OptiStruct", "MORIENT=OPENGAP", P::none, "",
                     "the rule of lofted shells: both sides push, each to its own side"},
      ForeignKeyword{"OptiStruct", "TRACK=FINITE, CONSLI", P::interaction, "INTERACTION BEHAVIOR = SLIDING",
                     "the default: partners are followed in every step, friction or not"},
      ForeignKeyword{"OptiStruct", "CNTSTB", P::interaction,
                     "CONTACT STABILIZATION = ON\nSTABILIZATION TANGENTIAL FRACTION = 0.1",
                     "of load steps; SCALE is the number in place of ON, S1 is STABILIZATION REMAINING "
                     "FRACTION, LMTGAP is STABILIZATION RANGE; S0 is 1 in every time stepping block"},
      ForeignKeyword{"OptiStruct", "GAPGPRJ=SHORT", P::none, "",
                     "the rule: beyond the edge of a face the nearest point counts"},
  };
  return rows;
}

}  // namespace contactsim
