// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "app/report/packed_numbers.hpp"
#include "app/report/report_fields.hpp"
#include "app/report/report_geometry.hpp"

namespace contactsim {

/// A field at the chosen times; code 0 stands for no value, code c for code c - 1 of the scale.
struct PackedField {
  std::string name;
  bool is_nodal = true;  ///< [n points] of the geometry, else [n faces]
  Quantiser scale{0.0, 0.0, 1.0};
  double lowest = 0.0, highest = 0.0;
  std::string numbers;  ///< of pack_numbers
};

/// What moves, packed for a page.
struct PackedFrames {
  std::vector<std::size_t> chosen;  ///< positions of stored times
  double displacement_step = 0.0;   ///< of its codes, 0 without any [length]
  std::string displacement;         ///< of pack_numbers: x of all points, then y, z, time by time
  std::vector<PackedField> fields;

  std::size_t bytes() const;
};

/// What frames are made from.
struct FrameInput {
  const Mesh& mesh;
  const ReportGeometry& geometry;
  const ReportFields& fields;
  std::size_t n_times = 0;
};

/// Packs as many stored times, evenly chosen, first and last always, as fit into a number of bytes; two at
/// least. Displacements are right within a 16384th of the size of the model, or 2048th of the largest of them
/// if that is less: what a screen does not show. Fields have 4096 values, of more than 20000 faces 256, in
/// equal steps unless a few values pass all others by far. Throws FileError.
PackedFrames pack_frames(const FrameInput& input, std::size_t max_bytes);

}  // namespace contactsim
