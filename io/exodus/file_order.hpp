// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/mesh/mesh.hpp"

namespace contactsim {

/// The way between the order in which a mesh has its nodes, or the elements of a block, and that of files.
class FileOrder {
 public:
  FileOrder() = default;
  static FileOrder of_nodes(const Mesh& mesh);
  /// Positions are within the block.
  static FileOrder of_block(const Mesh& mesh, const ElementBlock& block);

  /// Whether files have the order of the mesh.
  bool is_same() const { return positions_.empty(); }
  std::size_t size() const { return n_; }
  /// Position in the mesh, or the block, of what a file has at a place.
  std::uint32_t position(std::uint32_t place) const { return is_same() ? place : positions_[place]; }

  /// Values in the order of files.
  ///   values  n_numbers of each item, in the order of the mesh
  ///   first   of these numbers, of which n_taken follow each other
  template <class T>
  std::vector<T> to_file(std::span<const T> values, std::size_t n_numbers, std::size_t first,
                         std::size_t n_taken) const {
    std::vector<T> taken;
    taken.reserve(n_ * n_taken);
    for (std::uint32_t place = 0; place < n_; ++place) {
      const T* from = values.data() + position(place) * n_numbers + first;
      taken.insert(taken.end(), from, from + n_taken);
    }
    return taken;
  }
  /// Values in the order of the mesh, one of each item.
  void to_mesh(std::span<double> values) const;

 private:
  template <class PlaceOf>
  FileOrder(std::uint32_t n, const PlaceOf& place_of);

  std::size_t n_ = 0;
  std::vector<std::uint32_t> positions_;  // by place
};

}  // namespace contactsim
