// SPDX-License-Identifier: BSD-3-Clause
// How far the rows of momentum balance give way under a force.
#include <algorithm>

#include "contact/enforcement/contact_constraints.hpp"

namespace contactsim {

void ContactConstraints::add_areas(LeaningAreas& areas) const {
  system_.visit_rows([&](const Group& group, std::uint32_t row) {
    carriers_.add_areas(group.terms, system_.weights[row], direction(group, system_.rows[row]),
                        system_.area_of(system_.rows[row]), areas);
  });
}

void ContactConstraints::add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const {
  system_.visit_rows([&](const Group& group, std::uint32_t row) {
    carriers_.add_loads(group.terms, system_.weights[row], direction(group, system_.rows[row]),
                        system_.area_of(system_.rows[row]), areas, loads);
  });
}

double ContactConstraints::softness(const Group& group, std::uint32_t row, const LeaningAreas& areas,
                                    const LightCarriers& light, double least) const {
  const double area = system_.area_of(system_.rows[row]);
  const Terms& terms = group.terms;
  const PointCarriers::Direction along = direction(group, system_.rows[row]);
  double gap = 0.0;
  bool has_light = false;
  for (std::size_t i = 0; i < terms.n_terms; ++i) {
    const bool is_light = light.is_light(terms.carriers[i]);
    has_light = has_light || is_light;
    if (!is_light) gap += carriers_.share(terms, system_.weights[row], i, along, areas);
  }
  if (has_light) gap = std::max(gap, least * area);
  return dt_ * gap / area;
}

/// Slip per tangential force, that of light carriers, too: what friction holds is not found with their
/// motion.
double ContactConstraints::slip_softness(const Group& group, std::uint32_t row,
                                         const LeaningAreas& areas) const {
  const PointCarriers::Direction along = direction(group, system_.rows[row]);
  double slip = 0.0;
  for (std::size_t i = 0; i < group.terms.n_terms; ++i)
    slip += carriers_.share(group.terms, system_.weights[row], i, along, areas);
  return dt_ * slip / system_.area_of(system_.rows[row]);
}

void ContactConstraints::set_softness(const LeaningAreas& areas, const LightCarriers& light, double least) {
  const auto set = [&](const Group& group) {
    system_.visit_rows({&group, 1}, [&](const Group&, std::uint32_t i) {
      Row& row = system_.rows[i];
      row.softness = softness(group, i, areas, light, least);
      if (row.friction)
        system_.frictions[*row.friction].softness =
            light.empty() ? row.softness : slip_softness(group, i, areas);
    });
  };
  parallel_for(system_.groups.size(), system_.n_threads(), [&](std::size_t i) { set(system_.groups[i]); });
  system_.remove_rigid_rows();
}

}  // namespace contactsim
