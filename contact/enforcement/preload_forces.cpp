// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/preload_forces.hpp"

#include <algorithm>
#include <cmath>

#include "core/base/state_archive.hpp"

namespace contactsim {

void PreloadForces::begin(const ContactAssembler& before, const ContactAssembler& now, double begins,
                          double ends) {
  entries_.clear();
  begins_ = begins;
  ends_ = ends;
  const bool has_moments = !before.moments().empty();
  double held = 0.0, pressed = 0.0;
  for (std::uint32_t i = 0; i < before.nodes().size(); ++i) {
    Entry entry{i, (before.nodes()[i] - now.nodes()[i]).head<3>()};
    if (has_moments) entry.moment = before.moments()[i] - now.moments()[i];
    held += entry.force.squaredNorm();
    pressed += before.nodes()[i].head<3>().squaredNorm();
    if (!entry.force.isZero(0.0) || !entry.moment.isZero(0.0)) entries_.push_back(entry);
  }
  share_of_before_ = pressed > 0.0 ? std::sqrt(held / pressed) : 0.0;
}

double PreloadForces::held(double time) const {
  return std::clamp((ends_ - time) / (ends_ - begins_), 0.0, 1.0);
}

void PreloadForces::add_to(ContactAssembler& assembler, double time) {
  if (entries_.empty()) return;
  const double share = held(time);
  if (share == 0.0) entries_.clear();
  for (const Entry& entry : entries_)
    assembler.add_node(entry.node, share * entry.force, share * entry.moment);
}

double PreloadForces::work(const ContactKinematics& kinematics, double time, double dt) const {
  if (entries_.empty()) return 0.0;
  const double share = 0.5 * (held(time - dt) + held(time));
  double power = 0.0;
  for (const Entry& entry : entries_) power += entry.force.dot(kinematics.v(entry.node));
  return share * power * dt;
}

void PreloadForces::archive(StateArchive& saved) {
  const char* name = "contact/preload_forces";
  if (saved.restores() ? !saved.has(name) : entries_.empty()) return;
  saved.rows(name, entries_,
             [](Entry& entry, RowNumbers& row) { row(entry.node, entry.force, entry.moment); });
  saved.numbers("contact/preload_times", begins_, ends_);
}

}  // namespace contactsim
