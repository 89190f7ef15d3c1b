// SPDX-License-Identifier: BSD-3-Clause
#include "contact/enforcement/pressing_rows.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "core/base/fours.hpp"

namespace contactsim {

namespace {

/// Eight numbers that follow each other.
Lanes load(const double* numbers) {
  Lanes lanes;
  std::memcpy(lanes.data(), numbers, n_lanes * sizeof(double));
  return lanes;
}
void store(const Lanes& lanes, double* numbers) {
  std::memcpy(numbers, lanes.data(), n_lanes * sizeof(double));
}

Lanes lanes_of(const PointCarriers::Weights& weights) {
  static_assert(PointCarriers::max_terms == n_lanes);
  return load(weights.data());
}

/// The components along the normal of a group of vectors of its carriers.
///   vectors  [n_carriers]
template <class Group>
Lanes along_normal(const Group& group, std::span<const NodeVector> vectors) {
  const auto [x, y, z] = to_lanes([&](std::size_t term) { return vectors[group.carriers[term]].data(); });
  return group.normal[0] * x + group.normal[1] * y + group.normal[2] * z;
}

/// The areas of the points of a group by its carriers.
template <class Group>
Lanes areas_of(const ConstraintSystem& system, const Group& group) {
  Lanes areas = Lanes::Zero();
  for (std::uint32_t row = group.first_row; row < group.end_row(); ++row)
    areas += system.rows[row].area * lanes_of(system.weights[row]).abs();
  return areas;
}

/// One of them.
template <class Group>
double area_of(const ConstraintSystem& system, const Group& group, std::size_t term) {
  double area = 0.0;
  for (std::uint32_t row = group.first_row; row < group.end_row(); ++row)
    area += system.rows[row].area * std::abs(system.weights[row][term]);
  return area;
}

}  // namespace

void PressingRows::list(const ConstraintSystem& system) {
  groups_.clear();
  for (const ConstraintGroup& group : system.groups) {
    if (!group.presses) continue;
    Group& listed = groups_.emplace_back();
    listed.carriers = group.terms.carriers;
    listed.normal = group.normal;
    listed.first_row = group.first_row;
    listed.n_rows = group.n_rows;
    listed.n_terms = group.terms.n_terms;
  }
  const int n_threads = system.n_threads();
  if (n_threads == 1) return;
  const auto visit = [this](std::size_t begin, std::size_t end, const auto& take) {
    for (auto g = static_cast<std::uint32_t>(begin); g < end; ++g) {
      for (std::uint32_t i = 0; i < groups_[g].n_terms; ++i) take(groups_[g].carriers[i], GroupPush{g, i});
    }
  };
  pushes_.make(mobility_.n_carriers(), groups_.size(), n_threads, visit);
}

/// One thread adds group by group, several carrier by carrier, each in the order of the groups.
void PressingRows::add_areas(const ConstraintSystem& system, LeaningAreas& areas) const {
  const int n_threads = system.n_threads();
  if (n_threads == 1) {
    for (const Group& group : groups_) {
      const Lanes of_group = areas_of(system, group);
      for (std::uint32_t i = 0; i < group.n_terms; ++i)
        areas[group.carriers[i]][0] += of_group(static_cast<int>(i));
    }
    return;
  }
  parallel_for(pushes_.n_carriers(), n_threads, [&](std::size_t carrier) {
    for (const GroupPush& push : pushes_.of(carrier))
      areas[carrier][0] += area_of(system, groups_[push.group], push.term);
  });
}

bool PressingRows::set_softness(const LeaningAreas& areas, double dt, ConstraintSystem& system) {
  const int n_threads = system.n_threads();
  carrier_softness_.resize(mobility_.n_carriers());
  parallel_for(carrier_softness_.size(), n_threads, [&](std::size_t i) {
    carrier_softness_[i] = mobility_.translation_bound(static_cast<std::uint32_t>(i)) * areas[i][0];
  });
  const int most_rigid = parallel_max(groups_.size(), n_threads, 0, [&](std::size_t g) {
    const Group& group = groups_[g];
    Lanes of_carriers = Lanes::Zero();
    for (std::uint32_t i = 0; i < group.n_terms; ++i)
      of_carriers(static_cast<int>(i)) = carrier_softness_[group.carriers[i]];
    int n_rigid = 0;
    for (std::uint32_t i = group.first_row; i < group.end_row(); ++i) {
      ConstraintRow& row = system.rows[i];
      row.softness = dt * (lanes_of(system.weights[i]).abs() * of_carriers).sum() / row.area;
      if (!(row.softness > 0.0)) ++n_rigid;
    }
    return n_rigid;
  });
  return most_rigid > 0;
}

void PressingRows::Rows::resize(std::size_t n, bool are_all_pressing) {
  for (std::vector<double>* numbers : {&start, &softness, &rate, &least, &force, &ahead, &opening}) {
    if (!are_all_pressing) numbers->clear();
    numbers->resize(n, 0.0);
  }
}

void PressingRows::begin_passes(const ConstraintSystem& system) {
  rows_.resize(system.rows.size(), groups_.size() == system.groups.size());
  parallel_for(groups_.size(), system.n_threads(), [&](std::size_t g) {
    const Group& group = groups_[g];
    for (std::uint32_t i = group.first_row; i < group.end_row(); ++i) {
      const ConstraintRow& row = system.rows[i];
      rows_.start[i] = row.start;
      rows_.softness[i] = row.softness;
      rows_.rate[i] = (1.0 - constraint_compliance) / row.softness;
      rows_.least[i] = row.pulls ? -std::numeric_limits<double>::infinity() : 0.0;
      rows_.force[i] = rows_.ahead[i] = row.force.dot(NodeVector(group.normal));
    }
  });
}

/// The sums of visit(first group, end, sums) over chunks of groups: the same bits for any number of threads.
template <class Sums, class Visit>
Sums PressingRows::sum_chunks(int n_threads, const Visit& visit) const {
  constexpr std::size_t groups_a_chunk = ConstraintSystem::groups_per_chunk;
  std::vector<Sums> parts((groups_.size() + groups_a_chunk - 1) / groups_a_chunk);
  parallel_for(parts.size(), n_threads, [&](std::size_t chunk) {
    visit(chunk * groups_a_chunk, std::min((chunk + 1) * groups_a_chunk, groups_.size()), parts[chunk]);
  });
  Sums all;
  for (const Sums& part : parts) all += part;
  return all;
}

/// Has find_forces(first group, end, sums) find what rows push with, chunk by chunk, and pushes the carriers.
/// One thread pushes group by group, several carrier by carrier: each carrier's pushes come in the same
/// order.
template <class FindForces>
ConstraintPass PressingRows::push_groups(const ConstraintSystem& system, const FindForces& find_forces) {
  const int n_threads = system.n_threads();
  const std::span<NodeVector> pressed = mobility_.pressed();
  const auto forces_of = [&](const Group& group) {
    Lanes forces = Lanes::Zero();
    for (std::uint32_t i = group.first_row; i < group.end_row(); ++i)
      forces += rows_.ahead[i] * lanes_of(system.weights[i]);
    return forces;
  };
  if (n_threads == 1) {
    return sum_chunks<ConstraintPass>(1, [&](std::size_t begin, std::size_t end, ConstraintPass& sums) {
      find_forces(begin, end, sums);
      for (std::size_t g = begin; g < end; ++g) {
        const Group& group = groups_[g];
        const Lanes forces = forces_of(group);
        const NodeVector normal = group.normal;
        for (std::uint32_t i = 0; i < group.n_terms; ++i)
          pressed[group.carriers[i]] += forces(static_cast<int>(i)) * normal;
      }
    });
  }
  group_forces_.resize(groups_.size());
  const auto sums = sum_chunks<ConstraintPass>(
      n_threads, [&](std::size_t begin, std::size_t end, ConstraintPass& of_chunk) {
        find_forces(begin, end, of_chunk);
        for (std::size_t g = begin; g < end; ++g) group_forces_[g] = forces_of(groups_[g]);
      });
  parallel_for(pushes_.n_carriers(), n_threads, [&](std::size_t carrier) {
    NodeVector sum = pressed[carrier];
    for (const GroupPush& push : pushes_.of(carrier))
      sum += group_forces_[push.group](static_cast<int>(push.term)) * NodeVector(groups_[push.group].normal);
    pressed[carrier] = sum;
  });
  return sums;
}

void PressingRows::push_forces(const ConstraintSystem& system) {
  push_groups(system, [&](std::size_t begin, std::size_t end, ConstraintPass&) {
    const auto first = rows_.force.begin();
    std::copy(first + groups_[begin].first_row, first + groups_[end - 1].end_row(),
              rows_.ahead.begin() + groups_[begin].first_row);
  });
}

/// The next forces of rows: those that would close their gaps, as ForceProjection, eight at a time.
void PressingRows::find_forces(std::uint32_t begin, std::uint32_t end, double dt, double momentum,
                               ConstraintPass& sums) {
  struct LaneSums {
    Lanes changed = Lanes::Zero(), all = Lanes::Zero(), uphill = Lanes::Zero();
  } of_lanes;
  const auto unlimited = [dt](const auto& start, const auto& opening, const auto& softness, const auto& rate,
                              const auto& ahead) {
    return ahead - rate * (start + dt * opening + constraint_compliance * softness * ahead);
  };
  std::uint32_t i = begin;
  for (; i + n_lanes <= end; i += n_lanes) {
    const Lanes softness = load(&rows_.softness[i]), before = load(&rows_.force[i]),
                ahead = load(&rows_.ahead[i]);
    const Lanes force =
        unlimited(load(&rows_.start[i]), load(&rows_.opening[i]), softness, load(&rows_.rate[i]), ahead)
            .max(load(&rows_.least[i]));
    const Lanes step = force - before, over = ahead - force;
    of_lanes.changed += over.abs();
    of_lanes.all += force.abs();
    of_lanes.uphill += softness * over * step;
    store(force, &rows_.force[i]);
    store(force + momentum * step, &rows_.ahead[i]);
  }
  sums += {of_lanes.changed.sum(), of_lanes.all.sum(), of_lanes.uphill.sum()};
  for (; i < end; ++i) {
    const double force = std::max(
        unlimited(rows_.start[i], rows_.opening[i], rows_.softness[i], rows_.rate[i], rows_.ahead[i]),
        rows_.least[i]);
    const double step = force - rows_.force[i], over = rows_.ahead[i] - force;
    sums += {std::abs(over), std::abs(force), rows_.softness[i] * over * step};
    rows_.force[i] = force;
    rows_.ahead[i] = force + momentum * step;
  }
}

ConstraintPass PressingRows::pass(const ConstraintSystem& system, double dt, double momentum) {
  return push_groups(system, [&](std::size_t begin, std::size_t end, ConstraintPass& sums) {
    const std::span<const NodeVector> changes = mobility_.changes();
    for (std::size_t g = begin; g < end; ++g) {
      const Lanes openings = along_normal(groups_[g], changes);
      for (std::uint32_t i = groups_[g].first_row; i < groups_[g].end_row(); ++i)
        rows_.opening[i] = (lanes_of(system.weights[i]) * openings).sum();
    }
    find_forces(groups_[begin].first_row, groups_[end - 1].end_row(), dt, momentum, sums);
  });
}

ContactLoss PressingRows::finish(ConstraintSystem& system, const ConstraintLosses& losses,
                                 std::span<ContactHistory::KnownPoint> known) {
  const int n_threads = system.n_threads();
  last_velocities_.resize(mobility_.n_carriers());
  parallel_for(last_velocities_.size(), n_threads, [this](std::size_t i) {
    const auto carrier = static_cast<std::uint32_t>(i);
    last_velocities_[i] =
        mobility_.is_body(carrier) ? NodeVector(NodeVector::Zero()) : mobility_.last_velocity(carrier);
  });
  return sum_chunks<ContactLoss>(n_threads, [&](std::size_t begin, std::size_t end, ContactLoss& sums) {
    for (std::size_t g = begin; g < end; ++g) {
      const Group& group = groups_[g];
      const Lanes opening = losses.dt * along_normal(group, mobility_.changes()),
                  opened =
                      losses.dt_before * along_normal(group, std::span<const NodeVector>(last_velocities_));
      for (std::uint32_t i = group.first_row; i < group.end_row(); ++i) {
        const Lanes weights = lanes_of(system.weights[i]);
        const double force = rows_.force[i];
        known[i] = {system.ids[i], losses.finish_pressing(system.rows[i], force, (weights * opened).sum(),
                                                          (weights * opening).sum(), sums)};
      }
    }
  });
}

}  // namespace contactsim
