// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/interaction_commands.hpp"

#include "parser/commands/block_rows.hpp"
#include "parser/commands/condition_line_commands.hpp"
#include "parser/commands/smoothing_commands.hpp"
#include "parser/commands/stabilization_commands.hpp"

namespace contactsim {

namespace {

const Choice one_friction{"", "has both a friction model and a friction coefficient"};

void read_penalty_stiffness(Arguments& arguments, PairSettings& pair) {
  pair.penalty_stiffness.emplace();
  if (!arguments.accept("auto")) pair.penalty_stiffness->given = arguments.positive();
}

const Choice one_start{"", "says twice what overlaps and gaps of the start count as"};

/// SEPARATION = ON or OFF; OptiStruct's YES and NO.
void read_separation(Arguments& arguments, PairSettings& pair) {
  static const Choices choices({"on", "off", "yes", "no"});
  pair.separation = arguments.choice(choices) % 2 == 0;
}

/// SIDES, with the words of OptiStruct's MORIENT and of Abaqus' POLARITY for the same. OPENGAP pushes from
/// the side that is faced, as both sides do.
void read_sides(Arguments& arguments, PairSettings& pair) {
  static const Choices choices(
      {"both", "top", "bottom", "opengap", "norm", "revnorm", "two sided", "spos", "sneg"});
  if (!arguments.at_end() && arguments.is_next("overlap"))
    arguments.fail_here("OVERLAP goes by where the sides are at the start; name the side",
                        "TOP is the side that the normal of the shell looks out of, BOTTOM the other");
  pair.sides = static_cast<ShellSides>(arguments.choice(choices) % 3);
}

/// How the sides may part, and which sides of shells there are.
std::vector<Row<PairSettings>> side_rows() {
  using P = PairSettings;
  return {
      row<P>(
          "separation", "= {ON|OFF}", read_separation,
          "OFF: what has touched once does not part any more, but slides freely: a gap pulls, up to NORMAL "
          "TOLERANCE, else half of the thinner element; friction is of what presses. Of faces and nodes, "
          "not of edges and lines; contactsim's own line",
          "ON"),
      row<P>(
          "sides", "= {BOTH|TOP|BOTTOM}", read_sides,
          "Which side of the shells of SIDE A, or of all where the interaction has SURFACES, the other "
          "surface meets: TOP is the one that the normal looks out of; rims take part in BOTH alone, edges "
          "always; contactsim's own line",
          "BOTH")
          .or_spelled("morient"),
  };
}

/// What contact takes off the gaps of the mesh.
std::vector<Row<GapSettings>> gap_rows() {
  using G = GapSettings;
  return {
      row("contact offset", read::real, &G::contact_offset,
          "Taken off every gap of the pair: the sides touch that far apart [length]; contactsim's own line",
          "0"),
      row("initial clearance", read::real, &G::initial_clearance,
          "Gap that counts at the start wherever the sides are near each other then, whatever the mesh says; "
          "below 0 they overlap [length]. Nodes do not move; contactsim's own line",
          "that of the mesh")
          .or_spelled("clearance")
          .one_of(one_start),
      row("ignore initial overlap", read::on_off, &G::ignore_initial_overlap,
          "Overlaps of the start count as just touching: only what closes further is pushed apart; "
          "contactsim's own line",
          "OFF")
          .one_of(one_start),
      row("overlap ramp time", read::positive, &G::overlap_ramp_time,
          "Overlaps of the start come to count within this time, as for a press fit [time]; contactsim's own "
          "line",
          "at once")
          .one_of(one_start),
  };
}

void check_gap(const PairSettings& pair, DeckNames& names) {
  if (!pair.gap.contact_offset || !pair.gap.initial_clearance) return;
  names.add_problem_of_block("has both CONTACT OFFSET and INITIAL CLEARANCE",
                             "the clearance is the gap that counts: leave the offset out");
}

/// Reads AUTO, or a length.
template <auto setting>
void read_length_or_auto(Arguments& arguments, PairSettings& pair) {
  auto& length = pair.*setting;
  length.emplace();
  if (!arguments.accept("auto")) length->given = arguments.non_negative();
}

/// Which nodes are moved onto the other side before the first step.
std::vector<Row<PairSettings>> adjustment_rows() {
  using P = PairSettings;
  return {
      row<P>(
          "gap closure tolerance", "= {AUTO|<real >= 0>}", read_length_or_auto<&P::gap_closure>,
          "Nodes of SIDE B, of both sides without one, that are no farther in front of the other side, or "
          "behind it, are moved onto it before the first step, without strain [length]. AUTO is 0.05 of the "
          "mean edge of the faces; nothing goes farther than a SEARCH DISTANCE, or onto its own surface; "
          "contactsim's own line",
          "no node is moved")
          .or_spelled("adjust"),
      row("adjust node set", read::name_of(NameKind::node_set), &P::adjusted_nodes,
          "Node set whose nodes are moved onto the other side before the first step, however far; "
          "contactsim's own line",
          "none"),
  };
}

/// What meets what, and how the sides are kept apart.
std::vector<Row<PairSettings>> meeting_rows() {
  using P = PairSettings;
  static const auto formulation = choice_of<ConstraintFormulation>({"node_face", "face_face"});
  static const auto behavior =
      choice_of<InteractionBehavior>({"sliding", "infinitesimal_sliding", "no_interaction"});
  static const auto enforcement =
      choice_of<Enforcement>({"momentum_balance", "penalty", "augmented_lagrange"});
  return {
      row("friction model", read::name_of(NameKind::friction_model), &P::friction_model,
          "Friction model of the pair", "frictionless")
          .one_of(one_friction),
      row("constraint formulation", formulation, &P::formulation, "What meets what", "FACE_FACE"),
      row("interaction behavior", behavior, &P::behavior,
          "How the pair moves: INFINITESIMAL_SLIDING keeps the partners of the start, and their planes go on "
          "beyond their edges for what slides off them; what element death exposes, and what loses its "
          "partner by it, slides. NO_INTERACTION of an interaction switches the pair off in its periods, "
          "whatever others say",
          "SLIDING"),
      row("enforcement", enforcement, &P::enforcement,
          "How the sides are kept apart: MOMENTUM_BALANCE lets nothing through and does not lower the time "
          "step; PENALTY is elastic. A given PENALTY STIFFNESS means PENALTY. AUGMENTED_LAGRANGE, of "
          "quasi-static procedures, makes the penalty exact by multipliers",
          "MOMENTUM_BALANCE, AUGMENTED_LAGRANGE in quasi-static procedures"),
      row("normal tolerance", read::non_negative, &P::normal_tolerance,
          "Reach of the search off a face [length]", "automatic"),
      row("tangential tolerance", read::non_negative, &P::tangential_tolerance,
          "Reach of the search beyond a face's edge [length]", "automatic"),
      row("overlap normal tolerance", read::non_negative, &P::overlap_normal_tolerance,
          "Deepest overlap that is removed at the start [length]", "automatic"),
      row("overlap tangential tolerance", read::non_negative, &P::overlap_tangential_tolerance,
          "Overlap beyond a face's edge that is removed at the start [length]", "automatic"),
      row("capture tolerance", read::non_negative, &P::capture_tolerance,
          "How far apart sides may be at the start for TIED and other laws that hold to hold them [length]; "
          "the gap stays as it is, and laws that do not hold know no such tolerance",
          "automatic: NORMAL TOLERANCE, else 0.15 of the face's size"),
      row("tracking distance", read::non_negative, &P::tracking_distance,
          "Gaps of nodes that do not touch are told in the output up to this one; a node with nothing so "
          "near "
          "has the distance itself [length]; contactsim's own line",
          "automatic: a share of the face")
          .or_spelled("tracking thickness"),
      row<P>("search distance", "= {AUTO|<real >= 0>}", read_length_or_auto<&P::search_distance>,
             "Nodes and faces of SIDE B that are farther from the other side at the start are never looked "
             "at; without sides, pairs of which both are farther [length]. AUTO is two mean edges of the "
             "faces. What element death exposes is always looked at; contactsim's own line",
             "everything is looked at")
          .or_spelled("srchdis"),
      row("penalty scale", read::positive, &P::penalty_scale,
          "Multiplies the penalty stiffness [1]; contactsim's own line", "1"),
      row<P>("penalty stiffness", "= {AUTO|<real>}", read_penalty_stiffness,
             "Force per area and depth [force/length^3]; contactsim's own line", "AUTO"),
      row("contact damping fraction", read::non_negative, &P::damping_fraction,
          "Share of critical damping along the normal [1]; contactsim's own line", "0"),
      ignored<P>("automatic kinematic partition", "[= {ON|OFF}]",
                 "Of ACME's enforcement; penalties are balanced"),
  };
}

/// The lines that pairs and their defaults share.
std::vector<Row<PairSettings>> pair_rows() {
  return joined<PairSettings>({meeting_rows(),
                               side_rows(),
                               adjustment_rows(),
                               {smoothing_row()},
                               lift_all(gap_rows(), &PairSettings::gap),
                               lift_all(stabilization_rows(), &PairSettings::stabilization)});
}

Row<InteractionDefaults> exclusion_row() {
  const auto names = read::names_of_or_all(NameKind::contact_surface);
  const auto read_exclusion = [names](Arguments& arguments, InteractionDefaults& defaults) {
    defaults.exclusions.push_back({arguments.location(), names.read(arguments)});
  };
  return row<InteractionDefaults>(
             "exclude surfaces", "= " + names.syntax, read_exclusion,
             "Contact surfaces of which no pair meets, whatever interactions say; one alone does not meet "
             "itself, one with ALL neither itself nor any other. May be repeated; contactsim's own line",
             "none")
      .references(NameKind::contact_surface);
}

const Table<InteractionDefaults>& interaction_defaults_table() {
  using D = InteractionDefaults;
  const auto check = [](const D& defaults, DeckNames& names) { check_gap(defaults.pair, names); };
  static const Table<D> table(
      joined<D>({
          {
              row("general contact", read::on_off, &D::general_contact, "Every surface meets every other"),
              row("self contact", read::on_off, &D::self_contact, "Every surface meets itself"),
              row("surfaces", read::names_of(NameKind::contact_surface), &D::surfaces,
                  "Contact surfaces that general and self contact take", "all")
                  .or_spelled("contact surfaces"),
              exclusion_row(),
          },
          lift_all(pair_rows(), &D::pair),
      }),
      check);
  return table;
}

void check(const Interaction& interaction, DeckNames& names) {
  check_gap(interaction.pair, names);
  const bool has_a = !interaction.side_a.empty(), has_b = !interaction.side_b.empty();
  if ((has_a || has_b) && !interaction.surfaces.empty()) {
    names.add_problem_of_block("takes either SURFACES or SIDE A and SIDE B, found both");
  } else if (has_a != has_b) {
    names.add_problem_of_block(has_a ? "has SIDE A and lacks SIDE B" : "has SIDE B and lacks SIDE A");
  } else if (!has_a && interaction.surfaces.empty()) {
    names.add_problem_of_block("names no contact surfaces", "give it a SURFACES line, or SIDE A and SIDE B");
  }
}

const Table<Interaction>& interaction_table() {
  using I = Interaction;
  using K = NameKind;
  const std::string all_of_a_side =
      "ALL stands for every surface but the one it meets, and with NO_INTERACTION for that one too";
  static const Table<I> table(
      joined<I>({
          {
              row("surfaces", read::names_of(K::contact_surface), &I::surfaces,
                  "Contact surfaces of which every pair meets; one alone or twice meets itself")
                  .or_spelled("contact surfaces"),
              row("side a", read::names_of_or_all(K::contact_surface), &I::side_a,
                  "Contact surfaces that give the faces of NODE_FACE; " + all_of_a_side)
                  .or_spelled("master"),
              row("side b", read::names_of_or_all(K::contact_surface), &I::side_b,
                  "Contact surfaces that give the nodes of NODE_FACE; " + all_of_a_side)
                  .or_spelled("slave"),
              row("friction coefficient", read::non_negative, &I::friction_coefficient,
                  "Coulomb coefficient, in place of a friction model [1]")
                  .one_of(one_friction),
              ignored<I>("kinematic partition", "= <real>", "Of ACME's enforcement; penalties are balanced"),
              ignored<I>("tension release", "= <real>", "Of implicit runs only"),
              ignored<I>("slip penalty", "= <real>", "Of implicit runs only"),
              ignored<I>("pushback factor", "= <real>", "Penalties push back by their stiffness alone"),
          },
          lift_all(pair_rows(), &I::pair),
          lift_all(period_rows(), &I::periods),
      }),
      check);
  return table;
}

/// Two blocks of defaults would contradict each other for every pair.
void add_defaults(ContactDefinition& contact, InteractionDefaults defaults) {
  if (contact.interaction_defaults) {
    const DeckLocation& first = contact.interaction_defaults->name.location;
    throw ArgumentError{{Severity::error, "", defaults.name.location, 1,
                         "a second INTERACTION DEFAULTS in one contact definition",
                         "the first stands at " + to_string(first)}};
  }
  contact.interaction_defaults = std::move(defaults);
}

}  // namespace

std::vector<Row<ContactDefinition>> interaction_rows() {
  using C = ContactDefinition;
  return {
      block<C, InteractionDefaults>("interaction defaults", Naming::optional, interaction_defaults_table,
                                    add_defaults, "What every pair of surfaces gets")
          .or_spelled("defaults"),
      block<C, Interaction>("interaction", Naming::optional, interaction_table, &C::interactions,
                            "Pairs of surfaces that are treated their own way")
          .defines(NameKind::interaction),
  };
}

}  // namespace contactsim
