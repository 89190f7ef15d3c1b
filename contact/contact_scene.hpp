// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "contact/contact_record.hpp"
#include "contact/moving_surface.hpp"
#include "contact/surface_pairs.hpp"
#include "core/conditions/active_times.hpp"

namespace contactsim {

/// How the sides of a pair hold each other, as far as the loops over places need to know.
enum class ContactLaw : std::uint8_t { sliding, glued, tied };

/// A pair of surfaces, ready for the loops.
struct PairRule {
  const SurfacePair* pair = nullptr;
  ContactLaw law = ContactLaw::sliding;
  double friction = 0.0;  ///< Coulomb's coefficient [1]
  ActiveTimes times;
  bool is_active = true;  ///< now
};

/// The pairs of a run by the surfaces that they are of.
class PairRules {
 public:
  static constexpr std::uint32_t none = 0xffffffff;

  PairRules() = default;
  /// The pairs must outlive this.
  ///   times  [n_pairs] at which each is active
  PairRules(std::span<const SurfacePair> pairs, std::vector<ActiveTimes> times, std::size_t n_surfaces);

  void activate(double time);
  std::span<const PairRule> rules() const { return rules_; }
  const PairRule& operator[](std::uint32_t pair) const { return rules_[pair]; }
  /// Position of the pair of two surfaces in either order; `none` if they do not meet.
  std::uint32_t find(std::uint32_t surface, std::uint32_t other) const { return table_[surface * n_surfaces_ + other]; }
  bool has_friction() const;

 private:
  std::vector<PairRule> rules_;
  std::vector<std::uint32_t> table_;  // [n_surfaces x n_surfaces]
  std::size_t n_surfaces_ = 0;
};

/// A step of contact: what the loops over places look at.
struct ContactScene {
  const MovingSurface& surface;
  const PairRules& rules;
  double dt = 0.0;         ///< of the step that ended, 0 at the start [time]
  bool is_frozen = false;  ///< nothing is remembered: the step has been taken, someone only looks
};

}  // namespace contactsim
