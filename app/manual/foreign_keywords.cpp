// SPDX-License-Identifier: BSD-3-Clause
#include "app/manual/foreign_keywords.hpp"

#include <array>
#include <vector>

namespace contactsim {

namespace {

using P = DeckPlace;

constexpr std::array abaqus_rows{
    // What is in contact
    ForeignKeyword{
        "Abaqus", "*CONTACT INCLUSIONS, ALL EXTERIOR", P::contact,
        "SKIN ALL BLOCKS = ON\nBEGIN INTERACTION DEFAULTS\nGENERAL CONTACT = ON\n"
        "SELF CONTACT = ON\nEND",
        "self contact is asked for by a line of its own; every block is a surface of its name, and a "
        "face belongs to one surface"},
    ForeignKeyword{"Abaqus", "*CONTACT INCLUSIONS with a, b", P::contact,
                   "BEGIN INTERACTION\nSURFACES = a b\nEND",
                   "any number of surfaces: every two of them meet"},
    ForeignKeyword{"Abaqus", "*CONTACT INCLUSIONS with a, or a, a", P::contact,
                   "BEGIN INTERACTION\nSURFACES = a\nEND",
                   "a surface that spans bodies has contact between them"},
    ForeignKeyword{
        "Abaqus", "*CONTACT EXCLUSIONS with a, b", P::interaction_defaults, "EXCLUDE SURFACES = a b",
        "an exclusion wins in any order; for some periods INTERACTION BEHAVIOR = NO_INTERACTION and "
        "ACTIVE PERIODS in an interaction"},
    ForeignKeyword{"Abaqus", "*CONTACT EXCLUSIONS with a,", P::interaction_defaults, "EXCLUDE SURFACES = a",
                   "of the surface with itself"},
    ForeignKeyword{"Abaqus", "*CONTACT EXCLUSIONS with , a", P::interaction_defaults,
                   "EXCLUDE SURFACES = a ALL", "of the surface with everything, itself too"},
    ForeignKeyword{
        "Abaqus", "exclusions made by the program", P::none, "",
        "the same: a pair of an interaction or a tie is not met by general contact as well, in its "
        "periods; a rigid body does not meet itself"},
    ForeignKeyword{
        "Abaqus", "*SURFACE, TYPE=ELEMENT", P::contact, "CONTACT SURFACE a CONTAINS surface_3",
        "side sets, blocks and assemblies; lofts follow from shells, beams and particles. The first "
        "surface of the deck owns what several name"},
    ForeignKeyword{"Abaqus", "*SURFACE, COMBINE=UNION, DIFFERENCE", P::contact,
                   "BEGIN CONTACT SURFACE a\nBLOCK = block_1\nREMOVE SURFACE = surface_3\nEND", ""},
    ForeignKeyword{"Abaqus", "*SURFACE, CROP", P::contact,
                   "RESTRICT CONTACT TO BOX DEFINED BY 0 0 0 AND 1 1 1",
                   "of all surfaces; what has a node outside at the start is left out"},
    ForeignKeyword{"Abaqus", "*SURFACE, TYPE=NODE", P::contact, "CONTACT NODE SET a CONTAINS nodelist_1",
                   "meets faces only, also as a set of point masses"},
    ForeignKeyword{"Abaqus", "*SURFACE, TYPE=PLANE; *RIGID BODY, ANALYTICAL SURFACE", P::region,
                   "BEGIN ANALYTIC OBJECT floor\nTYPE = PLANE\nNORMAL DIRECTION = 0 0 1\nORIGIN = 0 0 0\nEND",
                   "planes only, which a contact surface contains; other shapes by rigid blocks"},
    ForeignKeyword{"Abaqus", "*CONTACT, OP=NEW and OP=MOD of a step", P::interaction, "ACTIVE PERIODS = t1",
                   "by interaction: outside its periods the pair is met as the rest of the deck says"},
    // How sides meet
    ForeignKeyword{"Abaqus", "*CONTACT FORMULATION, TYPE=PURE MASTER-SLAVE with a, b, SLAVE", P::contact,
                   "BEGIN INTERACTION\nSIDE A = b\nSIDE B = a\nCONSTRAINT FORMULATION = NODE_FACE\nEND",
                   "SIDE A gives the faces (master), SIDE B the nodes (slave). With a surface on both sides "
                   "contact stays two-sided, and that is told"},
    ForeignKeyword{"Abaqus", "*CONTACT FORMULATION, balanced weighting", P::interaction,
                   "CONSTRAINT FORMULATION = FACE_FACE",
                   "the default: faces meet faces, neither side is the master"},
    ForeignKeyword{"Abaqus", "*CONTACT PAIR, MECHANICAL CONSTRAINT=KINEMATIC", P::interaction,
                   "ENFORCEMENT = MOMENTUM_BALANCE", "the default; it does not lower the time step"},
    ForeignKeyword{"Abaqus", "*CONTACT PAIR, MECHANICAL CONSTRAINT=PENALTY", P::interaction,
                   "ENFORCEMENT = PENALTY", ""},
    ForeignKeyword{"Abaqus", "*CONTACT PAIR, SMALL SLIDING", P::interaction,
                   "INTERACTION BEHAVIOR = INFINITESIMAL_SLIDING",
                   "partners of the start are kept; finite sliding is the default"},
    ForeignKeyword{"Abaqus", "*CONTACT CONTROLS ASSIGNMENT, TYPE=SCALE PENALTY", P::interaction,
                   "ENFORCEMENT = PENALTY\nPENALTY SCALE = 0.1",
                   "of one pair; of all in BEGIN ENFORCEMENT OPTIONS"},
    ForeignKeyword{"Abaqus", "*CONTACT DAMPING", P::interaction,
                   "ENFORCEMENT = PENALTY\nCONTACT DAMPING FRACTION = 0.03", "share of critical damping"},
    ForeignKeyword{"Abaqus", "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=FEATURE EDGE CRITERIA",
                   P::surface_options, "FEATURE ANGLE = 45",
                   "edges by angle, not by their identifiers; EDGE CONTACT = OFF switches edges off"},
    ForeignKeyword{
        "Abaqus", "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=THICKNESS", P::sierra,
        "BEGIN SHELL SECTION s\nTHICKNESS = 0.1\nEND",
        "contact takes the section's thickness; BEAM RADIUS in BEGIN SURFACE OPTIONS that of beams"},
    ForeignKeyword{"Abaqus", "*SURFACE PROPERTY ASSIGNMENT, PROPERTY=OFFSET FRACTION", P::sierra,
                   "BEGIN SHELL SECTION s\nTHICKNESS = 0.1\nLOFTING FACTOR = 0.5\nEND", ""},
    ForeignKeyword{"Abaqus", "*CONTACT CONTROLS ASSIGNMENT, CONTACT THICKNESS REDUCTION", P::surface_options,
                   "CONTACT SHELL THICKNESS = LET_CONTACT_CHOOSE\nALLOWABLE SHELL THICKNESS = 0.1 TO 1.0",
                   "bounds as multiples of the edge length"},
    // Laws
    ForeignKeyword{"Abaqus", "*SURFACE INTERACTION with *FRICTION", P::contact,
                   "BEGIN CONSTANT FRICTION MODEL mu\nFRICTION COEFFICIENT = 0.3\nEND",
                   "interactions name it by FRICTION MODEL = mu; frictionless without any"},
    ForeignKeyword{"Abaqus", "*FRICTION, EXPONENTIAL DECAY", P::contact,
                   "BEGIN PV DEPENDENT MODEL decay\nSTATIC COEFFICIENT = 0.3\nDYNAMIC COEFFICIENT = 0.2\n"
                   "VELOCITY DECAY = 1.0\nREFERENCE PRESSURE = 1.0\nPRESSURE EXPONENT = 0\nEND",
                   "by pressure too, if its exponent is not 0"},
    ForeignKeyword{"Abaqus", "*FRICTION, ROUGH", P::interaction, "FRICTION MODEL = STICK",
                   "what touches does not slip, and parts freely"},
    ForeignKeyword{"Abaqus", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=HARD", P::interaction,
                   "ENFORCEMENT = MOMENTUM_BALANCE", "the default"},
    ForeignKeyword{"Abaqus", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=LINEAR", P::interaction,
                   "PENALTY STIFFNESS = 1e9", "pressure over overclosure [force/length^3]"},
    ForeignKeyword{"Abaqus", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=TABULAR", P::contact,
                   "BEGIN PRESSURE FUNCTION MODEL soft\nFUNCTION = g\nEND",
                   "abscissa overclosure, < 0 a gap; the pair is elastic, whatever ENFORCEMENT says"},
    ForeignKeyword{"Abaqus", "*SURFACE BEHAVIOR, PRESSURE-OVERCLOSURE=EXPONENTIAL", P::contact,
                   "BEGIN EXPONENTIAL PRESSURE MODEL soft\nPRESSURE AT ZERO GAP = 100\n"
                   "CLEARANCE AT ZERO PRESSURE = 0.01\nEND",
                   ""},
    ForeignKeyword{"Abaqus", "*SURFACE BEHAVIOR, NO SEPARATION", P::interaction, "SEPARATION = OFF",
                   "faces and nodes; edges part"},
    ForeignKeyword{"Abaqus", "*CONTACT FORMULATION, TYPE=POLARITY with SPOS, SNEG", P::interaction,
                   "SIDES = TOP", "of SIDE A's shells, without sides of all; edges meet from both sides"},
    ForeignKeyword{
        "Abaqus", "*SURFACE SMOOTHING with CIRCUMFERENTIAL, SPHERICAL, TOROIDAL", P::contact,
        "BEGIN SURFACE SMOOTHING round\nSURFACE = a b\nCIRCUMFERENTIAL AXIS = 0 0 0 0 0 1\nEND",
        "a pair uses it by SMOOTHING = round; gaps, areas and normals are those of the round surface"},
    ForeignKeyword{"Abaqus", "*CONTACT PAIR, GEOMETRIC CORRECTION", P::interaction, "SMOOTHING = AUTO",
                   "finds cylinders, spheres and tori by their nodes, and tells them in the log"},
    ForeignKeyword{"Abaqus", "*COHESIVE SECTION, ELEMENT=COH3D8", P::sierra,
                   "BEGIN COHESIVE SECTION glue\nEND",
                   "of HEX8 and WEDGE6 blocks, with the material model TVERGAARD_HUTCHINSON"},
    ForeignKeyword{"Abaqus", "*COHESIVE BEHAVIOR, *DAMAGE INITIATION", P::contact,
                   "BEGIN COHESIVE ZONE MODEL bond\nTRACTION DISPLACEMENT FUNCTION = f\n"
                   "CRITICAL NORMAL GAP = 0.01\nCRITICAL TANGENTIAL GAP = 0.01\nEND",
                   "both sides are integrated once, where Abaqus takes one as the slave"},
    ForeignKeyword{"Abaqus", "*TIE", P::contact,
                   "BEGIN INTERACTION\nSURFACES = a b\nFRICTION MODEL = TIED\nEND",
                   "what is near at the start; ties of several meshes need no master"},
    ForeignKeyword{"Abaqus", "*TIE, POSITION TOLERANCE", P::interaction,
                   "FRICTION MODEL = TIED\nCAPTURE TOLERANCE = 0.01", "what stays free is told"},
    ForeignKeyword{"Abaqus", "*TIE, ADJUST=YES", P::interaction,
                   "FRICTION MODEL = TIED\nGAP CLOSURE TOLERANCE = 0.01",
                   "nodes move before the tie is made"},
    ForeignKeyword{
        "Abaqus", "surface elements tied to a body to carry its true shape", P::contact,
        "BEGIN INTERACTION\nSURFACES = a b\nFRICTION MODEL = TIED\nEND",
        "thin shells in a block of their own; their mass is by their density, not taken from the body"},
    // The start
    ForeignKeyword{"Abaqus", "initial overclosures, resolved at the start", P::contact,
                   "INITIAL OVERLAP REMOVAL = ON",
                   "without strain, before the first step; OFF is the default"},
    ForeignKeyword{"Abaqus", "*CONTACT INITIALIZATION DATA, SEARCH ABOVE", P::interaction,
                   "GAP CLOSURE TOLERANCE = 0.01", ""},
    ForeignKeyword{"Abaqus", "*CLEARANCE; INITIAL CLEARANCE", P::interaction, "INITIAL CLEARANCE = 0.001",
                   "below 0 an overlap; nodes do not move"},
    ForeignKeyword{"Abaqus", "*CONTACT INTERFERENCE, SHRINK", P::interaction, "OVERLAP RAMP TIME = 0.1", ""},
    ForeignKeyword{"Abaqus", "*SURFACE INTERACTION, PAD THICKNESS", P::interaction, "CONTACT OFFSET = 0.001",
                   ""},
    ForeignKeyword{"Abaqus", "*SURFACE INTERACTION, TRACKING THICKNESS", P::interaction,
                   "TRACKING DISTANCE = 0.1", "how far contact_normal_gap is known"},
    // Erosion
    ForeignKeyword{
        "Abaqus", "*SHEAR FAILURE, ELEMENT DELETION=YES", P::region,
        "BEGIN ELEMENT DEATH d\nBLOCK = block_1\nCRITERION IS ELEMENT VALUE OF von_mises > 1e8\nEND",
        "any variable kills, or MATERIAL CRITERION = ON"},
    ForeignKeyword{"Abaqus", "interior faces of eroding bodies in the surface", P::contact,
                   "CONTACT SURFACE a CONTAINS block_1",
                   "nothing is listed in advance: what a death exposes joins the surface of its block"},
    ForeignKeyword{"Abaqus", "*CONTACT CONTROLS ASSIGNMENT, NODAL EROSION=YES", P::death,
                   "NODAL EROSION = ON", "OFF, the default of both, keeps nodes as free masses"},
    ForeignKeyword{"Abaqus", "edges of eroding bodies", P::death, "NEW EDGES ON DEATH = OFF",
                   "Abaqus makes none; here ON is the default"},
    // Output
    ForeignKeyword{
        "Abaqus", "*CONTACT OUTPUT with CSTRESS, CFORCE, CDISP, CSLIPR, CTANDIR", P::results,
        "NODAL VARIABLES = cstress\nNODAL VARIABLES = cforce cdisp\nNODAL VARIABLES = cslipr ctandir",
        "groups of variables of ours; CPRESS, COPEN and the rest are told by our names"},
    ForeignKeyword{"Abaqus", "CPRESS, CNORMF, CSHEARF, COPEN, CSLIPEQ", P::results,
                   "NODAL VARIABLES = contact_normal_traction_magnitude contact_normal_force\n"
                   "NODAL VARIABLES = contact_tangential_force contact_normal_gap contact_accumulated_slip",
                   "the pressure is a size, without sign; a pinched shell has the sum of both sides"},
    ForeignKeyword{
        "Abaqus", "CSLIP1, CSLIP2", P::results, "NODAL VARIABLES = contact_accumulated_slip_vector",
        "a vector along the global axes that turns with the surface, not two parts along tangents"},
    ForeignKeyword{"Abaqus", "CSLIPR1, CSLIPR2 along CTANDIR1, CTANDIR2", P::results,
                   "NODAL VARIABLES = contact_slip_rate_components contact_tangential_direction",
                   "along the friction force on the node and across it"},
    ForeignKeyword{
        "Abaqus", "CFN, CFS, CFT, CMN, CMS, CMT, XN, XS, XT, CAREA of a surface", P::heartbeat,
        "GLOBAL VARIABLES = contact_normal_force_a contact_friction_force_a contact_force_a\n"
        "GLOBAL VARIABLES = contact_moment_a contact_line_point_a contact_area_a",
        "of each contact surface, each pair (_a_b) and each side set of the mesh; the point is the one "
        "of the line of action nearest to the centre of pressure"},
    ForeignKeyword{
        "Abaqus", "General_Contact_Faces_Stepk, _Edges_, _Nodes_", P::contact,
        "BEGIN DEBUG\nVISUALIZE CONTACT FACETS = ON\nEND",
        "results hold side sets contact_<surface>, and node sets of surfaces of nodes; the facets' file "
        "has a block of each surface and of its edges"},
    ForeignKeyword{"Abaqus", "STATUS", P::results, "ELEMENT VARIABLES = death_status", "1 alive, 0 dead"},
};

constexpr std::array other_rows{
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
    ForeignKeyword{"CalculiX", "*CONTACT FILE with CDIS, CSTR", P::results, "NODAL VARIABLES = cdisp cstress",
                   ""},
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
    ForeignKeyword{"OptiStruct", "ADJUST=real", P::interaction, "GAP CLOSURE TOLERANCE = 0.01",
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
                   "ENFORCEMENT = PENALTY\nCONTACT DAMPING FRACTION = 0.1",
                   "at all times: damping has no periods of its own"},
    ForeignKeyword{"OptiStruct", "GAPGPRJ=SHORT", P::none, "",
                   "the rule: beyond the edge of a face the nearest point counts"},
};

}  // namespace

std::span<const std::string_view> foreign_programs() {
  static constexpr std::array<std::string_view, 4> programs{"Abaqus", "CalculiX", "LS-DYNA", "OptiStruct"};
  return programs;
}

std::span<const ForeignKeyword> foreign_keywords() {
  static const std::vector<ForeignKeyword> rows = [] {
    std::vector<ForeignKeyword> joined(abaqus_rows.begin(), abaqus_rows.end());
    for (const auto more : {std::span<const ForeignKeyword>(other_rows), dyna_keywords()})
      joined.insert(joined.end(), more.begin(), more.end());
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
