// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <span>
#include <utility>

#include "core/materials/law_kind.hpp"

namespace contactsim {

/// A law of any class, which does not change.
class MaterialLaw {
 public:
  /// Of blocks without a material: it keeps nothing, and must not be updated.
  MaterialLaw() = default;
  template <class Law>
  requires requires { Law::n_state; }
  MaterialLaw(Law law)
      : kind_(&law_kind<Law>), moduli_(law.moduli), law_(std::make_shared<const Law>(std::move(law))) {}

  const LawKind& kind() const { return *kind_; }
  const ElasticModuli& moduli() const { return moduli_; }
  /// The law if it is of the class, else null.
  template <class Law>
  const Law* get_if() const {
    return kind_ == &law_kind<Law> ? static_cast<const Law*>(law_.get()) : nullptr;
  }

  void start(std::span<Lanes> state) const {
    if (law_) kind_->start(law_.get(), state);
  }
  LaneModuli update(const StrainStep& step, SymmetricLanes& stress, std::span<Lanes> state) const {
    return kind_->update(law_.get(), step, stress, state);
  }
  void update_plane(const PlaneStep& step, PlaneLanes& stress, std::span<Lanes> state) const {
    kind_->update_plane(law_.get(), step, stress, state);
  }
  void update_fibre(const FibreStep& step, FibreLanes& stress, std::span<Lanes> state) const {
    kind_->update_fibre(law_.get(), step, stress, state);
  }
  /// Preconditions: the law has them, see kind().
  Lanes plane_thinning(std::span<const Lanes> state) const {
    return kind_->plane_thinning(law_.get(), state);
  }
  Lanes plane_stiffening(std::span<const Lanes> state) const {
    return kind_->plane_stiffening(law_.get(), state);
  }
  Lanes fibre_thinning(std::span<const Lanes> state) const {
    return kind_->fibre_thinning(law_.get(), state);
  }
  Lanes fibre_stiffening(std::span<const Lanes> state) const {
    return kind_->fibre_stiffening(law_.get(), state);
  }

 private:
  static constexpr LawKind nothing{};

  const LawKind* kind_ = &nothing;
  ElasticModuli moduli_;
  std::shared_ptr<const void> law_;
};

}  // namespace contactsim
