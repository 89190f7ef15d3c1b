// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "core/dynamics/model.hpp"
#include "core/dynamics/state.hpp"
#include "core/dynamics/time_step.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

/// Moves the nodes of small elements in parts of each step. Forces act as impulses: those of all other
/// elements, loads and contact once in a step of size D, those of small elements once in each part d of it:
///   v += D/2 a_large
///   D / d times:  v += d/2 a_small;  x += d v;  a_small = small forces(x) / mass;  v += d/2 a_small
///   v += D/2 a_large, with the large forces of the end
/// which is central differences with step D where no small element is, and with step d where there are no
/// others. It keeps momentum, is symmetric in time and symplectic for steps of one size.
/// Each rank moves all of these nodes: they are few.
/// Source: Tuckerman, Berne and Martyna, J. Chem. Phys. 97 (1992) 1990-2001, r-RESPA; Lew, Marsden, Ortiz and
/// West, Int. J. Numer. Meth. Engng 60 (2004) 153-212.
class Subcycler {
 public:
  /// All must outlive it; it changes their nodes and elements in the state.
  Subcycler(const Model& model, State& state);

  /// Sets the forces of the start.
  void start();
  /// To be called before a step begins: its nodes have the accelerations of the large forces again.
  void begin_step();
  /// Once all nodes have moved by their velocities: moves its own as they should. Their velocities are the
  /// mean ones of the step then, as elements, loads and contact ask for. Throws SolveError.
  void move(const TimeStepControl& control);
  /// Once the large forces are known: velocities become those of the end, before the large forces act.
  void end_move();
  /// When the step is complete: the small forces and what they accelerate are part of the state's.
  void end_step();

  double seconds() const { return seconds_; }

 private:
  /// How nodes move, or turn.
  struct Nodes {
    const Eigen::RowVectorXd* mass = nullptr;
    Eigen::Matrix3Xd* position = nullptr;
    Eigen::Matrix3Xd* velocity = nullptr;
    Eigen::Matrix3Xd* forces = nullptr;  // [3 x n]
    Eigen::Matrix3Xd small;              // [3 x n] acceleration by them, constrained
    Eigen::Matrix3Xd begun;              // [3 x n] positions at the start of a step
    Eigen::Matrix3Xd way;                // [3 x n] gone in a step
    Eigen::Matrix3Xd ended;              // [3 x n] velocity at its end
    std::vector<std::uint8_t> active;    // conditions that the projections are of
    std::vector<Eigen::Index> held;      // positions of nodes that conditions hold
    std::vector<Eigen::Matrix3d> free;   // [held] projections
    std::vector<std::uint8_t> is_held;   // [n]
  };
  struct Works {
    double internal = 0.0, reaction = 0.0;  // [energy]
  };

  void find_free(const KinematicConstraints& constraints, Nodes& nodes) const;
  void set_forces(double time, double dt);
  void add_chunks(double time, double dt);
  void accelerate();
  void accelerate(Nodes& nodes) const;
  template <class Act>
  Works sum_works(const Act& act) const;
  Works kick(Nodes& nodes, double span) const;
  Works kick_and_drift(Nodes& nodes, double dt) const;
  void count(const Works& works);
  double part_of(double left, double time, const TimeStepControl& control);
  Eigen::Index size() const { return static_cast<Eigen::Index>(model_.subcycles.nodes.size()); }

  const Model& model_;
  State& state_;
  Nodes moving_, turning_;
  struct Chunk {
    std::size_t block, chunk;
  };
  std::vector<Chunk> chunks_;
  std::vector<ChunkStep> steps_;  // [chunks_]
  std::vector<NodeSums> sums_;    // [n_blocks] to positions in Subcycles::nodes
  std::optional<ElementIndex> critical_;
  double seconds_ = 0.0;
};

}  // namespace contactsim
