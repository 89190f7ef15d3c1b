// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/report/curves.hpp"
#include "app/report/report_fields.hpp"
#include "app/report/report_geometry.hpp"
#include "core/base/deck_location.hpp"
#include "core/base/diagnostics.hpp"

namespace contactsim {

/// A mesh to draw and what is stored about it.
struct ReportMesh {
  Mesh mesh;
  StoredVariables stored;
  ReportGeometry geometry;
  ReportFields fields;  ///< refers to `stored`
};

/// Makes it from a mesh that was read from `path`, results or none. Throws FileError, and DeckError when the
/// region's names are not those of the mesh.
std::unique_ptr<const ReportMesh> make_report_mesh(const std::string& path, Mesh mesh,
                                                   const std::optional<ReportRegion>& region);

/// What a definition calls itself: its title, else the words after BEGIN SIERRA.
std::string title_of(const SimulationDefinition& definition);

/// A run as a report shows it.
struct ReportRun {
  std::string name;              ///< of the results file, else of the deck
  std::string title;             ///< the deck's, or ""
  std::vector<SourceFile> deck;  ///< and its includes
  bool is_deck_expanded =
      false;  ///< the text is what Aprepro made of the deck: lines are not those of the file
  bool has_surface_lines = false;  ///< the lines of `surfaces` are those of the first text
  std::string summary;             ///< of format_summary, or ""
  std::string surfaces;            ///< of format_surfaces_json, or ""
  Diagnostics found;               ///< what the summary has too, with every place
  std::vector<CurveChart> charts;
  std::vector<std::string> notes;          ///< what is not shown and why, sentences
  std::unique_ptr<const ReportMesh> mesh;  ///< null: there is none to draw
};

}  // namespace contactsim
