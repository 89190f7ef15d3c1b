// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/checkpoint.hpp"

#include <fmt/format.h>

#include "core/base/digest.hpp"
#include "core/mesh/mesh_digest.hpp"

namespace contactsim {

std::vector<RunMark> archive(const Checkpoint& checkpoint, StateArchive& saved) {
  const Model& model = checkpoint.model;
  State& state = checkpoint.state;
  saved.expect("run/mesh", digest_of(*model.mesh), "nodes or elements");
  saved.expect("run/n_blocks", model.blocks.size(), "blocks");
  for (const ModelBlock& block : model.blocks) {
    const std::string name = fmt::format("run/materials/{}", block.mesh_block + 1);
    saved.expect(name, digest_of(block.material), "materials");
  }
  saved.expect("run/has_deaths", checkpoint.death != nullptr ? 1 : 0, "element death");
  saved.expect("run/has_contact", checkpoint.contact != nullptr ? 1 : 0, "contact");
  archive(state, saved);
  if (checkpoint.load_steps != nullptr) checkpoint.load_steps->archive(saved);
  if (saved.restores()) state.time = checkpoint.shifted_to.value_or(state.time);
  // Contact remembers the surfaces of the living.
  if (checkpoint.death != nullptr && saved.restores()) checkpoint.death->begin(state);
  if (checkpoint.contact != nullptr) checkpoint.contact->archive(state, saved);
  checkpoint.outputs.archive(saved);
  return archive(checkpoint.marks, saved);
}

}  // namespace contactsim
