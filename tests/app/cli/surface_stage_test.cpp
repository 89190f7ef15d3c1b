// SPDX-License-Identifier: BSD-3-Clause
#include "app/cli/surface_stage.hpp"

#include <filesystem>

#include "core/definition/simulation.hpp"
#include "support/catch.hpp"
#include "support/deck_dump.hpp"
#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/report_region.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Two cubes, a deck d.i with these lines of a region, and a quiet log.
struct StagedSurfaces : TemporaryDirectory {
  explicit StagedSurfaces(const std::string& region)
      : definition(deck_of_region(region)), log(file("a.log"), true) {
    log.begin(false);
  }
  ResolvedContact resolve() {
    return resolve_contact(options, definition, region_of(definition), mesh, log, warnings);
  }
  std::string logged() const { return read_bytes(file("a.log")); }

  Options options;
  SimulationDefinition definition;
  Mesh mesh = MeshBuilder()
                  .add_hexes({.id = 1, .name = "low"})
                  .add_hexes({.id = 2, .name = "high", .origin = {0, 0, 2}, .share_nodes = false})
                  .build();
  Log log;
  Diagnostics warnings;
};

std::string contact_of(const std::string& lines) {
  return "begin contact definition\n" + lines + "begin interaction defaults\ngeneral contact = on\nend\nend";
}

}  // namespace

TEST_CASE("surfaces of a region are resolved, and their tables logged", "[app][surfaces]") {
  StagedSurfaces stage(contact_of("skin all blocks = on\n"));
  const ResolvedContact resolved = stage.resolve();
  CHECK(resolved.code == ExitCode::done);
  REQUIRE(resolved.model);
  CHECK(resolved.model->surfaces.surfaces.size() == 2);
  CHECK(resolved.model->pairs.size() == 1);
  CHECK_THAT(stage.logged(), Contains("\nContact surfaces\n") && Contains("\nContact pairs\n"));
  CHECK(messages(stage.warnings) == "");
}

TEST_CASE("what the tables warn of is repeated at the end, with its line", "[app][surfaces]") {
  StagedSurfaces stage(
      contact_of("contact surface one contains low\ncontact surface two contains low\n"
                 "contact surface three contains high\n"));
  CHECK(stage.resolve().code == ExitCode::done);
  CHECK_THAT(messages(stage.warnings), Contains("d.i:15:") && Contains("'two'"));
}

TEST_CASE("a region without contact has no model, and tables that are asked for are empty",
          "[app][surfaces]") {
  StagedSurfaces stage("");
  stage.options.surfaces_csv = stage.file("s.csv");
  const ResolvedContact resolved = stage.resolve();
  CHECK_FALSE(resolved.model);
  CHECK(resolved.code == ExitCode::done);
  CHECK(stage.logged() == "\nThe deck has no contact definition.\n");
  CHECK(read_bytes(stage.file("s.csv")) == "surface,block,element,side,kind,area\n");
}

TEST_CASE("a file of surfaces that cannot be written keeps no other from it", "[app][surfaces]") {
  StagedSurfaces stage(contact_of("skin all blocks = on\n"));
  stage.options.surfaces_json = stage.file("no/s.json");
  stage.options.surfaces_csv = stage.file("s.csv");
  stage.options.surfaces_exodus = stage.file("s.exo");
  const ResolvedContact resolved = stage.resolve();
  CHECK(resolved.code == ExitCode::file);
  CHECK(resolved.model);
  CHECK(std::filesystem::exists(stage.file("s.csv")));
  CHECK(std::filesystem::exists(stage.file("s.exo")));
  CHECK_THAT(stage.logged(), Contains("error: " + stage.file("no/s.json") + ": "));
}

TEST_CASE("names that the mesh does not have are errors, with all others of the deck", "[app][surfaces]") {
  StagedSurfaces stage(contact_of("contact surface one contains lov\n"));
  CHECK_THROWS_AS(stage.resolve(), DeckError);
  write_exodus(stage.file("m.g"), stage.mesh);
  Diagnostics errors;
  errors.add_error({}, "an earlier one");
  add_surface_name_errors(stage.definition, region_of(stage.definition), stage.file("m.g"), errors);
  CHECK(errors.error_count() == 2);
  CHECK_THAT(messages(errors), Contains("d.i:14:") && Contains("'lov'") && Contains("did you mean 'low'?"));
}

TEST_CASE("names are not looked up without contact, or in a mesh that cannot be read", "[app][surfaces]") {
  const StagedSurfaces stage(contact_of("contact surface one contains lov\n")), plain("");
  write_exodus(stage.file("m.g"), stage.mesh);
  Diagnostics errors;
  add_surface_name_errors(stage.definition, region_of(stage.definition), stage.file("none.g"), errors);
  add_surface_name_errors(plain.definition, region_of(plain.definition), stage.file("m.g"), errors);
  CHECK(messages(errors) == "");
}
