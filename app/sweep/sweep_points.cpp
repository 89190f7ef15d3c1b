// SPDX-License-Identifier: BSD-3-Clause
#include "app/sweep/sweep_points.hpp"

#include <fmt/format.h>

#include <cctype>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <random>
#include <set>

#include "app/reports/csv.hpp"
#include "core/base/digest.hpp"
#include "core/base/errors.hpp"
#include "core/base/pluralize.hpp"

namespace contactsim {

namespace {

std::vector<SweepPoint> read_points(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw FileError(path, "the points cannot be read");
  const std::vector<CsvLine> lines = split_csv(std::string{std::istreambuf_iterator<char>(file), {}});
  if (lines.size() < 2)
    throw FileError(path, "there are no points: a line of names, then one for each point");
  const std::vector<std::string>& names = lines[0].fields;
  std::vector<SweepPoint> points;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    const auto& [number, fields] = lines[i];
    if (fields.size() != names.size())
      throw FileError(path, fmt::format("line {}: {} for {}", number, pluralize(fields.size(), "value"),
                                        pluralize(names.size(), "name")));
    SweepPoint& point = points.emplace_back();
    for (std::size_t j = 0; j < names.size(); ++j) point.emplace_back(names[j], fields[j]);
  }
  return points;
}

/// Every name stands once.
void check_names(const SweepPlan& plan, const std::vector<SweepPoint>& points) {
  std::set<std::string> names;
  const auto add = [&](const std::string& name) {
    if (name.empty()) refuse_sweep("a parameter has no name");
    if (!names.insert(name).second) refuse_sweep(fmt::format("the parameter '{}' is given twice", name));
  };
  for (const auto& [name, value] : points[0]) add(name);
  for (const SweepParameter& parameter : plan.parameters) add(parameter.name);
}

double count_runs(const SweepPlan& plan, std::size_t n_points) {
  double n = static_cast<double>(n_points);
  if (plan.n_samples) return n * static_cast<double>(*plan.n_samples);
  for (const SweepParameter& parameter : plan.parameters) {
    if (parameter.range && parameter.range->step == 0.0)
      refuse_sweep(
          fmt::format("the range of '{}' has no step: first:last:step, or --latin N", parameter.name));
    n *= parameter.n_values();
  }
  return n;
}

std::vector<SweepPoint> combine(const std::vector<SweepParameter>& parameters) {
  std::vector<SweepPoint> points{{}};
  for (const SweepParameter& parameter : parameters) {
    std::vector<SweepPoint> longer;
    const auto n = static_cast<std::size_t>(parameter.n_values());
    for (const SweepPoint& point : points) {
      for (std::size_t i = 0; i < n; ++i) {
        longer.push_back(point);
        longer.back().emplace_back(parameter.name, parameter.value(i));
      }
    }
    points = std::move(longer);
  }
  return points;
}

/// Random numbers that are the same with every C++ library; its distributions are not.
class Samples {
 public:
  explicit Samples(std::uint64_t seed) : random_(seed) {}
  /// In [0, 1).
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  /// The numbers below n, shuffled.
  std::vector<std::size_t> permutation(std::size_t n) {
    std::vector<std::size_t> order(n);
    for (std::size_t i = 0; i < n; ++i) {
      const auto j = static_cast<std::size_t>(uniform() * static_cast<double>(i + 1));
      order[i] = order[j];
      order[j] = i;
    }
    return order;
  }

 private:
  std::mt19937_64 random_;
};

/// A sample in each of n equal parts of every range. Source: McKay, Beckman & Conover, Technometrics 21
/// (1979) 239-245.
std::vector<SweepPoint> sample(const SweepPlan& plan) {
  const std::size_t n = *plan.n_samples;
  Samples samples(plan.seed);
  std::vector<SweepPoint> points(n);
  for (const SweepParameter& parameter : plan.parameters) {
    const std::vector<std::size_t> part = samples.permutation(n);
    for (std::size_t i = 0; i < n; ++i) {
      const double share = (static_cast<double>(part[i]) + samples.uniform()) / static_cast<double>(n);
      constexpr double rounding = 1e6;  // digits that a person can read
      std::string value;
      if (const auto& range = parameter.range) {
        const double at =
            range->first + std::round(share * rounding) / rounding * (range->last - range->first);
        value = format_parameter(at);
      } else {
        value =
            parameter.values[static_cast<std::size_t>(share * static_cast<double>(parameter.values.size()))];
      }
      points[i].emplace_back(parameter.name, std::move(value));
    }
  }
  return points;
}

}  // namespace

std::string describe_point(const SweepPoint& point) {
  std::string text;
  for (const auto& [name, value] : point) text += (text.empty() ? "" : " ") + name + "=" + value;
  return text.empty() ? "no parameters" : text;
}

std::string folder_of(const SweepPoint& point) {
  constexpr std::size_t max_length = 100;
  std::string whole, folder;
  bool is_whole = true;
  for (const auto& [name, value] : point) {
    whole += name + "=" + value + "\n";
    folder += (folder.empty() ? "" : "_") + name + "=" + value;
  }
  if (folder.empty()) return "run";
  for (char& c : folder) {
    const bool is_plain =
        std::isalnum(static_cast<unsigned char>(c)) != 0 || std::string("=._+-").find(c) != std::string::npos;
    if (!is_plain) c = '_';
    is_whole = is_whole && is_plain;
  }
  if (is_whole && folder.size() <= max_length) return folder;
  return fmt::format("{}_{:016x}", folder.substr(0, max_length - 17), digest_of(whole));
}

std::vector<SweepRun> list_runs(const SweepPlan& plan) {
  if (plan.points_file && plan.n_samples) refuse_sweep("--points and --latin exclude each other");
  const std::vector<SweepPoint> from_file =
      plan.points_file ? read_points(*plan.points_file) : std::vector<SweepPoint>{{}};
  check_names(plan, from_file);
  const double n = count_runs(plan, from_file.size());
  if (n < 1.0) refuse_sweep("there are no runs");
  if (n > plan.max_runs)
    refuse_sweep(
        fmt::format("these are {:.0f} runs, more than the {:.0f} that --max-runs allows", n, plan.max_runs));
  const std::vector<SweepPoint> points = plan.n_samples ? sample(plan) : combine(plan.parameters);
  std::vector<SweepRun> runs;
  std::map<std::string, std::size_t> numbers;
  for (const SweepPoint& begun : from_file) {
    for (const SweepPoint& more : points) {
      SweepRun run{runs.size() + 1, begun, ""};
      run.point.insert(run.point.end(), more.begin(), more.end());
      run.folder = folder_of(run.point);
      const auto [found, is_new] = numbers.emplace(run.folder, run.number);
      if (!is_new)
        refuse_sweep(fmt::format("runs {} and {} are the same: {}", found->second, run.number,
                                 describe_point(run.point)));
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace contactsim
