// SPDX-License-Identifier: BSD-3-Clause
// How far the rows of momentum balance give way under a force.
#include <algorithm>

#include "contact/enforcement/contact_constraints.hpp"

namespace contactsim {

void ContactConstraints::add_areas(LeaningAreas& areas) const {
  visit_rows([&](const Group& group, std::uint32_t row) {
    carriers_.add_areas(group.terms, weights_[row], direction(group, rows_[row]), area_of(rows_[row]), areas);
  });
}

void ContactConstraints::add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const {
  visit_rows([&](const Group& group, std::uint32_t row) {
    carriers_.add_loads(group.terms, weights_[row], direction(group, rows_[row]), area_of(rows_[row]), areas,
                        loads);
  });
}

double ContactConstraints::softness(const Group& group, std::uint32_t row, const LeaningAreas& areas,
                                    const LightCarriers& light, double least) const {
  const double area = area_of(rows_[row]);
  const Terms& terms = group.terms;
  const PointCarriers::Direction along = direction(group, rows_[row]);
  double gap = 0.0;
  bool has_light = false;
  for (std::size_t i = 0; i < terms.n_terms; ++i) {
    const bool is_light = light.is_light(terms.carriers[i]);
    has_light = has_light || is_light;
    if (!is_light) gap += carriers_.share(terms, weights_[row], i, along, areas);
  }
  if (has_light) gap = std::max(gap, least * area);
  return dt_ * gap / area;
}

/// Slip per tangential force, that of light carriers, too: what friction holds is not found with their
/// motion.
double ContactConstraints::slip_softness(const Group& group, std::uint32_t row,
                                         const LeaningAreas& areas) const {
  const PointCarriers::Direction along = direction(group, rows_[row]);
  double slip = 0.0;
  for (std::size_t i = 0; i < group.terms.n_terms; ++i)
    slip += carriers_.share(group.terms, weights_[row], i, along, areas);
  return dt_ * slip / area_of(rows_[row]);
}

void ContactConstraints::set_softness(const LeaningAreas& areas, const LightCarriers& light, double least) {
  const auto set = [&](const Group& group) {
    visit_rows({&group, 1}, [&](const Group&, std::uint32_t i) {
      Row& row = rows_[i];
      row.softness = softness(group, i, areas, light, least);
      if (row.grip)
        grips_[*row.grip].softness = light.empty() ? row.softness : slip_softness(group, i, areas);
    });
  };
  parallel_for(groups_.size(), threads(), [&](std::size_t i) { set(groups_[i]); });
  drop_held();
}

/// Takes off the points that have no softness.
void ContactConstraints::drop_held() {
  std::uint32_t n_kept = 0;
  for (Group& group : groups_) {
    const std::uint32_t first = group.first_row, end = first + group.n_rows;
    group.first_row = n_kept;
    for (std::uint32_t i = first; i < end; ++i) {
      if (!(rows_[i].softness > 0.0)) continue;
      rows_[n_kept] = rows_[i];
      weights_[n_kept++] = weights_[i];
    }
    group.n_rows = n_kept - group.first_row;
  }
  rows_.resize(n_kept);
  weights_.resize(n_kept);
  std::erase_if(groups_, [](const Group& group) { return group.n_rows == 0; });
}

}  // namespace contactsim
