// SPDX-License-Identifier: BSD-3-Clause
#include "app/run_memory.hpp"

#include <fmt/format.h>

#include "core/digest.hpp"
#include "core/mesh/mesh_digest.hpp"
#include "core/state_motion.hpp"

namespace contactsim {

void archive(const RunMemory& memory, StateArchive& saved) {
  const Model& model = memory.model;
  State& state = memory.state;
  saved.expect("run/mesh", digest_of(*model.mesh), "nodes or elements");
  saved.expect("run/n_blocks", model.blocks.size(), "blocks");
  for (const ModelBlock& block : model.blocks) {
    const std::string name = fmt::format("run/materials/{}", block.mesh_block + 1);
    saved.expect(name, digest_of(block.material), "materials");
  }
  saved.expect("run/has_deaths", memory.death != nullptr ? 1 : 0, "element death");
  saved.expect("run/has_contact", memory.contact != nullptr ? 1 : 0, "contact");
  archive(state, saved);
  if (saved.restores()) state.time = memory.shifted_to.value_or(state.time);
  // Contact remembers the surfaces of the living.
  if (memory.death != nullptr && saved.restores()) memory.death->begin(state);
  if (memory.contact != nullptr) {
    memory.contact->force().archive(motion_of(state), saved);
  }
  memory.outputs.archive(saved);
}

}  // namespace contactsim
