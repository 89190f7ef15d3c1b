// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "contact/mesh/contact_model.hpp"
#include "contact/overlap/overlap_detection.hpp"
#include "contact/overlap/overlap_parts.hpp"
#include "contact/overlap/overlap_search.hpp"
#include "contact/overlap/shifted_points.hpp"
#include "support/contact_bodies.hpp"
#include "support/contact_deck.hpp"

namespace contactsim::test {

/// Bodies that may lie in each other, and the parts of overlap removal that look at them.
struct OverlappingBodies {
  Mesh mesh;
  ContactDefinition definition;
  Modelled model;
  OverlapParts parts;
  ShiftedPoints points;
  OverlapSearch search;

  OverlappingBodies(const MeshBuilder& builder, const Region& region)
      : mesh(builder.build()),
        definition(*region.contact),
        model(make_model(mesh, region)),
        parts(make_overlap_parts(model, definition, mesh)),
        points(parts.contact_mesh, mesh),
        search(model, definition, mesh, parts) {}
  explicit OverlappingBodies(const MeshBuilder& builder, const std::string& contact_lines = general_contact())
      : OverlappingBodies(builder, region_of(contact_lines)) {}

  /// The overlaps of a pair in the order in which they are found, once what is near is searched.
  std::vector<Overlap> overlaps(PairIndex pair = {0}, double tolerance = 0.0) {
    search.find(points.renewed());
    std::vector<Overlap> found;
    OverlapDetection(model, parts, search, points, tolerance).visit_all(pair, [&](const Overlap& overlap) {
      found.push_back(overlap);
    });
    return found;
  }
  /// Two unit cubes of one element; the second is lowered into the top of the first, beside its middle.
  static MeshBuilder cubes(double depth, double aside = 0.25) {
    MeshBuilder b;
    b.add_hexes({.id = 1});
    b.add_hexes(
        {.id = 2, .origin = {aside, aside, 1.0 - depth}, .size = {0.5, 0.5, 1}, .share_nodes = false});
    return b;
  }

 private:
  static Region region_of(const std::string& contact_lines) {
    Region region;
    region.contact = parse_contact(contact_lines);
    return region;
  }
};

}  // namespace contactsim::test
