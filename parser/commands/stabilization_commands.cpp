// SPDX-License-Identifier: BSD-3-Clause
#include "parser/commands/stabilization_commands.hpp"

namespace contactsim {

namespace {

/// CONTACT STABILIZATION = ON, OFF or how many times the automatic coefficient.
void read_stabilization(Arguments& arguments, StabilizationSettings& stabilization) {
  // As any switch, or a number.
  if (arguments.accept("on") || arguments.accept("true") || arguments.accept("yes")) {
    stabilization.scale = 1.0;
  } else if (arguments.accept("off") || arguments.accept("false") || arguments.accept("no")) {
    stabilization.scale = 0.0;
  } else {
    stabilization.scale = arguments.non_negative();
  }
}

void read_stabilization_range(Arguments& arguments, StabilizationSettings& stabilization) {
  stabilization.range.reset();
  if (!arguments.accept("auto")) stabilization.range = arguments.positive();
}

}  // namespace

std::vector<Row<StabilizationSettings>> stabilization_rows() {
  using S = StabilizationSettings;
  return {
      row<S>("contact stabilization", "= {ON|OFF|<real >= 0>}", read_stabilization,
             "Of load steps: sides that are near each other resist their relative motion in a step, fully as "
             "a time stepping block begins and no more as it ends, so that bodies which contact alone will "
             "hold come to rest against it. A number multiplies the automatic coefficient [1]: a thousandth "
             "of the stiffness of the elements behind both sides, times the steps that the block would have; "
             "contactsim's own line, CNTSTB of OptiStruct",
             "OFF"),
      row("stabilization tangential fraction", read::non_negative, &S::tangential_fraction,
          "Share of the coefficient of CONTACT STABILIZATION that counts along the surface [1]; contactsim's "
          "own line, TFRAC of OptiStruct",
          "0.1"),
      row("stabilization remaining fraction", read::share, &S::remaining_fraction,
          "Share of CONTACT STABILIZATION that is left as a time stepping block ends [1]; more than 0 leaves "
          "its forces in the equilibrium, which is told; contactsim's own line, S1 of OptiStruct",
          "0"),
      row<S>("stabilization range", "= {AUTO|<real > 0>}", read_stabilization_range,
             "Gap from which on CONTACT STABILIZATION has no effect; it falls in proportion up to there "
             "[length]. AUTO is the mean edge of the faces; contactsim's own line, LMTGAP of OptiStruct",
             "AUTO"),
  };
}

}  // namespace contactsim
