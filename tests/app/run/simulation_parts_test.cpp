// SPDX-License-Identifier: BSD-3-Clause
// What a simulation is made of: what stops it before its first step, where it ends, what it takes over.
#include <algorithm>

#include "app/run/simulation.hpp"
#include "contact/enforcement/contact_force.hpp"
#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/temporary_directory.hpp"
#include "support/two_cube_input.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

RunSettings ending_on_time(bool does) {
  RunSettings settings;
  settings.ends_on_time = does;
  return settings;
}

/// Two procedures of two cubes; the second one begins where the first one ends.
struct TwoProcedures : TwoCubeInput {
  TwoProcedures(const std::string& first, const std::string& second,
                const std::string& transfer = "include all blocks\n")
      : TwoCubeInput(two_cube_mesh(0.01).build(),
                     two_cube_deck(text_of({.name = "one", .region = first}) +
                                   text_of({.name = "two",
                                            .start = 0.1,
                                            .end = 0.2,
                                            .region = second,
                                            .more = "begin procedural transfer\n" + transfer + "end\n"}))) {
    const Region& later = definition.procedures[1].regions.front();
    if (later.contact) later_contact = make_contact_model(definition, later, mesh, diagnostics);
  }
  std::unique_ptr<Simulation> make_first() {
    return std::make_unique<Simulation>(input(), ending_on_time(true), diagnostics);
  }
  std::unique_ptr<Simulation> make_second(Simulation& first) {
    const Procedure& procedure = definition.procedures[1];
    return std::make_unique<Simulation>(RunInput{definition,
                                                 procedure,
                                                 procedure.regions.front(),
                                                 mesh,
                                                 later_contact ? &*later_contact : nullptr,
                                                 {},
                                                 &first},
                                        RunSettings{}, diagnostics);
  }
  std::optional<ContactModel> later_contact;
};

const std::string flies_down = "begin initial velocity\nblock = high\ncomponent = z\nmagnitude = -1\nend\n";

void run_to_end(Simulation& simulation) {
  simulation.begin();
  while (!simulation.is_over()) simulation.step();
  simulation.finish();
}

}  // namespace

TEST_CASE("a run ends past its termination time, or at it where another procedure goes on",
          "[app][simulation]") {
  const bool ends_on_time = GENERATE(false, true);
  TwoCubeInput cubes(two_cube_mesh(0.5).build(),
                     two_cube_deck(text_of({.end = 0.123, .region = flies_down})));
  Simulation simulation(cubes.input(), ending_on_time(ends_on_time), cubes.diagnostics);
  run_to_end(simulation);
  if (ends_on_time) CHECK(simulation.state().time == Approx(0.123).epsilon(1e-12));
  if (!ends_on_time) CHECK(simulation.state().time > 0.123 * (1.0 + 1e-9));
  CHECK(simulation.state().time - simulation.state().dt < 0.123);
}

TEST_CASE("OVERLAP REMOVAL ONLY ends a run with its start", "[app][simulation][overlap]") {
  TwoCubeInput cubes(
      two_cube_mesh(0.01).build(),
      two_cube_deck(text_of({.region = two_cube_contact("overlap removal only = on\n") + flies_down})));
  Simulation simulation(cubes.input(), {}, cubes.diagnostics);
  simulation.begin();
  CHECK(simulation.is_over());
  REQUIRE(simulation.end());
  CHECK(simulation.end()->reason == "OVERLAP REMOVAL ONLY");
  CHECK(simulation.state().step == 0);
}

TEST_CASE("contact that the run has no law for is refused with all else that is wrong", "[app][simulation]") {
  TwoCubeInput cubes(two_cube_mesh(0.01).build(), two_cube_deck(text_of({.region = two_cube_contact()})));
  cubes.diagnostics.add_error({}, "an earlier one");
  CHECK_THROWS_AS(Simulation(cubes.input(), {}, cubes.diagnostics), DeckError);
}

TEST_CASE("an output that would replace a kept file stops the run before its first step",
          "[app][simulation]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("kept.e");
  TwoCubeInput cubes(two_cube_mesh(0.5).build(),
                     two_cube_deck(text_of({.region = "begin results output r\ndatabase name = " + path +
                                                      "\nnodal variables = displacement\nend\n"})));
  RunSettings settings;
  settings.kept_files = {{path, "the mesh"}};
  Simulation simulation(cubes.input(), settings, cubes.diagnostics);
  CHECK_THROWS_AS(simulation.begin(), FileError);
  Simulation free(cubes.input(), {}, cubes.diagnostics);
  CHECK_NOTHROW(free.begin());
}

TEST_CASE("a procedure takes over state and contact of the one before where all of it is like",
          "[app][simulation][procedures]") {
  TwoProcedures runs(flies_down + two_cube_contact(), two_cube_contact());
  auto first = runs.make_first();
  auto second = runs.make_second(*first);
  CHECK(messages(runs.diagnostics).empty());
  run_to_end(*first);
  REQUIRE(first->contact_force()->histories()[{0}].deepest > 0.0);
  second->begin();
  CHECK(second->state().coordinates == first->state().coordinates);
  CHECK(second->state().velocity == first->state().velocity);
  CHECK(second->state().time == Approx(0.1));
  CHECK(second->contact_force()->histories()[{0}].deepest ==
        first->contact_force()->histories()[{0}].deepest);
}

TEST_CASE("contact that begins anew, or is over, is told; what holds from the start is refused",
          "[app][simulation][procedures]") {
  const auto told = [](const std::string& second, const std::string& transfer) {
    TwoProcedures runs(two_cube_contact(), second, transfer);
    auto first = runs.make_first();
    try {
      runs.make_second(*first);
    } catch (const DeckError&) {
    }
    return messages(runs.diagnostics);
  };
  const std::string all = "include all blocks\n";
  CHECK(told(two_cube_contact(), all).empty());
  CHECK_THAT(told("", all), Contains("contact of the procedure before is over: this one has none") &&
                                Contains("[contact-begins-anew]"));
  CHECK_THAT(told(two_cube_contact("", "self contact = on\n"), all),
             Contains("contact begins anew in what touches") && Contains("[contact-begins-anew]"));
  CHECK_THAT(told(two_cube_contact(), "block = low\n"), Contains("[contact-begins-anew]"));
  CHECK_THAT(
      told(two_cube_contact("", "friction model = tied\n"), all),
      Contains("contact that holds what is near at the start is not supported where a PROCEDURAL TRANSFER"));
}

TEST_CASE("the parts of a run's time are those that it has", "[app][simulation]") {
  const bool has_contact = GENERATE(false, true);
  TwoCubeInput cubes(
      two_cube_mesh(0.5).build(),
      two_cube_deck(text_of({.region = flies_down + (has_contact ? two_cube_contact() : "")})));
  Simulation simulation(cubes.input(), {}, cubes.diagnostics);
  run_to_end(simulation);
  std::vector<std::string> names;
  double sum = 0.0;
  for (const PartTime& part : simulation.part_times()) {
    names.push_back(part.name);
    CHECK(part.seconds >= 0.0);
    sum += part.seconds;
  }
  CHECK(std::ranges::count_if(names, [](const std::string& name) {
          return name.find("contact") != std::string::npos;
        }) == (has_contact ? 1 : 0));
  CHECK(sum <= 1.0001 * simulation.seconds() + 1e-9);
}
