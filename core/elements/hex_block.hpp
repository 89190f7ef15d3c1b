// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <vector>

#include "core/elements/hex8.hpp"
#include "core/elements/node_sums.hpp"
#include "core/mesh/mesh.hpp"
#include "core/threads.hpp"

namespace contactsim {

/// What the elements of a block report of a step.
struct BlockStep {
  double stable_step = 0.0;     ///< the least of all elements [time]
  double least_volume = 0.0;    ///< [length^3]
  double hourglass_work = 0.0;  ///< of the step [energy]
  double viscous_work = 0.0;    ///< of the step [energy]
};

/// The mean-quadrature hexahedra of one block and one law, in batches of n_lanes; the last batch is filled up
/// with copies of the last element, whose numbers count nowhere.
template <class Law>
class HexBlock {
 public:
  /// Precondition: the block has hexahedra of eight nodes, at least one.
  ///   coordinates  [3 x n_nodes] of the undeformed mesh [length]
  HexBlock(const ElementBlock& block, const Law& law, const HexParameters& parameters,
           const Eigen::Matrix3Xd& coordinates)
      : law_(law),
        parameters_(parameters),
        n_elements_(block.n_elements),
        batches_((block.n_elements + n_lanes - 1) / n_lanes),
        sums_(block.nodes, 8, static_cast<std::size_t>(coordinates.cols())) {
    for (std::size_t i = 0; i < batches_.size(); ++i) set_up(block, coordinates, i);
  }

  std::size_t n_elements() const { return n_elements_; }
  /// Mass of each element [mass].
  double mass(std::size_t element) const { return batches_[element / n_lanes].mass(lane_of(element)); }
  const HexState<Law>& state_of(std::size_t element) const { return batches_[element / n_lanes].state; }

  /// Brings the elements to the end of a step and adds their internal forces.
  ///   x       [3 x n_nodes] coordinates at the end of the step [length]
  ///   v       [3 x n_nodes] velocities at its middle [length/time]
  ///   forces  [3 x n_nodes] [force]
  BlockStep advance(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double dt,
                    Eigen::Matrix3Xd& forces);

 private:
  struct Batch {
    std::array<std::array<std::uint32_t, n_lanes>, 8> nodes;
    Lanes mass;
    HexState<Law> state;
  };

  static Eigen::Index lane_of(std::size_t element) { return static_cast<Eigen::Index>(element % n_lanes); }
  static HexVectors gather(const Batch& batch, const Eigen::Matrix3Xd& values);
  void set_up(const ElementBlock& block, const Eigen::Matrix3Xd& coordinates, std::size_t batch);
  BlockStep advance_batches(const Eigen::Matrix3Xd& x, const Eigen::Matrix3Xd& v, double dt,
                            std::size_t begin, std::size_t end);

  Law law_;
  HexParameters parameters_;
  std::size_t n_elements_;
  std::vector<Batch> batches_;
  std::vector<BatchForces<8>> forces_ = std::vector<BatchForces<8>>(batches_.size());
  NodeSums sums_;
};

extern template class HexBlock<ElasticLaw>;
extern template class HexBlock<PlasticLaw<LinearHardening>>;
extern template class HexBlock<PlasticLaw<PowerHardening>>;
extern template class HexBlock<PlasticLaw<JohnsonCookHardening>>;

}  // namespace contactsim
