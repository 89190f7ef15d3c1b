// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/page_libraries.hpp"

#include <cstdlib>
#include <filesystem>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;
using Catch::Matchers::Contains;

namespace {

/// Sets the folder of libraries as long as it lives.
struct LibraryFolder {
  explicit LibraryFolder(const std::string& path) { setenv("CONTACTSIM_JAVASCRIPT", path.c_str(), 1); }
  ~LibraryFolder() { unsetenv("CONTACTSIM_JAVASCRIPT"); }
};

}  // namespace

TEST_CASE("a missing library is named with its package and the variable", "[app][report]") {
  const TemporaryDirectory directory;
  const LibraryFolder folder(directory.file("nowhere"));
  CHECK_THROWS_WITH(read_page_libraries(), Contains("nowhere/three/three.min.js") &&
                                               Contains("libjs-three") && Contains("CONTACTSIM_JAVASCRIPT"));
}

TEST_CASE("Debian's libraries are found", "[app][report]") {
  const PageLibraries libraries = read_page_libraries();
  CHECK_THAT(libraries.three, Contains("WebGLRenderer"));
  CHECK_THAT(libraries.orbit_controls, Contains("OrbitControls"));
  CHECK_THAT(libraries.chart, Contains("Chart.js v3"));
}

TEST_CASE("libraries of a folder of one's own are taken, an empty one is none", "[app][report]") {
  const TemporaryDirectory directory;
  const LibraryFolder folder(directory.file("js"));
  std::filesystem::create_directories(directory.file("js/three/examples/js/controls"));
  std::filesystem::create_directories(directory.file("js/chart.js"));
  write_bytes(directory.file("js/three/three.min.js"), "three");
  write_bytes(directory.file("js/three/examples/js/controls/OrbitControls.js"), "orbit");
  CHECK_THROWS_WITH(read_page_libraries(), Contains(directory.file("js/chart.js/chart.min.js") + ": ") &&
                                               Contains("libjs-chart.js"));
  write_bytes(directory.file("js/chart.js/chart.min.js"), "");
  CHECK_THROWS_AS(read_page_libraries(), FileError);
  write_bytes(directory.file("js/chart.js/chart.min.js"), "chart");
  const PageLibraries libraries = read_page_libraries();
  CHECK(libraries.three == "three");
  CHECK(libraries.orbit_controls == "orbit");
  CHECK(libraries.chart == "chart");
}
