// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/run_curves.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "contact/enforcement/contact_force.hpp"

namespace contactsim {

namespace {

constexpr std::size_t max_noted = 1000, max_pairs = 12;

struct EnergyRow {
  const char* name;
  double Energies::*member;
};

constexpr EnergyRow energy_rows[] = {{"kinetic", &Energies::kinetic},   {"internal", &Energies::internal},
                                     {"external", &Energies::external}, {"contact", &Energies::contact},
                                     {"friction", &Energies::friction}, {"hourglass", &Energies::hourglass},
                                     {"error", &Energies::error}};

template <class Values>
void keep_every_second(Values& values) {
  for (std::size_t i = 0; 2 * i < values.size(); ++i) values[i] = values[2 * i];
  values.resize((values.size() + 1) / 2);
}

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::ranges::max_element(values);
}

}  // namespace

void RunCurves::look(RunEvent event, const Simulation& run) {
  if (event == RunEvent::begun) last_step_ = std::nullopt;  // procedures count their own
  const std::int64_t step = run.state().step;
  const bool is_due = event == RunEvent::step && step % stride_ == 0;
  const bool is_last = event == RunEvent::ended && !run.failure();
  const bool is_new = !last_step_ || step > *last_step_;
  if ((is_due || is_last) && is_new) note(run);
}

void RunCurves::note(const Simulation& run) {
  const State& state = run.state();
  last_step_ = state.step;
  // Before, not behind: the last step of a run is to stay.
  if (times_.size() >= max_noted) thin_out();
  energies_.resize(std::size(energy_rows));
  times_.push_back(state.time);
  for (std::size_t i = 0; i < energies_.size(); ++i)
    energies_[i].push_back(state.energies.*energy_rows[i].member);
  if (run.contact_force() != nullptr) note_pairs(run);
  for (auto& [key, pair] : pairs_) {  // those that do not touch, too
    pair.force.resize(times_.size(), 0.0);
    pair.penetration.resize(times_.size(), 0.0);
  }
}

void RunCurves::note_pairs(const Simulation& run) {
  const auto steps = run.contact_force()->pair_steps();
  const ContactModel& model = *run.contact_model();
  for (const PairIndex i : indices(model.pairs)) {
    if (!steps[i].touches) continue;
    const SurfacePair& of = model.pairs[i];
    PairCurve& pair = pairs_[{i.value, fmt::format("{} – {}", model.surfaces.surfaces[of.first].name,
                                                   model.surfaces.surfaces[of.second].name)}];
    pair.force.resize(times_.size(), 0.0);
    pair.penetration.resize(times_.size(), 0.0);
    pair.force.back() = steps[i].force.norm();
    pair.penetration.back() = steps[i].penetration;
  }
}

void RunCurves::thin_out() {
  stride_ *= 2;
  keep_every_second(times_);
  for (auto& energy : energies_) keep_every_second(energy);
  for (auto& [key, pair] : pairs_) {
    keep_every_second(pair.force);
    keep_every_second(pair.penetration);
  }
}

CurveChart RunCurves::pair_chart(const char* title, const char* dimension,
                                 std::vector<double> PairCurve::*values) const {
  std::vector<const std::pair<const PairKey, PairCurve>*> largest;
  for (const auto& pair : pairs_) largest.push_back(&pair);
  std::ranges::stable_sort(largest, std::greater{},
                           [&](const auto* pair) { return largest_of(pair->second.*values); });
  if (largest.size() > max_pairs) largest.resize(max_pairs);
  CurveChart chart{title, "", dimension, times_, {}};
  for (const auto* pair : largest) chart.curves.push_back({pair->first.second, pair->second.*values});
  return chart;
}

std::vector<CurveChart> RunCurves::charts() const {
  if (times_.empty()) return {};
  CurveChart energies{"Energies", "", "energy", times_, {}};
  for (std::size_t i = 0; i < energies_.size(); ++i) {
    const bool is_zero = std::ranges::all_of(energies_[i], [](double value) { return value == 0.0; });
    if (!is_zero) energies.curves.push_back({energy_rows[i].name, energies_[i]});
  }
  std::vector<CurveChart> charts{std::move(energies)};
  if (pairs_.empty()) return charts;
  charts.push_back(pair_chart("Contact force of pairs", "force", &PairCurve::force));
  charts.push_back(pair_chart("Deepest penetration of pairs", "length", &PairCurve::penetration));
  return charts;
}

}  // namespace contactsim
