// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/foreign_keywords.hpp"

#include <array>
#include <vector>

namespace contactsim {

std::span<const std::string_view> foreign_programs() {
  static constexpr std::array<std::string_view, 4> programs{"Abaqus", "CalculiX", "LS-DYNA", "OptiStruct"};
  return programs;
}

std::span<const ForeignKeyword> foreign_keywords() {
  static const std::vector<ForeignKeyword> rows = [] {
    std::vector<ForeignKeyword> joined;
    for (const auto program :
         {abaqus_keywords(), calculix_keywords(), optistruct_keywords(), dyna_keywords()})
      joined.insert(joined.end(), program.begin(), program.end());
    return joined;
  }();
  return rows;
}

std::span<const LeftOut> left_out_rows() {
  static constexpr std::array rows{
      LeftOut{"the last assignment wins (Abaqus)",
              "the first surface of the deck owns a face, as in Sierra/SM; only exclusions win in any order"},
      LeftOut{"a blank name for the whole model (Abaqus)", "names are written out; ALL where all are meant"},
      LeftOut{"self contact only where the surfaces of a pair overlap (Abaqus)",
              "a face has one owner: surfaces never overlap, and SELF CONTACT is asked for"},
      LeftOut{"*CONTACT once in every step (Abaqus)",
              "one contact definition holds for the run; interactions have periods"},
      LeftOut{"formulations for regions that are no contact surface (Abaqus)",
              "whoever wants another treatment of a part makes a surface of it"},
      LeftOut{"edges by identifiers (Abaqus)", "an angle chooses them, surface by surface"},
      LeftOut{"interior faces listed in advance, with a thickness (Abaqus)",
              "skins follow element death by themselves, with the thickness of the element behind"},
      LeftOut{"component surfaces without common nodes (Abaqus)", "surfaces are those that the deck names"},
      LeftOut{"surfaces of every step in the output (Abaqus)",
              "sets contact_<surface> of the start are written once; deaths change contact, not the sets"},
      LeftOut{"corners rounded numerically (Abaqus)",
              "corners stay sharp; faces that are as near a node share it alike"},
      LeftOut{"U written with any contact variable (Abaqus)", "files hold what is asked for"},
      LeftOut{"no slip output for particles (Abaqus)", "particles have all contact variables here"},
      LeftOut{"analytical surfaces but planes (Abaqus)",
              "a rigid block of shells does the same at the price of its faces"},
      LeftOut{"Eulerian-Lagrangian contact, SPH (Abaqus)", "there are no such bodies; particles are balls"},
      LeftOut{"two-dimensional surfaces", "meshes have three dimensions"},
      LeftOut{"smoothing by CAD geometry (Abaqus)", "no CAD model is read"},
      LeftOut{"quadratic faces and their weights (CalculiX, OptiStruct CONTFEL)",
              "six-node faces of ten-node tetrahedra are four facets; other quadratic elements are refused"},
      LeftOut{"the penalty from the first material of the deck (CalculiX)",
              "each face has that of the element behind it"},
      LeftOut{"FLIP and CONTPRM,CORIENT,ONALL (OptiStruct)",
              "solids push outwards, always; a side set of a shell has the number of the side that pushes"},
      LeftOut{"ADJUST skipped where GPAD is 0 and MORIENT is OPENGAP or OVERLAP (OptiStruct)",
              "the normal of the face says where to"},
      LeftOut{"ADJUST of a self-contact surface (OptiStruct: must be NO)",
              "it is refused: nothing says which of two folds should move"},
      LeftOut{"a search every n increments (CONSLI; GLOBAL SEARCH INCREMENT of Sierra/SM)",
              "a search comes when something has moved so far that it might miss a partner"},
      LeftOut{"ENFORCEMENT = AL (Sierra/SM)",
              "of implicit runs; momentum balance lets nothing through at the end of a step"},
      LeftOut{"a time step of each interface (OpenRadioss)",
              "momentum balance limits none; the log tells what the springs of all pairs take off it"},
      LeftOut{"SRCHDCLR (OptiStruct)", "places farther apart than an edge are told, and count"},
      LeftOut{"contact values of 0 at the first output, of the last pair at a node (Sierra/SM limits)",
              "values are those of the state that is written, summed over pairs"},
  };
  return rows;
}

}  // namespace contactsim
