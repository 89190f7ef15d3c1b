// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/smoothing/smooth_face.hpp"
#include "core/base/contact_indices.hpp"
#include "core/base/indexed_vector.hpp"
#include "core/base/optional_index.hpp"

namespace contactsim {

/// The smoothed faces of a mesh, by smoothing. Empty where no pair is smoothed.
class SmoothFaces {
 public:
  SmoothFaces() = default;
  SmoothFaces(std::size_t n_smoothings, std::size_t n_faces)
      : positions_(n_smoothings, Positions(n_faces)), extents_(n_faces) {}

  void add(std::uint32_t smoothing, FaceIndex face, std::uint32_t shape, SmoothFace smooth) {
    extents_[face].height = std::max(extents_[face].height, static_cast<float>(smooth.height()));
    extents_[face].lean = std::max(extents_[face].lean, static_cast<float>(smooth.lean()));
    positions_[smoothing][face] = static_cast<std::uint32_t>(all_.size());
    all_.push_back(std::move(smooth));
    shapes_.push_back(shape);
  }
  /// Null of a face that stands for itself; always without a smoothing.
  const SmoothFace* find(OptionalIndex<std::uint32_t> smoothing, FaceIndex face) const {
    const OptionalIndex<std::uint32_t> position = position_of(smoothing, face);
    return position ? &all_[*position] : nullptr;
  }
  SmoothFace* find(OptionalIndex<std::uint32_t> smoothing, FaceIndex face) {
    return const_cast<SmoothFace*>(std::as_const(*this).find(smoothing, face));
  }
  /// Whether two faces of one surface are parts of one round surface.
  bool go_on(OptionalIndex<std::uint32_t> smoothing, FaceIndex face, FaceIndex other) const {
    const OptionalIndex<std::uint32_t> a = position_of(smoothing, face), b = position_of(smoothing, other);
    return a && b && shapes_[*a] == shapes_[*b];
  }
  std::size_t n_smoothings() const { return positions_.size(); }

  /// How far the round surfaces of all smoothings are from a face, and lean on it: see SmoothFace.
  struct Extent {
    float height = 0.0f, lean = 0.0f;
  };
  Extent extent(FaceIndex face) const { return extents_.empty() ? Extent{} : extents_[face]; }

 private:
  using Positions = IndexedVector<FaceIndex, OptionalIndex<std::uint32_t>>;
  OptionalIndex<std::uint32_t> position_of(OptionalIndex<std::uint32_t> smoothing, FaceIndex face) const {
    return smoothing ? positions_[*smoothing][face] : OptionalIndex<std::uint32_t>{};
  }

  std::vector<Positions> positions_;  // [n_smoothings] in the lists below
  IndexedVector<FaceIndex, Extent> extents_;
  std::vector<SmoothFace> all_;
  std::vector<std::uint32_t> shapes_;  // of its surface
};

}  // namespace contactsim
