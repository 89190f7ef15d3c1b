// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "app/manual/foreign_keywords.hpp"

namespace contactsim {

using P = DeckPlace;

std::span<const ForeignKeyword> calculix_keywords() {
  static constexpr std::array rows{
      ForeignKeyword{"CalculiX", "*CONTACT PAIR, INTERACTION=rub with dep, ind", P::contact,
                     "BEGIN INTERACTION\nSIDE A = b\nSIDE B = a\nCONSTRAINT FORMULATION = NODE_FACE\n"
                     "FRICTION MODEL = rub\nEND",
                     "SIDE B is the dependent surface (slave), SIDE A the independent one (master)"},
      ForeignKeyword{"CalculiX", "*CONTACT PAIR, TYPE=SURFACE TO SURFACE", P::interaction,
                     "CONSTRAINT FORMULATION = FACE_FACE",
                     "the default. A surface of nodes meets faces as nodes, and that is told"},
      ForeignKeyword{"CalculiX", "*CONTACT PAIR, SMALL SLIDING", P::interaction,
                     "INTERACTION BEHAVIOR = INFINITESIMAL_SLIDING",
                     "for nodes and for faces, for the whole run"},
      ForeignKeyword{"CalculiX", "*CONTACT PAIR, ADJUST=0.01", P::interaction, "GAP CLOSURE TOLERANCE = 0.01",
                     "nodes of SIDE B, of both sides without one; those that have penetrated always"},
      ForeignKeyword{"CalculiX", "*CONTACT PAIR, ADJUST=nset", P::interaction, "ADJUST NODE SET = nodelist_1",
                     "at any distance; nodes outside it stay"},
      ForeignKeyword{"CalculiX", "*SURFACE, TYPE=NODE", P::contact, "CONTACT NODE SET a CONTAINS nodelist_1",
                     ""},
      ForeignKeyword{"CalculiX", "*SURFACE INTERACTION, *SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR",
                     P::interaction, "PENALTY STIFFNESS = 1e9",
                     "no default is needed, and none comes from the material of another block"},
      ForeignKeyword{"CalculiX", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TIED", P::interaction,
                     "FRICTION MODEL = TIED", ""},
      ForeignKeyword{"CalculiX", "*FRICTION", P::interaction, "FRICTION COEFFICIENT = 0.3",
                     "the stick slope is that of the penalty"},
      ForeignKeyword{"CalculiX", "*TIE, POSITION TOLERANCE", P::interaction,
                     "FRICTION MODEL = TIED\nCAPTURE TOLERANCE = 0.01", "what stays free is told"},
      ForeignKeyword{"CalculiX", "*CLEARANCE", P::interaction, "INITIAL CLEARANCE = 0.001", ""},
      ForeignKeyword{"CalculiX", "*CONTACT FILE with CDIS, CSTR", P::results,
                     "NODAL VARIABLES = cdisp cstress", ""},
  };
  return rows;
}

}  // namespace contactsim
