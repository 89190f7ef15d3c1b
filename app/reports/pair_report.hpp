// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <span>
#include <string>
#include <vector>

#include "app/reports/text_table.hpp"
#include "contact/enforcement/pair_history.hpp"
#include "contact/mesh/contact_model.hpp"
#include "contact/output/surface_summary.hpp"
#include "contact/overlap/automatic_lengths.hpp"
#include "contact/overlap/initial_gaps.hpp"

/// What the log says of pairs of surfaces. Stable in order and width, without times of the clock, so that the
/// tables of two runs can be compared with diff.
namespace contactsim {

/// An empty table of pairs: number and surfaces, with which its parts begin, then further columns.
TextTable pair_table(std::vector<TextTable::Column> columns);

/// The pair table before a run: surfaces, interaction, law, formulation, faces and nodes of both sides, how
/// near they are; then the resolved settings of every interaction. Pairs of general or self contact without
/// anything in reach are only counted, and so is what goes beyond a thousand rows. "" without pairs.
///   starts     [n_pairs] of model.pairs, or empty when they are not known: "-" stands in their place
///   lengths    that stand beside "auto", or empty
std::string format_pairs(const ContactModel& model, const SurfaceSummaries& summaries,
                         IndexedSpan<PairIndex, const InitialGap> starts,
                         IndexedSpan<PairIndex, const AutomaticLengths> lengths = {});

/// The pair table after a run, and the pairs that never touched. "" without pairs.
///   histories  [n_pairs] of model.pairs
std::string format_pair_histories(const ContactModel& model,
                                  IndexedSpan<PairIndex, const PairHistory> histories);

}  // namespace contactsim
