// SPDX-License-Identifier: BSD-3-Clause
// How far the rows of momentum balance give way under a force.
#include <algorithm>
#include <cmath>

#include "contact/enforcement/contact_constraints.hpp"

namespace contactsim {

/// Those of the rows that press first. One thread adds row by row, several carrier by carrier, each in the
/// order of the rows.
void ContactConstraints::add_areas(LeaningAreas& areas) {
  pressing_.add_areas(system_, areas);
  if (!has_others()) return;
  const int n_threads = system_.n_threads();
  if (n_threads == 1) {
    system_.visit_rows([&](const Group& group, std::uint32_t row) {
      if (group.presses) return;
      carriers_.add_areas(group.terms, system_.weights[row], direction(group, system_.rows[row]),
                          system_.rows[row].area, areas);
    });
    return;
  }
  row_areas_.resize(system_.rows.size());
  parallel_for(system_.rows.size(), n_threads, [&](std::size_t i) { row_areas_[i] = system_.rows[i].area; });
  parallel_for(pushes_.n_carriers(), n_threads, [&](std::size_t carrier) {
    std::array<double, 2>& sums = areas[carrier];
    for (const RowPush& push : pushes_.of(carrier)) {
      sums[0] += row_areas_[push.row] * std::abs(push.weight);
      if (!push.arm) continue;
      const Row& row = system_.rows[push.row];
      const NodeVector normal = node_vector(system_.point_of(row).normal);
      sums[1] += row.area * carriers_.turn_size(static_cast<std::uint32_t>(carrier), *push.arm,
                                                {normal, row.friction.has_value()});
    }
  });
}

void ContactConstraints::add_loads(const LeaningAreas& areas, std::vector<CarrierLoad>& loads) const {
  system_.visit_rows([&](const Group& group, std::uint32_t row) {
    carriers_.add_loads(group.terms, system_.weights[row], direction(group, system_.rows[row]),
                        system_.rows[row].area, areas, loads);
  });
}

double ContactConstraints::softness(const Group& group, std::uint32_t row, const LeaningAreas& areas,
                                    const LightCarriers& light, double least) const {
  const double area = system_.rows[row].area;
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
  return dt_ * slip / system_.rows[row].area;
}

void ContactConstraints::set_softness(const LeaningAreas& areas, const LightCarriers& light, double least) {
  bool has_rigid = pressing_.set_softness(areas, dt_, system_);
  const auto set = [&](const Group& group) {
    int n_rigid = 0;
    if (group.presses) return n_rigid;
    system_.visit_rows({&group, 1}, [&](const Group&, std::uint32_t i) {
      Row& row = system_.rows[i];
      row.softness = softness(group, i, areas, light, least);
      if (row.friction)
        system_.frictions[*row.friction].softness =
            light.empty() ? row.softness : slip_softness(group, i, areas);
      if (!(row.softness > 0.0)) ++n_rigid;
    });
    return n_rigid;
  };
  if (has_others())
    has_rigid = parallel_max(system_.groups.size(), system_.n_threads(), 0,
                             [&](std::size_t i) { return set(system_.groups[i]); }) > 0 ||
                has_rigid;
  if (!has_rigid) return;
  system_.remove_rigid_rows();
  list_pushes();
}

}  // namespace contactsim
