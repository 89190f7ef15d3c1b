// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <span>
#include <vector>

#include "contact/contact_record.hpp"
#include "contact/moving_surface.hpp"
#include "contact/surface_pairs.hpp"
#include "core/conditions/active_times.hpp"

namespace contactsim {

/// Rows of candidates that are worked on as one piece. Fixed, so that sums do not depend on the number of
/// threads.
inline constexpr std::size_t rows_per_chunk = 256;

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

  /// Says which pairs act now.
  ///   is_on  whether any does
  void activate(double time, bool is_on);
  std::span<const PairRule> rules() const { return rules_; }
  const PairRule& operator[](std::uint32_t pair) const { return rules_[pair]; }
  /// Position of the pair of two surfaces in either order; `none` if they do not meet.
  std::uint32_t find(std::uint32_t surface, std::uint32_t other) const {
    return table_[surface * n_surfaces_ + other];
  }
  bool has_friction() const;

 private:
  std::vector<PairRule> rules_;
  std::vector<std::uint32_t> table_;  // [n_surfaces x n_surfaces]
  std::size_t n_surfaces_ = 0;
};

/// Places that stick for good because they have touched under a GLUED MODEL.
class GluedPlaces {
 public:
  bool holds_faces(std::uint32_t first, std::uint32_t second) const { return holds(faces_, first, second); }
  bool holds_node(std::uint32_t row, std::uint32_t pair) const { return holds(nodes_, row, pair); }
  /// Return whether the place is new.
  bool add_faces(std::uint32_t first, std::uint32_t second) { return add(first, second, faces_); }
  bool add_node(std::uint32_t row, std::uint32_t pair) { return add(row, pair, nodes_); }

 private:
  static std::uint64_t key(std::uint32_t a, std::uint32_t b) { return (std::uint64_t{a} << 32) | b; }
  static bool holds(const std::set<std::uint64_t>& places, std::uint32_t a, std::uint32_t b) {
    return places.count(key(a, b)) > 0;
  }
  static bool add(std::uint32_t a, std::uint32_t b, std::set<std::uint64_t>& places) {
    return places.insert(key(a, b)).second;
  }

  std::set<std::uint64_t> faces_, nodes_;
};

/// A step of contact: what the loops over places look at.
struct ContactScene {
  const MovingSurface& surface;
  const PairRules& rules;
  const GluedPlaces& glued;
  double dt = 0.0;         ///< of the step that ended, 0 at the start [time]
  bool is_frozen = false;  ///< nothing is remembered: the step has been taken, someone only looks
};

}  // namespace contactsim
