// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/page_libraries.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

constexpr const char* usual_folder = "/usr/share/javascript";

std::string read_library(const std::filesystem::path& folder, const char* name, const char* package) {
  const std::string path = (folder / name).string();
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  if (file && !text.view().empty()) return std::move(text).str();
  throw FileError(path, fmt::format("this library draws the report and is not there; install the package {} "
                                    "(./bootstrap build does), or name its folder, in place of {}, by the "
                                    "environment variable CONTACTSIM_JAVASCRIPT",
                                    package, usual_folder));
}

}  // namespace

PageLibraries read_page_libraries() {
  const char* given = std::getenv("CONTACTSIM_JAVASCRIPT");
  const std::filesystem::path folder = given != nullptr ? given : usual_folder;
  return {read_library(folder, "three/three.min.js", "libjs-three"),
          read_library(folder, "three/examples/js/controls/OrbitControls.js", "libjs-three"),
          read_library(folder, "chart.js/chart.min.js", "libjs-chart.js")};
}

}  // namespace contactsim
