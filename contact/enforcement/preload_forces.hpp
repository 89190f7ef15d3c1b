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
///
/// Balanced contact takes some steps to find how it presses, as each step has few passes and begins with the
/// forces of the last. In these first steps the nodes keep the forces of before, so that nothing moves, and
/// what contact changes by is held in its place; where it does not come to rest by that, what was held at
/// first is held.
class PreloadForces {
 public:
  /// Of a contact node [force] [force length].
  struct Entry {
    ContactNodeIndex node;
    Eigen::Vector3d force = Eigen::Vector3d::Zero(), moment = Eigen::Vector3d::Zero();
  };
  using Entries = IndexedVector<ContactNodeIndex, Entry>;  ///< of all contact nodes

  /// Takes over what is pressed with before.
  ///   ends  of letting go [time]
  void take_over(const ContactAssembler& before, double ends);
  /// Whether forces of before wait for begin().
  bool is_to_begin() const { return !before_.empty() && n_settled_ == 0; }
  /// Holds what is pressed with before less what is now.
  ///   begins   of letting go [time]
  ///   settles  whether contact takes some steps to find its forces
  void begin(const ContactAssembler& now, double begins, bool settles);
  /// Whether settle() is to be called at the end of the step.
  bool is_settling() const { return !before_.empty() && n_settled_ > 0; }
  /// Adds what nodes lack of the forces of before, and holds it from now on; no more when contact has come to
  /// rest.
  ///   assembler  the forces of the step, with what is held
  void settle(ContactAssembler& assembler);
  /// Gives up what is still held.
  void clear();
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

  /// What a step lacks, and its size over that of the forces of before [1].
  double find_lack(const ContactAssembler& assembler, Entries& lack) const;
  void end_settling();

  std::vector<Entry> entries_;
  Entries before_;            ///< [n_nodes] until contact has settled
  std::vector<Entry> first_;  ///< what was held at first, until then
  double begins_ = 0.0, ends_ = 0.0;
  double share_of_before_ = 0.0;
  double last_lack_ = 0.0;  ///< of the step before, as find_lack() returns it [1]
  int n_settled_ = 0;       ///< calls of begin() and settle()
};

}  // namespace contactsim
