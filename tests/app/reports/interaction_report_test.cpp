// SPDX-License-Identifier: BSD-3-Clause
#include "app/reports/interaction_report.hpp"

#include "support/catch.hpp"
#include "support/friction_law.hpp"
#include "support/squeezed.hpp"

using namespace contactsim;
using Catch::Matchers::Contains;
using contactsim::test::squeezed;

namespace {

/// Surfaces a and b, and pairs of these interactions at lines 7, 8, ...; equal names are one interaction.
ContactModel model_of_interactions(const std::vector<std::string>& names) {
  ContactModel model;
  for (const char* name : {"a", "b"}) model.surfaces.surfaces.emplace_back().name = name;
  for (std::size_t i = 0; i < names.size(); ++i) {
    SurfacePair& pair = model.pairs.emplace_back();
    pair.second = {1};
    pair.interaction = names[i];
    pair.location.line =
        i > 0 && names[i] == names[i - 1] ? model.pairs[PairIndex{0}].location.line : 7 + static_cast<int>(i);
  }
  return model;
}

std::string table_under(const std::string& title, const ContactModel& model) {
  const std::string text = squeezed(format_interactions(model, {}));
  const std::size_t at = text.find("\n" + title + "\n");
  return at == std::string::npos ? "" : text.substr(at + title.size() + 2);
}

}  // namespace

TEST_CASE("sides of shells have names", "[app][pairs]") {
  CHECK(name_of(ShellSides::both) == "both");
  CHECK(name_of(ShellSides::top) == "top");
  CHECK(name_of(ShellSides::bottom) == "bottom");
}

TEST_CASE("each interaction has one row of settings, by its first pair", "[app][pairs]") {
  ContactModel model = model_of_interactions({"press", "press", "slide"});
  model.pairs[PairIndex{0}].enforcement = Enforcement::momentum_balance;
  model.pairs[PairIndex{0}].normal_tolerance = 0.25;
  model.pairs[PairIndex{1}].normal_tolerance = 0.75;
  model.pairs[PairIndex{2}].enforcement = Enforcement::augmented_lagrange;
  model.pairs[PairIndex{2}].penalty_scale = 2.5;
  model.pairs[PairIndex{2}].damping_fraction = 0.125;
  const std::string text = table_under("Settings of interactions", model);
  CHECK_THAT(text, Contains("\npress 7 sliding momentum_balance 0.25 auto\n"
                            "slide 9 sliding augmented_lagrange auto auto\n"));
  CHECK_THAT(text, Contains("\npress 7 auto auto - 1 auto 0\nslide 9 auto auto - 2.5 auto 0.125\n"));
  CHECK_THAT(text, !Contains("0.75"));
}

TEST_CASE("interactions that reach, hold gaps and part as usual have no further tables", "[app][pairs]") {
  const ContactModel model = model_of_interactions({"press"});
  for (const char* title : {"Reach of interactions", "Gaps of interactions", "Sides of interactions"})
    CHECK(table_under(title, model) == "");
}

TEST_CASE("how far sides reach is reported where a line says it", "[app][pairs]") {
  ContactModel model = model_of_interactions({"near", "tracked", "closed", "adjusted", "plain"});
  model.pairs[PairIndex{0}].search_distance.emplace().given = 0.5;
  model.pairs[PairIndex{1}].tracking_distance = 2.0;
  model.pairs[PairIndex{2}].gap_closure.emplace();
  model.pairs[PairIndex{3}].adjusted_nodes = DeckName{"rim", {}};
  CHECK(table_under("Reach of interactions", model) ==
        "interaction line search distance tracking distance gap closure adjusted nodes\n"
        "near 7 0.5 auto - -\n"
        "tracked 8 all 2 - -\n"
        "closed 9 all auto auto -\n"
        "adjusted 10 all auto - rim\n");
}

TEST_CASE("what gaps of the start count as is reported where a line says it", "[app][pairs]") {
  ContactModel model = model_of_interactions({"off", "clear", "ramp", "touch", "no", "plain"});
  model.pairs[PairIndex{0}].gap.contact_offset = 0.125;
  model.pairs[PairIndex{1}].gap.initial_clearance = -0.5;
  model.pairs[PairIndex{2}].gap.overlap_ramp_time = 1e-3;
  model.pairs[PairIndex{3}].gap.ignore_initial_overlap = true;
  model.pairs[PairIndex{4}].gap.ignore_initial_overlap = false;
  CHECK(table_under("Gaps of interactions", model) ==
        "interaction line offset at the start\n"
        "off 7 0.125 as meshed\n"
        "clear 8 0 as -0.5\n"
        "ramp 9 0 overlaps come in within 0.001\n"
        "touch 10 0 overlaps as just touching\n"
        "no 11 0 as meshed\n");
}
