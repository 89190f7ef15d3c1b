// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "contact/enforcement/constraint_losses.hpp"
#include "contact/enforcement/constraint_pass.hpp"
#include "contact/enforcement/constraint_system.hpp"
#include "contact/enforcement/push_lists.hpp"
#include "core/base/lanes.hpp"

namespace contactsim {

/// The rows of a system that push along the normals of their groups alone, on plain carriers: those of points
/// without friction. The force of a row is one number f, and that of a carrier by a group n sum_r w_r f_r, so
/// that the eight carriers of a group stand in lanes, and their vectors are read and written once for all of
/// its rows. The same bits for any number of threads.
class PressingRows {
 public:
  explicit PressingRows(NodeMobility& mobility) : mobility_(mobility) {}

  /// Takes over the groups that press. To be called again when groups have been removed.
  void list(const ConstraintSystem& system);
  std::size_t n_groups() const { return groups_.size(); }
  /// Adds the areas of the points to those of their carriers.
  void add_areas(const ConstraintSystem& system, LeaningAreas& areas) const;
  /// Sets the softness of the rows by the areas of all. Returns whether some have none.
  ///   dt  the coming step [time]
  bool set_softness(const LeaningAreas& areas, double dt, ConstraintSystem& system);

  /// Takes over what rows start from, and their softness.
  void begin_passes(const ConstraintSystem& system);
  /// Pushes the carriers by the forces of the last pass, without momentum.
  void push_forces(const ConstraintSystem& system);
  /// Finds the next forces, and pushes the carriers by those that the pass after starts from.
  ConstraintPass pass(const ConstraintSystem& system, double dt, double momentum);
  /// Gives the points of the rows what ConstraintLosses gives them, and adds the losses up.
  ///   known  [n_rows of the system] gets what the next step is to know of the rows that press
  ContactLoss finish(ConstraintSystem& system, const ConstraintLosses& losses,
                     std::span<ContactHistory::KnownPoint> known);

 private:
  /// What a pass reads of a group; carriers beyond its terms have no weight.
  struct Group {
    std::array<std::uint32_t, PointCarriers::max_terms> carriers{};
    Eigen::Matrix<double, 4, 1, Eigen::DontAlign> normal;  // unit; the fourth number is 0 [1]
    std::uint32_t first_row = 0, n_rows = 0;               // in the system
    std::uint32_t n_terms = 0;

    std::uint32_t end_row() const { return first_row + n_rows; }
  };
  /// A group that pushes a carrier.
  struct GroupPush {
    std::uint32_t group = 0, term = 0;
  };
  /// What passes read and write of rows, by their positions in the system; all 0 of rows that do not press.
  struct Rows {
    std::vector<double> start, softness;  // see ConstraintRow [length] [length/force]
    std::vector<double> rate;             // force per gap [force/length]
    std::vector<double> least;            // force: 0, or minus infinity where a row may pull [force]
    std::vector<double> force, ahead;     // of the last pass, and with momentum [force]
    std::vector<double> opening;          // how fast the last pass opens the gap [length/time]

    void resize(std::size_t n, bool are_all_pressing);
  };

  template <class Sums, class Visit>
  Sums sum_chunks(int n_threads, const Visit& visit) const;
  template <class FindForces>
  ConstraintPass push_groups(const ConstraintSystem& system, const FindForces& find_forces);
  void find_forces(std::uint32_t begin, std::uint32_t end, double dt, double momentum, ConstraintPass& sums);

  NodeMobility& mobility_;
  std::vector<Group> groups_;
  Rows rows_;
  PushLists<GroupPush> pushes_;              // of several threads
  std::vector<Lanes> group_forces_;          // [n_groups] by which groups push then [force]
  std::vector<NodeVector> last_velocities_;  // [n_carriers] scratch [length/time]
  std::vector<double> carrier_softness_;     // [n_carriers] scratch
};

}  // namespace contactsim
