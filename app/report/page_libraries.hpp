// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace contactsim {

/// The libraries that draw a report, as Debian has them: three.js and its OrbitControls (libjs-three),
/// Chart.js (libjs-chart.js).
struct PageLibraries {
  std::string three, orbit_controls, chart;  ///< texts
};

/// Reads them below the folder that the environment variable CONTACTSIM_JAVASCRIPT names, else below
/// /usr/share/javascript. Throws FileError that names the package of a missing one.
PageLibraries read_page_libraries();

}  // namespace contactsim
