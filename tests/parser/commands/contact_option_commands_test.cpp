// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/contact_option_commands.hpp"

#include "support/bound_region.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A contact definition whose lines are fine.
ContactDefinition contact_of(const std::string& lines) {
  const BoundContact bound = bound_contact(lines);
  CHECK(bound.messages == "");
  return bound.contact;
}

}  // namespace

TEST_CASE("an empty contact definition has the documented defaults", "[parser][contact]") {
  const ContactDefinition contact = contact_of("");
  CHECK(contact.search.tolerance == SearchOptions::Tolerance::automatic);
  CHECK(contact.dash.search_length_scaling == 0.15);
  CHECK(contact.enforcement.penalty_scale == 1.0);
  CHECK_FALSE(contact.overlap_removal.is_on());
  CHECK(contact.overlap_removal.iterations == 10);
  CHECK_FALSE(contact.overlap_removal.is_all_there_is);
  CHECK(contact.variables == ContactVariables::when_written);
  CHECK_FALSE(contact.debug.visualizes_facets);
  CHECK(contact.debug.output_level == 0);
}

TEST_CASE("search options are bound", "[parser][contact]") {
  const SearchOptions search =
      contact_of(
          "begin search options fine\nglobal search once = on\n"
          "search tolerance = user_defined\nnormal tolerance = 1\ntangential tolerance = 2\ncapture "
          "tolerance = 3\nend\n")
          .search;
  CHECK(search.global_search_once);
  CHECK(search.tolerance == SearchOptions::Tolerance::user_defined);
  CHECK(search.normal_tolerance == 1.0);
  CHECK(search.tangential_tolerance == 2.0);
  CHECK(search.capture_tolerance == 3.0);
}

TEST_CASE("dash and enforcement options are bound", "[parser][contact]") {
  const ContactDefinition contact = contact_of(
      "begin dash options\nsearch length scaling = 0.3\nend\n"
      "begin enforcement options e\npenalty scale = 0.5\n"
      "momentum balance iterations = 25\nend\nenforcement = penalty\n");
  CHECK(contact.enforcement.balance_iterations == 25);
  CHECK(contact.enforcement.enforcement == Enforcement::penalty);
  CHECK(contact.dash.search_length_scaling == 0.3);
  CHECK(contact.enforcement.penalty_scale == 0.5);
}

TEST_CASE("options of other algorithms are reported to have no effect", "[parser][contact]") {
  CHECK(bound_contact("begin search options\nglobal search increment = 5\nend\n"
                      "begin dash options\naccuracy level = 2\nsubdivision level = 1\nend\n"
                      "begin enforcement options\n"
                      "num geometry update iterations = 2\nend\n")
            .messages ==
        "a.i:3:1: warning: 'global search increment' has no effect here; global searches come when motion "
        "demands them [deck-ignored]\n"
        "a.i:6:1: warning: 'accuracy level' has no effect here; gaps are found exactly [deck-ignored]\n"
        "a.i:7:1: warning: 'subdivision level' has no effect here; faces are paired whole [deck-ignored]\n"
        "a.i:10:1: warning: 'num geometry update iterations' has no effect here; the set of touching pairs "
        "is renewed in every step [deck-ignored]\n");
}

TEST_CASE("surface options may repeat", "[parser][contact]") {
  const auto options = contact_of(
                           "begin surface options\nsurface = a b\nremove surface = c\nbeam radius = 0.5\n"
                           "lofting algorithm = on\ncontact shell thickness = let_contact_choose\n"
                           "allowable shell thickness = 0.2 to 0.8\ncoincident shell treatment = simple\n"
                           "coincident shell hex treatment = embedded\nend\nbegin shell lofting\nend\n")
                           .surface_options;
  REQUIRE(options.size() == 2);
  CHECK(joined_names(options[0].surfaces) == "a b");
  CHECK(joined_names(options[0].removed_surfaces) == "c");
  CHECK(options[0].beam_radius == 0.5);
  CHECK(options[0].shell_thickness == SurfaceOptions::ShellThickness::let_contact_choose);
  CHECK(options[0].smallest_shell_thickness == 0.2);
  CHECK(options[0].largest_shell_thickness == 0.8);
  CHECK(options[0].coincident_shells == SurfaceOptions::CoincidentShells::simple);
  CHECK(options[0].coincident_shell_hexes == SurfaceOptions::CoincidentShellHexes::embedded);
  CHECK_FALSE(options[1].beam_radius);
  CHECK(options[1].shell_thickness == SurfaceOptions::ShellThickness::actual_thickness);
  CHECK(options[1].coincident_shells == SurfaceOptions::CoincidentShells::disallow);
}

TEST_CASE("lofting cannot be switched off", "[parser][contact]") {
  const std::string deck = "begin surface options\nlofting algorithm = off\nend\n";
  CHECK(bound_contact(deck).messages ==
        "a.i:3:21: error: shells, beams and particles in contact are always lofted; a side set "
        "of the shell makes a one-sided surface without thickness\n");
  CHECK(bound_contact(deck, true).messages ==
        "a.i:3:21: warning: shells, beams and particles in contact are always lofted, passed "
        "over; a side set of the shell makes a one-sided surface without thickness "
        "[deck-refused]\n");
}

TEST_CASE("the bounds of shell thickness must be in order", "[parser][contact]") {
  CHECK(bound_contact("begin surface options\nallowable shell thickness = 1 to 0.5\nend\n").messages ==
        "a.i:3:1: error: the largest allowable shell thickness is below the smallest\n");
}

TEST_CASE("overlap removal is switched on by a line, by the block, or by the line of 2003",
          "[parser][contact]") {
  CHECK(contact_of("initial overlap removal = on\n").overlap_removal.is_on());
  CHECK(contact_of("remove initial overlap\n").overlap_removal.is_on());
  CHECK(contact_of("begin remove initial overlap\nend\n").overlap_removal.is_on());
  CHECK_FALSE(contact_of("initial overlap removal = off\nbegin remove initial overlap\nend\n")
                  .overlap_removal.is_on());
}

TEST_CASE("overlap removal takes all of its lines", "[parser][contact]") {
  const OverlapRemoval removal =
      contact_of(
          "overlap removal only = on\nbegin remove initial overlap\noverlap normal tolerance = 0.1\n"
          "overlap tangential tolerance = 0.2\noverlap iterations = 100\nshell overlap iterations = 20\n"
          "shell overlap tolerance = 0.3\nend\n")
          .overlap_removal;
  CHECK(removal.is_all_there_is);
  CHECK(removal.normal_tolerance == 0.1);
  CHECK(removal.tangential_tolerance == 0.2);
  CHECK(removal.iterations == 100);
  CHECK(removal.shell_iterations == 20);
  CHECK(removal.shell_tolerance == 0.3);
}

TEST_CASE("contact variables are computed as they are written or in every step", "[parser][contact]") {
  CHECK(contact_of("compute contact variables = on\n").variables == ContactVariables::when_written);
  CHECK(contact_of("compute contact variables = off\n").variables == ContactVariables::when_written);
  CHECK(contact_of("compute contact variables = EVERY_STEP\n").variables == ContactVariables::every_step);
}

TEST_CASE("the debug block is bound", "[parser][contact]") {
  const ContactDebug debug = contact_of(
                                 "begin debug\nvisualize contact facets = on\n"
                                 "output contact surfaces and constraints = on\noutput level = 2\nend\n")
                                 .debug;
  CHECK(debug.visualizes_facets);
  CHECK(debug.writes_constraints);
  CHECK(debug.output_level == 2);
}

TEST_CASE("the search ACME is taken as DASH, with a warning", "[parser][contact]") {
  contact_of("search = dash\n");
  CHECK(bound_contact("search = acme\n").messages ==
        "a.i:2:10: warning: the search ACME is no more, contactsim's own is used; write SEARCH = DASH "
        "[deck-old]\n");
  CHECK(bound_contact("search = dush\n").messages ==
        "a.i:2:10: error: expected one of dash, acme for 'search', found 'dush'; did you mean 'dash'?\n");
  CHECK(bound_contact("search =\n").messages == "a.i:2:1: error: expected DASH after 'search'\n");
}

TEST_CASE("the update of surfaces for element death cannot be switched off", "[parser][contact]") {
  contact_of("update all surfaces for element death = on\n");
  contact_of("update all surfaces for element death\n");
  CHECK(bound_contact("update all surfaces for element death = off\n").messages ==
        "a.i:2:41: error: contact surfaces always follow element death; leave the line out, or write ON\n");
}

TEST_CASE("lines of implicit runs and of parallel runs are ignored", "[parser][contact]") {
  CHECK(contact_of("enforcement = al\n").enforcement.enforcement == Enforcement::augmented_lagrange);
  CHECK(
      bound_contact("enforcement = kinematic\ncontact residual norm scale factor = 2\nbegin search options\n"
                    "secondary decomposition = on\nend\n")
          .messages ==
      "a.i:2:15: warning: kinematic enforcement has no effect; momentum is balanced in explicit procedures, "
      "AUGMENTED_LAGRANGE lets nothing through in others [deck-ignored]\n"
      "a.i:3:1: warning: 'contact residual norm scale factor' has no effect here; of implicit "
      "runs only [deck-ignored]\n"
      "a.i:5:1: warning: 'secondary decomposition' has no effect here; of parallel runs only "
      "[deck-ignored]\n");
}
