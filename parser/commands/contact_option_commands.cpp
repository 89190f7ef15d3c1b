// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_option_commands.hpp"

#include <limits>

#include "parser/commands/row_lists.hpp"

namespace contactsim {

namespace {

const Table<SearchOptions>& search_options_table() {
  using S = SearchOptions;
  static const auto tolerance = choice_of<S::Tolerance>({"automatic", "user_defined"});
  static const Table<S> table({
      ignored<S>("global search increment", "= <integer>", "Global searches come when motion demands them"),
      row("global search once", read::on_off, &S::global_search_once, "Searches globally at the start only"),
      row("search tolerance", tolerance, &S::tolerance, "Whether the tolerances below are taken"),
      row("normal tolerance", read::non_negative, &S::normal_tolerance,
          "Reach of the search off a face [length]", "automatic"),
      row("tangential tolerance", read::non_negative, &S::tangential_tolerance,
          "Reach of the search beyond a face's edge [length]", "automatic"),
      row("capture tolerance", read::non_negative, &S::capture_tolerance,
          "How far apart sides may be at the start for TIED and other laws that hold to hold them [length]; "
          "the gap stays as it is, and laws that do not hold know no such tolerance",
          "automatic: NORMAL TOLERANCE, else 0.15 of the face's size"),
      ignored<S>("face multiplier", "= <real>", "SEARCH LENGTH SCALING of DASH OPTIONS scales the search"),
      ignored<S>("secondary decomposition", "= {ON|OFF}", "Of parallel runs only"),
  });
  return table;
}

const Table<DashOptions>& dash_options_table() {
  using D = DashOptions;
  static const Table<D> table({
      row("search length scaling", read::non_negative, &D::search_length_scaling,
          "Search distance as a multiple of the face's size [1]"),
      ignored<D>("accuracy level", "= <real>", "Gaps are found exactly"),
      ignored<D>("subdivision level", "= <integer>", "Faces are paired whole"),
      ignored<D>("interaction definition scheme", "= {EXPLICIT|AUTOMATIC}",
                 "The deck's interactions are taken"),
  });
  return table;
}

const Table<EnforcementOptions>& enforcement_options_table() {
  using E = EnforcementOptions;
  static const Table<E> table({
      row("momentum balance iterations", read::positive_integer, &E::balance_iterations,
          "Passes over the contact points in a step at most; fewer where the momentum is balanced before",
          "20"),
      ignored<E>("num geometry update iterations", "= <integer>",
                 "The set of touching pairs is renewed in every step"),
      row("penalty scale", read::positive, &E::penalty_scale,
          "Multiplies the penalty stiffness of all pairs [1]; contactsim's own line"),
  });
  return table;
}

void read_lofting(Arguments& arguments, SurfaceOptions&) {
  if (arguments.at_end()) arguments.fail_here("expected ON or OFF after 'lofting algorithm'");
  const Word& value = arguments.peek();
  if (!arguments.on_off()) {
    arguments.refuse(value, "shells, beams and particles in contact are always lofted",
                     "a side set of the shell makes a one-sided surface without thickness");
  }
}

void read_feature_angle(Arguments& arguments, SurfaceOptions& options) {
  const bool is_off = !arguments.at_end() && arguments.accept("off");
  options.feature_angle = is_off ? std::numeric_limits<double>::infinity() : arguments.non_negative();
}

void read_allowable_thickness(Arguments& arguments, SurfaceOptions& options) {
  options.smallest_shell_thickness = arguments.non_negative();
  arguments.expect("to");
  options.largest_shell_thickness = arguments.positive();
  if (options.largest_shell_thickness < options.smallest_shell_thickness) {
    arguments.fail_here("the largest allowable shell thickness is below the smallest");
  }
}

const Table<SurfaceOptions>& surface_options_table() {
  using S = SurfaceOptions;
  static const auto thickness = choice_of<S::ShellThickness>({"actual_thickness", "let_contact_choose"});
  static const auto shells = choice_of<S::CoincidentShells>({"disallow", "ignore", "simple"});
  static const auto hexes = choice_of<S::CoincidentShellHexes>({"disallow", "ignore", "tapered", "embedded"});
  static const Table<S> table({
      row("surface", read::names_of(NameKind::contact_surface), &S::surfaces,
          "Contact surfaces that these options are for", "all"),
      row("remove surface", read::names_of(NameKind::contact_surface), &S::removed_surfaces,
          "Contact surfaces that they are not for"),
      row("beam radius", read::positive, &S::beam_radius, "Radius of lofted beams [length]", "the section's"),
      row("edge contact", read::on_off, &S::has_edge_contact,
          "Whether beams, particles and sharp edges meet each other; contactsim's own line", "ON"),
      row<S>("feature angle", "= {<degrees>|OFF}", read_feature_angle,
             "Edges at which faces turn by more [degrees] meet other edges; contactsim's own line", "45"),
      row<S>("lofting algorithm", "= {ON|OFF}", read_lofting,
             "OFF is refused: lofted geometry is always used", "ON"),
      row("contact shell thickness", thickness, &S::shell_thickness, "Which thickness lofted shells have"),
      row<S>("allowable shell thickness", "= <low> TO <high>", read_allowable_thickness,
             "Bounds of LET_CONTACT_CHOOSE as multiples of the edge length [1]", "0.1 TO 1"),
      row("coincident shell treatment", shells, &S::coincident_shells, "Shells that share all their nodes"),
      row("coincident shell hex treatment", hexes, &S::coincident_shell_hexes, "Shells on faces of solids"),
  });
  return table;
}

const Table<OverlapRemoval>& overlap_removal_table() {
  using O = OverlapRemoval;
  static const Table<O> table({
      row("overlap normal tolerance", read::non_negative, &O::normal_tolerance,
          "Deepest overlap that is removed [length]", "automatic"),
      row("overlap tangential tolerance", read::non_negative, &O::tangential_tolerance,
          "Overlap beyond a face's edge that is removed [length]", "automatic"),
      row("overlap iterations", read::positive_integer, &O::iterations, "Passes [1] at most"),
      row("shell overlap iterations", read::positive_integer, &O::shell_iterations,
          "Passes [1] over shells, beams and particles at most"),
      row("shell overlap tolerance", read::non_negative, &O::shell_tolerance,
          "Overlap of shells, beams and particles that is left [length]"),
      ignored<O>("debug iteration plot", "= {ON|OFF}", "The passes are reported in the log"),
  });
  return table;
}

const Table<ContactDebug>& debug_table() {
  using D = ContactDebug;
  static const Table<D> table({
      row("visualize contact facets", read::on_off, &D::visualizes_facets,
          "Contact facets become a mesh of their own in the results"),
      row("output contact surfaces and constraints", read::on_off, &D::writes_constraints,
          "Surfaces and pairs are written out"),
      row("output level", read::non_negative_integer, &D::output_level,
          "More is logged with a higher level [1]"),
      ignored<D>("write salinas mpcs to", "<file> AT TIME <t>", "Constraints for Salinas are not written"),
  });
  return table;
}

void read_enforcement(Arguments& arguments, ContactDefinition& contact) {
  const Word word = arguments.at_end() ? Word{} : arguments.peek();
  if (arguments.accept("al")) {
    contact.enforcement.enforcement = Enforcement::augmented_lagrange;
    return;
  }
  if (arguments.accept("kinematic")) {
    arguments.warn("deck-ignored", word, "kinematic enforcement has no effect",
                   "momentum is balanced in explicit procedures, AUGMENTED_LAGRANGE lets nothing through in "
                   "others");
    return;
  }
  static const auto enforcement =
      choice_of<Enforcement>({"momentum_balance", "penalty", "augmented_lagrange"});
  contact.enforcement.enforcement = enforcement.read(arguments);
}

void read_search(Arguments& arguments, ContactDefinition&) {
  static const Choices choices({"dash", "acme"});
  if (arguments.at_end()) arguments.fail_here("expected DASH after 'search'");
  const Word& value = arguments.peek();
  if (arguments.choice(choices) == 1) {
    arguments.warn("deck-old", value, "the search ACME is no more, contactsim's own is used",
                   "write SEARCH = DASH");
  }
}

void read_contact_variables(Arguments& arguments, ContactDefinition& contact) {
  static const Choices choices({"on", "off", "every_step"});
  const bool is_every_step = arguments.choice(choices) == 2;
  contact.variables = is_every_step ? ContactVariables::every_step : ContactVariables::when_written;
}

/// Surfaces always follow element death, which is what ON asks for.
void read_death_update(Arguments& arguments, ContactDefinition&) {
  if (arguments.at_end()) return;
  const Word& value = arguments.peek();
  if (!arguments.on_off()) {
    arguments.refuse(value, "contact surfaces always follow element death",
                     "leave the line out, or write ON");
  }
}

void mark_overlap_removal(Arguments&, ContactDefinition& contact) {
  contact.overlap_removal.is_asked_for = true;
}

void read_overlap_block(const Block& found, const DeckName&, ContactDefinition& contact, Binding& binding) {
  contact.overlap_removal.has_block = true;
  overlap_removal_table().bind(found, contact.overlap_removal, binding);
}

std::vector<Row<ContactDefinition>> overlap_rows() {
  using C = ContactDefinition;
  using O = OverlapRemoval;
  Row<C> overlap_block = block<C, O>("remove initial overlap", Naming::optional, overlap_removal_table,
                                     &C::overlap_removal, "Overlap is removed before the first step");
  overlap_block.read_block = read_overlap_block;
  return joined<C>({
      lift_all<C, O>(
          {
              row("initial overlap removal", read::on_off, &O::is_asked_for,
                  "Moves nodes before the first step so that surfaces do not overlap", "OFF"),
              row("overlap removal only", read::on_off, &O::is_all_there_is,
                  "Stops the run after overlap removal"),
          },
          &C::overlap_removal),
      {
          row<C>("remove initial overlap", "", mark_overlap_removal,
                 "Older spelling of INITIAL OVERLAP REMOVAL = ON", "OFF"),
          std::move(overlap_block),
      },
  });
}

}  // namespace

std::vector<Row<ContactDefinition>> contact_option_rows() {
  using C = ContactDefinition;
  return joined<C>({
      {
          row<C>("search", "= {DASH|ACME}", read_search, "Search algorithm; ACME is taken as DASH", "DASH"),
          row<C>("enforcement", "= {MOMENTUM_BALANCE|PENALTY|AUGMENTED_LAGRANGE|AL|KINEMATIC}",
                 read_enforcement,
                 "How the sides of all pairs are kept apart that say nothing else, AL is short for "
                 "AUGMENTED_LAGRANGE; KINEMATIC leaves it at the default",
                 "MOMENTUM_BALANCE, AUGMENTED_LAGRANGE in quasi-static procedures"),
          ignored<C>("contact residual norm scale factor", "= <real>", "Of implicit runs only"),
          block<C, SearchOptions>("search options", Naming::optional, search_options_table, &C::search,
                                  "Reach and rhythm of the search"),
          block<C, DashOptions>("dash options", Naming::optional, dash_options_table, &C::dash,
                                "Fine tuning of the search"),
          block<C, EnforcementOptions>("enforcement options", Naming::optional, enforcement_options_table,
                                       &C::enforcement, "Passes of the enforcement"),
          block<C, SurfaceOptions>("surface options", Naming::optional, surface_options_table,
                                   &C::surface_options, "Geometry of lofted shells and beams")
              .or_spelled("shell lofting"),
          row<C>("compute contact variables", "= {ON|OFF|EVERY_STEP}", read_contact_variables,
                 "When contact output is computed: as it is written, or in every step", "OFF"),
          block<C, ContactDebug>("debug", Naming::optional, debug_table, &C::debug,
                                 "What is shown of contact"),
          row<C>("update all surfaces for element death", "= {ON|OFF}", read_death_update,
                 "Older line: surfaces always follow element death", "ON"),
      },
      overlap_rows(),
  });
}

}  // namespace contactsim
