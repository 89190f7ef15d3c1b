// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/energy_warnings.hpp"

#include <fmt/format.h>

namespace contactsim {

void EnergyWarnings::step(const State& state) {
  if (state.step % BlockEnergyWatch::interval == 0) end(state);
  const Energies& e = state.energies;
  if (has_warned_ || !watch_.is_off(state)) return;
  has_warned_ = true;
  warnings_.add_warning("energy-error", {},
                        fmt::format("at step {}, time {:.6g}, the energy balance is off by {:.3g} "
                                    "({:.2g} % of the largest term)",
                                    state.step, state.time, e.error, 100.0 * e.error / e.largest),
                        "a smaller TIME STEP SCALE FACTOR tells whether the steps are too large");
}

void EnergyWarnings::end(const State& state) {
  for (const NegativeEnergy& found : block_watch_.look(state)) {
    const std::string block =
        fmt::format("{} (block {})", model_.mesh->name({EntityKind::block, found.mesh_block}),
                    model_.mesh->blocks()[found.mesh_block].id);
    warnings_.add_warning(
        "negative-internal-energy", {},
        fmt::format(
            "at step {}, time {:.6g}, {} of {} {} given out {:.3g} more energy than {} taken up "
            "({:.2g} % of the largest term)",
            state.step, state.time, found.is_of_hourglasses ? "the hourglass resistance" : "the stresses",
            block, found.is_of_hourglasses ? "has" : "have", -found.energy,
            found.is_of_hourglasses ? "it has" : "they have", -100.0 * found.energy / state.energies.largest),
        "the energy balance does not show it; a smaller TIME STEP SCALE FACTOR or finer elements help");
  }
}

}  // namespace contactsim
