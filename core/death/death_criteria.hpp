// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/definition/death.hpp"
#include "core/output/variable_selection.hpp"

namespace contactsim {

/// The element that is farthest beyond what its material withstands.
struct WorstElement {
  std::optional<ElementIndex> element;  ///< absent where none has failed
  double value = 0.0;                   ///< of what the law fails by, the mean of its points [1]
};

/// What the criteria of one ELEMENT DEATH block say. Any one of several kills.
/// Source: Sierra/SM 5.20, element death.
class DeathCriteria {
 public:
  /// A variable that is not known is an error, and so is one that no element of the set has. MATERIAL
  /// CRITERION is a test of what the laws of the set's blocks fail by; none that fails is an error. All must
  /// outlive it.
  ///   elements  of the set, ascending
  DeathCriteria(const ElementDeath& death, std::span<const ElementIndex> elements,
                const OutputVariables& variables, Diagnostics& diagnostics);

  /// From now on these elements alone are looked at.
  ///   elements  some of the set, ascending; must outlive it
  void look_at(std::span<const ElementIndex> elements);
  /// Whether a criterion is of a global value, which may be of any node or element.
  bool reads_all() const;

  /// Marks the elements of the set that meet a criterion. Of element values the mean over the integration
  /// points counts, unless the deck says how many points have to remain. Any component of a variable will do.
  ///   marks  [n_elements]
  void mark(const OutputContext& context, std::vector<std::uint8_t>& marks) const;
  /// The same, but MATERIAL CRITERION marks none: the one of the largest value, the first of equal ones, is
  /// taken if it is worse than the worst so far. Source: Sierra/SM 5.26, 4.7.
  ///   may_die  [n_elements] 0 of those that are dead or dying
  void mark_worst(const OutputContext& context, std::span<const std::uint8_t> may_die,
                  std::vector<std::uint8_t>& marks, WorstElement& worst) const;

 private:
  struct Criterion {
    DeathCriterion definition;
    bool is_of_material = false;      ///< in the place of MATERIAL CRITERION
    VariableSelection selection;      ///< none of ALWAYS TRUE
    std::vector<EntityRange> ranges;  ///< of element values: the parts of the set that have the variable
  };

  std::vector<Criterion> without_material(const ElementDeath& death, Diagnostics& diagnostics) const;
  void mark_by(const Criterion& criterion, const OutputContext& context,
               std::vector<std::uint8_t>& marks) const;
  std::vector<EntityRange> ranges_of(const VariableSelection& selection) const;
  void mark_all(std::vector<std::uint8_t>& marks) const;
  void mark_by_nodes(const Criterion& criterion, const NodalCriterion& nodal, const OutputContext& context,
                     std::vector<std::uint8_t>& marks) const;
  void mark_by_elements(const Criterion& criterion, const ElementCriterion& element,
                        const OutputContext& context, std::vector<std::uint8_t>& marks) const;

  std::span<const ElementIndex> elements_;
  const Model& model_;
  std::vector<Criterion> criteria_;
};

}  // namespace contactsim
