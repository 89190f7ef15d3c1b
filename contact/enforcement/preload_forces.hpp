// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "contact/enforcement/contact_assembler.hpp"

namespace contactsim {

class StateArchive;

/// What contact of load steps has pressed and dragged with at their end, and contact of the explicit
/// procedure that takes over does not at its start: facets press each other elsewhere than weighted nodes,
/// and the penalty by overlaps that multipliers have closed. Let go at once, it would set what was in
/// equilibrium ringing. It is held, and let go evenly over a time; as it comes from contact, its sum and
/// moment are none.
class PreloadForces {
 public:
  /// Of a contact node [force] [force length].
  struct Entry {
    std::uint32_t node = 0;
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  };

  /// Holds what is pressed with before less what is now.
  ///   begins, ends  of letting go [time]
  void begin(const ContactAssembler& before, const ContactAssembler& now, double begins, double ends);
  /// Gives up what is still held.
  void clear() { entries_.clear(); }
  /// Adds what is held at a time, and gives up what is over.
  void add_to(ContactAssembler& assembler, double time);
  /// The work on the bodies in a step, by the mean of what is held at both ends [energy].
  ///   kinematics  of the end
  double work(const ContactKinematics& kinematics, double time, double dt) const;

  const std::vector<Entry>& entries() const { return entries_; }
  double ends() const { return ends_; }
  /// The size of all over that of what was pressed with before [1].
  double share_of_before() const { return share_of_before_; }

  void archive(StateArchive& saved);

 private:
  /// How much of it is held at a time [1].
  double held(double time) const;

  std::vector<Entry> entries_;
  double begins_ = 0.0, ends_ = 0.0;
  double share_of_before_ = 0.0;
};

}  // namespace contactsim
