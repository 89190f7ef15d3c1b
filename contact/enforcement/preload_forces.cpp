// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/preload_forces.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/base/state_archive.hpp"

namespace contactsim {

namespace {

using Entry = PreloadForces::Entry;
using Entries = PreloadForces::Entries;

/// The forces of all contact nodes.
Entries entries_of(const ContactAssembler& assembler) {
  Entries entries(assembler.nodes().size());
  const bool has_moments = !assembler.moments().empty();
  for (const ContactNodeIndex i : indices(entries)) {
    entries[i] = {i, assembler.nodes()[i].head<3>()};
    if (has_moments) entries[i].moment = assembler.moments()[i];
  }
  return entries;
}

double size_of(std::span<const Entry> entries) {
  double sum = 0.0;
  for (const Entry& entry : entries) sum += entry.force.squaredNorm();
  return std::sqrt(sum);
}

void erase_zeros(std::vector<Entry>& entries) {
  std::erase_if(entries,
                [](const Entry& entry) { return entry.force.isZero(0.0) && entry.moment.isZero(0.0); });
}

}  // namespace

void PreloadForces::take_over(const ContactAssembler& before, double ends) {
  before_ = entries_of(before);
  ends_ = ends;
}

double PreloadForces::find_lack(const ContactAssembler& assembler, Entries& lack) const {
  lack = entries_of(assembler);
  for (const ContactNodeIndex i : indices(lack)) {
    lack[i].force = before_[i].force - lack[i].force;
    lack[i].moment = before_[i].moment - lack[i].moment;
  }
  const double pressed = size_of(before_);
  return pressed > 0.0 ? size_of(lack) / pressed : 0.0;
}

void PreloadForces::begin(const ContactAssembler& now, double begins, bool settles) {
  begins_ = begins;
  Entries lack;
  share_of_before_ = find_lack(now, lack);
  erase_zeros(lack);
  entries_ = first_ = std::move(lack);
  n_settled_ = 1;
  if (!settles) end_settling();
}

void PreloadForces::settle(ContactAssembler& assembler) {
  constexpr int n_tried = 3, most = 12;  // steps before a judgement, and in all
  constexpr double at_rest = 0.995;      // what is lacking shrinks more slowly
  Entries lack;
  const double lacking = find_lack(assembler, lack);
  const bool shrinks = lacking < at_rest * last_lack_;
  last_lack_ = lacking;
  ++n_settled_;
  const bool is_over = n_settled_ > n_tried && !shrinks;
  if (!is_over) {
    Entries held(std::move(lack));
    for (const Entry& entry : held) assembler.add_node(entry.node, entry.force, entry.moment);
    for (const Entry& entry : entries_) {
      held[entry.node].force += entry.force;
      held[entry.node].moment += entry.moment;
    }
    entries_ = std::move(held);
    erase_zeros(entries_);
  } else if (n_settled_ == n_tried + 1) {
    entries_ = first_;  // what only grows is no rest: contact begins as it would without
  }
  const double pressed = size_of(before_);
  share_of_before_ = pressed > 0.0 ? size_of(entries_) / pressed : 0.0;
  if (is_over || n_settled_ > most) end_settling();
}

void PreloadForces::end_settling() {
  before_.clear();
  first_.clear();
}

void PreloadForces::clear() {
  entries_.clear();
  end_settling();
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
  const std::string name = "contact/preload_forces";
  if (saved.restores() ? !saved.has(name) : entries_.empty() && before_.empty()) return;
  const auto visit = [](Entry& entry, RowNumbers& row) { row(entry.node, entry.force, entry.moment); };
  saved.rows(name, entries_, visit);
  saved.rows(name + "_before", before_, visit);
  saved.rows(name + "_at_first", first_, visit);
  saved.numbers("contact/preload_times", begins_, ends_, last_lack_, n_settled_);
}

}  // namespace contactsim
