// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "core/dynamics/model.hpp"
#include "core/dynamics/rank_share.hpp"
#include "core/dynamics/state.hpp"

namespace contactsim {

/// A block out of whose deformation more energy has come than was in it.
struct NegativeEnergy {
  std::uint32_t mesh_block;  ///< position in the mesh
  double energy;             ///< < 0, of its stresses or of its resistance to hourglasses [energy]
  bool is_of_hourglasses;
};

/// Tells when the internal energy of a block has become negative. Whatever a block's forces give out comes
/// back as kinetic energy, so that the balance of all energies does not show it. What stresses at the start
/// can give out is theirs to give. Viscosity is left out: it cannot give any.
class BlockEnergyWatch {
 public:
  static constexpr std::int64_t interval = 100;  ///< steps from look to look

  ///   model, share  must outlive the watch; no share on one rank
  explicit BlockEnergyWatch(const Model& model, const RankShare* share = nullptr)
      : model_(model), share_(share) {}

  /// To be called once, before the first step or where a run goes on.
  void begin(const State& state);

  /// The blocks whose energy now is negative by a worrying share of the largest term, each the first time.
  std::vector<NegativeEnergy> look(const State& state);

 private:
  struct Watched {
    double reserve;  ///< that stresses may give out beyond the work done on them [energy]
    bool is_reported = false;
  };

  template <class OfChunk>
  std::vector<double> sum_over_blocks(const OfChunk& of_chunk) const;

  const Model& model_;
  const RankShare* share_;
  std::vector<Watched> blocks_;  // as Model::blocks
};

}  // namespace contactsim
