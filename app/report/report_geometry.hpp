// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/report/element_life.hpp"
#include "core/base/optional_index.hpp"
#include "core/definition/declarations.hpp"
#include "core/mesh/mesh.hpp"

namespace contactsim {

/// A face to draw; a triangle repeats its last point.
struct ReportFace {
  std::array<std::uint32_t, 4> points{};  ///< positions in ReportGeometry::nodes
  ElementIndex element;
  int side = 1;  ///< Exodus side number; 1 of a shell, which is drawn once
  std::uint32_t block = 0;
  std::uint32_t owner = 0;       ///< position in ReportGeometry::owners plus 1; 0: of no surface
  std::uint32_t claims = 0;      ///< position in ReportGeometry::lost
  std::uint32_t shown_from = 0;  ///< position of a stored time
  OptionalIndex<std::uint32_t> hidden_from = {};  ///< the same; none without deaths
};

/// A beam, truss or spring to draw, or a particle, whose two points are one.
struct ReportLine {
  std::array<std::uint32_t, 2> points{};
  ElementIndex element;
  std::uint32_t block = 0;
  std::uint32_t owner = 0;  ///< as of a face
};

/// The outside of a mesh, and who owns it.
struct ReportGeometry {
  std::vector<NodeIndex> nodes;   ///< of the mesh, that are drawn, in the order in which faces name them
  std::vector<ReportFace> faces;  ///< by element and side
  std::vector<ReportLine> lines, particles;  ///< by element
  std::vector<double> radii;  ///< [n_blocks] of lines and particles by their sections; 0: not known [length]
  std::vector<std::string> owners;  ///< names of surfaces, in deck order
  /// What was claimed in vain: lists of (loser, winner), positions in owners. The first is empty.
  std::vector<std::vector<std::pair<std::uint32_t, std::uint32_t>>> lost;
  bool knows_claims = false;  ///< the deck was there; else owners come from side sets alone
};

/// The region whose contact definition says who owns what.
struct ReportRegion {
  const SimulationDefinition& definition;
  const Region& region;
};

/// Finds the skin of all elements, shells and lines, the faces that contact owns inside, and those that
/// deaths expose.
///   region  absent: owners are the side sets contact_<surface> that results hold
ReportGeometry make_report_geometry(const Mesh& mesh, const std::optional<ReportRegion>& region,
                                    const ElementLife& life);

}  // namespace contactsim
