// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/run_outputs.hpp"

#include <filesystem>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/flying_cube.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

OutputSettings settings_of(const FlyingCube& cube, const RunSettings& settings) {
  return output_settings({cube.definition, cube.definition.procedures.front(), cube.region(), cube.mesh},
                         settings, {}, nullptr);
}

}  // namespace

TEST_CASE("outputs go where the run says, and are computed always where elements may die", "[app][outputs]") {
  RunSettings settings;
  settings.results_path = "other.e";
  const FlyingCube plain;
  CHECK(settings_of(plain, settings).results_path == "other.e");
  CHECK_FALSE(settings_of(plain, {}).results_path);
  CHECK_FALSE(settings_of(plain, {}).always_computes);
  const FlyingCube dying({.region = "begin element death\nblock = upper\ndeath on inversion = on\nend\n"});
  CHECK(settings_of(dying, {}).always_computes);
}

TEST_CASE("an output that would replace a kept file, or cannot be written, is reported by its path",
          "[app][outputs]") {
  const TemporaryDirectory directory;
  const std::string mesh = directory.file("m.g"), other = directory.file("o.e");
  write_bytes(mesh, "mesh");
  write_bytes(other, "older results");
  const std::vector<RunFile> kept{{mesh, "the mesh"}};
  CHECK_NOTHROW(check_output_paths(kept, {other, directory.file("new.e")}));
  CHECK_NOTHROW(check_output_paths(kept, {}));
  CHECK_THROWS_WITH(check_output_paths(kept, {other, mesh}),
                    mesh + ": the output file " + mesh + " would overwrite the mesh, " + mesh);
  std::filesystem::create_hard_link(mesh, directory.file("same.e"));
  CHECK_THROWS_AS(check_output_paths(kept, {directory.file("same.e")}), FileError);
  CHECK_THROWS_AS(check_output_paths(kept, {directory.file("no/a.e")}), FileError);
  CHECK_FALSE(std::filesystem::exists(directory.file("new.e")));
  CHECK(read_bytes(other) == "older results");
}
