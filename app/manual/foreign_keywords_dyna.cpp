// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "app/manual/foreign_keywords.hpp"

namespace contactsim {

using P = DeckPlace;

std::span<const ForeignKeyword> dyna_keywords() {
  static constexpr std::array rows{
      ForeignKeyword{"LS-DYNA", "*CONTACT_AUTOMATIC_SINGLE_SURFACE, parts all", P::contact,
                     "SKIN ALL BLOCKS = ON\nBEGIN INTERACTION DEFAULTS\nGENERAL CONTACT = ON\n"
                     "SELF CONTACT = ON\nEND",
                     "every block is a surface of its name; tables tell who owns which face"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_AUTOMATIC_SURFACE_TO_SURFACE", P::contact,
                     "BEGIN INTERACTION\nSURFACES = a b\nEND", "neither side is the reference"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_AUTOMATIC_NODES_TO_SURFACE", P::contact,
                     "BEGIN INTERACTION\nSIDE A = b\nSIDE B = a\nCONSTRAINT FORMULATION = NODE_FACE\nEND",
                     "SIDE B is SURFA (slave, tracked), SIDE A is SURFB (master, reference)"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_AUTOMATIC_GENERAL", P::surface_options, "EDGE CONTACT = ON",
                     "the default: beams, rims of shells and edges past the FEATURE ANGLE meet each other"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_..._MORTAR", P::interaction, "CONSTRAINT FORMULATION = FACE_FACE",
                     "the default: integration over the overlap of faces"},
      ForeignKeyword{
          "LS-DYNA", "*CONTACT_TIED_SURFACE_TO_SURFACE", P::contact,
          "BEGIN INTERACTION\nSURFACES = a b\nFRICTION MODEL = TIED\nEND",
          "what is near at the start; nodes stay where they are unless GAP CLOSURE TOLERANCE moves "
          "them"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_TIED_..._OFFSET", P::interaction,
                     "FRICTION MODEL = TIED\nCAPTURE TOLERANCE = 0.01",
                     "the gap stays, and its arm carries the moment"},
      ForeignKeyword{
          "LS-DYNA", "*CONTACT_..._TIEBREAK with NFLS, SFLS", P::contact,
          "BEGIN COHESIVE ZONE MODEL bond\nTRACTION DISPLACEMENT FUNCTION = f\n"
          "CRITICAL NORMAL GAP = 0.01\nCRITICAL TANGENTIAL GAP = 0.01\nEND",
          "a function of the opening, not two strengths; SPRING WELD and SURFACE WELD fail by force"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_ERODING_SINGLE_SURFACE", P::death, "NEW EDGES ON DEATH = ON",
                     "the rule: skins gain what deaths expose, in any contact"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_FORCE_TRANSDUCER, *DATABASE_RCFORC", P::heartbeat,
                     "GLOBAL VARIABLES = contact_force_a contact_area_a",
                     "of each surface, pair (_a_b) and side set, without a transducer"},
      ForeignKeyword{"LS-DYNA", "*DATABASE_SLEOUT", P::heartbeat,
                     "GLOBAL VARIABLES = contact_energy_a friction_energy_a_b",
                     "the log has each pair's at the end of the run"},
      ForeignKeyword{"LS-DYNA", "*DATABASE_BINARY_INTFOR", P::results,
                     "NODAL VARIABLES = contact_normal_traction_magnitude contact_normal_gap",
                     "in the results file; the facets by VISUALIZE CONTACT FACETS = ON in BEGIN DEBUG"},
      ForeignKeyword{"LS-DYNA", "FS", P::interaction, "FRICTION COEFFICIENT = 0.3", "of one pair"},
      ForeignKeyword{"LS-DYNA", "FS, FD and DC", P::contact,
                     "BEGIN PV DEPENDENT MODEL decay\nSTATIC COEFFICIENT = 0.3\nDYNAMIC COEFFICIENT = 0.2\n"
                     "VELOCITY DECAY = 1.0\nREFERENCE PRESSURE = 1.0\nPRESSURE EXPONENT = 0\nEND",
                     "interactions name it by FRICTION MODEL = decay"},
      ForeignKeyword{"LS-DYNA", "SFS, SFM, SLSFAC", P::interaction,
                     "ENFORCEMENT = PENALTY\nPENALTY SCALE = 0.1",
                     "of one pair; of all in BEGIN ENFORCEMENT OPTIONS. Momentum balance has no stiffness"},
      ForeignKeyword{"LS-DYNA", "SOFT=0", P::interaction, "ENFORCEMENT = PENALTY",
                     "springs as the stable step can bear, which is what SOFT=1 is there for"},
      ForeignKeyword{"LS-DYNA", "SOFT=2", P::interaction, "CONSTRAINT FORMULATION = FACE_FACE",
                     "the default, in momentum balance too"},
      ForeignKeyword{"LS-DYNA", "VDC", P::interaction,
                     "ENFORCEMENT = PENALTY\nCONTACT DAMPING FRACTION = 0.2",
                     "a share, not per cent; momentum balance needs none"},
      ForeignKeyword{"LS-DYNA", "BT and DT", P::interaction, "ACTIVE PERIODS = t1",
                     "by time stepping blocks"},
      ForeignKeyword{
          "LS-DYNA", "SST, MST, SFST, SFMT", P::sierra, "BEGIN SHELL SECTION s\nTHICKNESS = 0.1\nEND",
          "shells touch at their true thickness; bounds by ALLOWABLE SHELL THICKNESS in BEGIN SURFACE "
          "OPTIONS"},
      ForeignKeyword{
          "LS-DYNA", "IGNORE=0", P::contact, "INITIAL OVERLAP REMOVAL = ON",
          "nodes move without strain until surfaces part; OFF is the default, and overlaps are told"},
      ForeignKeyword{"LS-DYNA", "IGNORE=1, 2", P::interaction, "IGNORE INITIAL OVERLAP = ON",
                     "what overlaps at the start just touches"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_..._INTERFERENCE", P::interaction, "OVERLAP RAMP TIME = 0.1",
                     "a time in place of a curve"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_..._SMOOTH", P::interaction, "SMOOTHING = AUTO",
                     "cylinders, spheres and tori by their nodes"},
      ForeignKeyword{"LS-DYNA", "*CONTACT_..., box SABOXID", P::contact,
                     "RESTRICT CONTACT TO BOX DEFINED BY 0 0 0 AND 1 1 1", "of all surfaces, at the start"},
      ForeignKeyword{
          "LS-DYNA", "*RIGIDWALL_PLANAR", P::region,
          "BEGIN ANALYTIC OBJECT floor\nTYPE = PLANE\nNORMAL DIRECTION = 0 0 1\nORIGIN = 0 0 0\nEND",
          "a contact surface contains it: CONTACT SURFACE ground CONTAINS floor"},
      ForeignKeyword{"LS-DYNA", "*PART_CONTACT; *DEFINE_FRICTION", P::contact,
                     "BEGIN INTERACTION\nSURFACES = a b\nFRICTION MODEL = rub\nEND",
                     "a law of every pair that needs its own"},
      ForeignKeyword{
          "LS-DYNA", "*CONTACT_INTERIOR", P::none, "",
          "elements do not meet themselves inside; kill those that invert by DEATH ON INVERSION = ON"},
      ForeignKeyword{"LS-DYNA", "BSORT, NSBCS, DEPTH", P::none, "",
                     "searches come when something has moved so far that it might miss a partner"},
      ForeignKeyword{"LS-DYNA", "*CONTROL_SUBCYCLE", P::region, "SUBCYCLE BLOCKS = ALL",
                     "two classes of elements: what is small, and what is advanced once in a step"},
      ForeignKeyword{"LS-DYNA", "*INITIAL_VELOCITY_GENERATION", P::region,
                     "BEGIN INITIAL VELOCITY\nBLOCK = block_2\nCOMPONENT = Z\nMAGNITUDE = -1.0\nEND",
                     "turning ones by CYLINDRICAL AXIS and ANGULAR VELOCITY"},
      ForeignKeyword{"LS-DYNA", "*BOUNDARY_SPC_SET", P::region,
                     "BEGIN FIXED DISPLACEMENT\nNODE SET = nodelist_1\nCOMPONENTS = X Y\nEND", ""},
      ForeignKeyword{"LS-DYNA", "*BOUNDARY_PRESCRIBED_MOTION_SET, VAD=0", P::region,
                     "BEGIN PRESCRIBED VELOCITY\nNODE SET = nodelist_1\nCOMPONENT = Z\nFUNCTION = f\nEND",
                     ""},
  };
  return rows;
}

}  // namespace contactsim
