// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/pair_report.hpp"

#include "support/catch.hpp"
#include "support/friction_law.hpp"
#include "support/squeezed.hpp"

using namespace contactsim;
using Catch::Contains;
using contactsim::test::squeezed;

namespace {

SurfacePair make_pair(std::uint32_t first, std::uint32_t second) {
  SurfacePair pair;
  pair.first = {first};
  pair.second = {second};
  pair.interaction = "general contact";
  pair.location.line = 7;
  pair.is_from_defaults = true;
  return pair;
}

/// Surfaces lid, box and dust (nodes) with three pairs; the last is named.
ContactModel three_pairs() {
  ContactModel model;
  for (const char* name : {"lid", "box", "dust"}) model.surfaces.surfaces.emplace_back().name = name;
  model.pairs = {make_pair(0, 1), make_pair(0, 2), make_pair(1, 2)};
  model.pairs[{0}].law = test::share(test::coulomb(0.3));
  model.pairs[{1}].formulation = ConstraintFormulation::node_face;
  model.pairs[{1}].is_one_sided = true;
  SurfacePair& named = model.pairs[{2}];
  named.interaction = "tie";
  named.location.line = 12;
  named.is_from_defaults = false;
  named.law = test::share(test::friction_law("tied"));
  named.behavior = InteractionBehavior::infinitesimal_sliding;
  named.normal_tolerance = 0.25;
  named.penalty_stiffness = 1e9;
  return model;
}

SurfaceSummaries three_summaries() {
  SurfaceSummaries summaries(3);
  summaries[{0}].owned = 10;
  summaries[{0}].top = summaries[{0}].bottom = 2;
  summaries[{0}].nodes = 21;
  summaries[{1}].owned = 4;
  summaries[{1}].nodes = 9;
  summaries[{2}].nodes = 5;
  return summaries;
}

}  // namespace

TEST_CASE("the pair table says how surfaces meet, before they are searched", "[app][pairs]") {
  CHECK(squeezed(format_pairs(three_pairs(), three_summaries(), {})) ==
        "\nContact pairs\n"
        "no first second interaction line law formulation\n"
        "1 lid box general contact 7 friction 0.3 face_face\n"
        "2 lid dust general contact 7 frictionless node_face one-sided\n"
        "3 box dust tie 12 tied face_face\n"
        "\nfirst second first second\n"
        "no first second faces faces nodes nodes smallest gap in reach\n"
        "1 lid box 14 4 21 9 - -\n"
        "2 lid dust 14 0 21 5 - -\n"
        "3 box dust 4 0 9 5 - -\n"
        "\nSettings of interactions\n"
        "normal tangential\n"
        "interaction line behavior enforcement tolerance tolerance\n"
        "general contact 7 sliding penalty auto auto\n"
        "tie 12 infinitesimal penalty 0.25 auto\n"
        "\noverlap overlap capture penalty penalty damping\n"
        "interaction line normal tangential tolerance scale stiffness fraction\n"
        "general contact 7 auto auto - 1 auto 0\n"
        "tie 12 auto auto 0.25 1 1e+09 0\n"
        "tolerances and overlaps are lengths, auto: from the size of each face, the smallest and the "
        "largest\n");
}

TEST_CASE("beside what is automatic stands the smallest and the largest length", "[app][pairs]") {
  ContactModel model = three_pairs();
  model.pairs[PairIndex{2}].normal_tolerance.reset();
  model.pairs[PairIndex{2}].search_distance.emplace();
  AutomaticLengths lengths;
  for (LengthRange* range : {&lengths.normal, &lengths.capture}) range->add(0.15);
  lengths.normal.add(0.3);
  lengths.overlap_normal.add(0.5);
  lengths.edge.add(0.25);
  const std::string text = squeezed(
      format_pairs(model, three_summaries(), {}, IndexedVector<PairIndex, AutomaticLengths>(3, lengths)));
  CHECK_THAT(text, Contains("tie 12 infinitesimal penalty auto 0.15..0.3 auto\n"));
  CHECK_THAT(text, Contains("tie 12 auto 0.5 auto auto 0.15 1 "));
  CHECK_THAT(text, Contains("\nReach of interactions\n"));
  CHECK_THAT(text, Contains("tie 12 auto 0.5 auto 0.15..0.3 - -"));
}

TEST_CASE("the pair table shows gaps and reach, and counts far pairs of the defaults", "[app][pairs]") {
  const InitialGaps starts{{-0.125, 40}, {}, {}};
  const std::string text = format_pairs(three_pairs(), three_summaries(), starts);
  CHECK_THAT(text, Contains("        -0.125        40\n"));
  CHECK_THAT(text, !Contains("lid                   dust"));
  CHECK_THAT(text, Contains("box                   dust"));
  CHECK_THAT(text, Contains("      1 pair of general or self contact with nothing in reach\n"));
}

TEST_CASE("pairs that are all far are counted without a table", "[app][pairs]") {
  ContactModel model = three_pairs();
  model.pairs[PairIndex{2}].is_from_defaults = true;
  CHECK_THAT(format_pairs(model, three_summaries(), InitialGaps(3)),
             Contains("\nContact pairs\n      3 pairs of general or self contact with nothing in reach\n"));
}

TEST_CASE("the pair table says what may not part and which sides of shells there are", "[app][pairs]") {
  ContactModel model = three_pairs();
  CHECK_THAT(format_pairs(model, three_summaries(), {}), !Contains("Sides of interactions"));
  model.pairs[PairIndex{2}].separates = false;
  CHECK_THAT(squeezed(format_pairs(model, three_summaries(), {})),
             Contains("\nSides of interactions\ninteraction line separation first second\n"
                      "tie 12 off both both\n"));
  model.pairs[PairIndex{0}].sides = {ShellSides::top, ShellSides::bottom};
  CHECK_THAT(squeezed(format_pairs(model, three_summaries(), {})),
             Contains("general contact 7 on top bottom\ntie 12 off both both\n"));
}

TEST_CASE("half a million pairs are not all listed", "[app][pairs]") {
  ContactModel model = three_pairs();
  model.pairs.assign(1500, model.pairs[{0}]);
  const std::string text = format_pairs(model, three_summaries(), {});
  CHECK_THAT(text, Contains("\n1000  lid"));
  CHECK_THAT(text, !Contains("\n1001  lid"));
  CHECK_THAT(text, Contains("      and 500 more pairs\n"));
}

TEST_CASE("after a run the table tells what pairs did, and which never touched", "[app][pairs]") {
  IndexedVector<PairIndex, PairHistory> histories(3);
  PairHistory& touched = histories[{0}];
  touched.contact_time = 0.5;
  touched.peak_force = 1234.5;
  touched.impulse = {1, -2, 3.25};
  touched.work = 6.5;
  touched.friction_work = 0.75;
  touched.taken = 5.0;
  touched.stored_at_start = 0.25;
  CHECK(squeezed(format_pair_histories(three_pairs(), histories)) ==
        "\nContact of pairs in the run\n"
        "no first second contact time peak force deepest of thickness friction work\n"
        "1 lid box 0.5 1234.5 0 0 0.75\n"
        "\nno first second impulse x impulse y impulse z work made\n"
        "1 lid box 1 -2 3.25 6.5 1.25\n"
        "\nPairs that never touched\n"
        "no first second interaction line\n"
        "2 lid dust general contact 7\n"
        "3 box dust tie 12\n");
}

TEST_CASE("a run in which nothing touched lists no contact", "[app][pairs]") {
  CHECK(format_pair_histories(three_pairs(), IndexedVector<PairIndex, PairHistory>(3))
            .starts_with("\nPairs that never touched\n"));
}

TEST_CASE("without pairs there are no pair tables", "[app][pairs]") {
  CHECK(format_pairs({}, {}, {}).empty());
  CHECK(format_pair_histories({}, {}).empty());
}
