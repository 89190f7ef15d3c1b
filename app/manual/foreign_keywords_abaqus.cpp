// SPDX-License-Identifier: BSD-3-Clause
#include <array>

#include "app/manual/foreign_keywords.hpp"

namespace contactsim {

using P = DeckPlace;

std::span<const ForeignKeyword> abaqus_keywords() {
  static constexpr std::array rows{
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
      ForeignKeyword{
          "Abaqus", "*SURFACE, TYPE=PLANE; *RIGID BODY, ANALYTICAL SURFACE", P::region,
          "BEGIN ANALYTIC OBJECT floor\nTYPE = PLANE\nNORMAL DIRECTION = 0 0 1\nORIGIN = 0 0 0\nEND",
          "planes only, which a contact surface contains; other shapes by rigid blocks"},
      ForeignKeyword{"Abaqus", "*CONTACT, OP=NEW and OP=MOD of a step", P::interaction, "ACTIVE PERIODS = t1",
                     "by interaction: outside its periods the pair is met as the rest of the deck says"},
      // How sides meet
      ForeignKeyword{
          "Abaqus", "*CONTACT FORMULATION, TYPE=PURE MASTER-SLAVE with a, b, SLAVE", P::contact,
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
      ForeignKeyword{"Abaqus", "*CONTACT STABILIZATION", P::interaction, "CONTACT STABILIZATION = ON",
                     "of load steps; TANGENT FRACTION is STABILIZATION TANGENTIAL FRACTION, RANGE is "
                     "STABILIZATION RANGE; *CONTACT CONTROLS, STABILIZE is the same of contact pairs"},
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
      ForeignKeyword{"Abaqus", "*CONTACT CONTROLS ASSIGNMENT, CONTACT THICKNESS REDUCTION",
                     P::surface_options,
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
      ForeignKeyword{"Abaqus", "*CONTACT INTERFERENCE, SHRINK", P::interaction, "OVERLAP RAMP TIME = 0.1",
                     ""},
      ForeignKeyword{"Abaqus", "*SURFACE INTERACTION, PAD THICKNESS", P::interaction,
                     "CONTACT OFFSET = 0.001", ""},
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
      ForeignKeyword{"Abaqus", "*SUBCYCLING", P::region, "SUBCYCLE BLOCKS = block_2",
                     "the small elements of these blocks, advanced in parts of the steps of all others"},
      ForeignKeyword{"Abaqus", "STATUS", P::results, "ELEMENT VARIABLES = death_status", "1 alive, 0 dead"},
  };
  return rows;
}

}  // namespace contactsim
