// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>

#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_summary.hpp"

namespace contactsim {

/// The ownership table of the log: one row per surface and a total, then who lost what to whom, then the
/// warnings. Holds no times, paths or thread counts, so that the tables of two runs can be compared with
/// diff.
std::string format_surface_tables(const ContactModel& model, const SurfaceSummaries& summaries);

/// A line under the tables for the blocks that SKIN ALL BLOCKS passes over; "" without any.
std::string format_passed_over(const ContactModel& model, const Mesh& mesh);

/// The same and the pairs as JSON, schema contactsim-surfaces/1.
std::string format_surfaces_json(const ContactModel& model, const SurfaceSummaries& summaries);

/// One line per owned facet: surface,block,element,side,kind,area. Names that hold a comma, a quote or a line
/// end are quoted.
std::string format_surfaces_csv(const ContactModel& model, std::span<const FacetRow> rows);

}  // namespace contactsim
