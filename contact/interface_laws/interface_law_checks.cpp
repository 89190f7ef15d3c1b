// SPDX-License-Identifier: BSD-3-Clause
#include "contact/interface_laws/interface_law_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace contactsim {

namespace {

struct LawNamer {
  std::string operator()(const Frictionless&) const { return "frictionless"; }
  std::string operator()(const ConstantFriction& law) const {
    return fmt::format("friction {:.6g}", law.coefficient);
  }
  std::string operator()(const Tied&) const { return "tied"; }
  std::string operator()(const Glued&) const { return "glued"; }
  std::string operator()(const SpringWeld&) const { return "spring weld"; }
  std::string operator()(const SurfaceWeld& law) const {
    return law.is_per_area ? "area weld" : "surface weld";
  }
  std::string operator()(const Adhesion&) const { return "adhesion"; }
  std::string operator()(const CohesiveZone&) const { return "cohesive zone"; }
  std::string operator()(const Junction&) const { return "junction"; }
  std::string operator()(const Threaded&) const { return "threaded"; }
  std::string operator()(const PressureVelocityFriction&) const { return "pv dependent"; }
  std::string operator()(const HybridFriction&) const { return "hybrid"; }
  std::string operator()(const TimeVariantFriction&) const { return "time variant"; }
};

/// Whether a model, or one that it may be, holds its sides together.
bool holds(const PairInterfaceLaw& law) {
  const auto of_one = [](const std::shared_ptr<const InterfaceLaw>& one) {
    return one && (one->law != ContactLaw::sliding || one->bond_law);
  };
  return of_one(law.law) || of_one(law.far) ||
         std::ranges::any_of(law.periods,
                             [&](const PairInterfaceLaw::Period& period) { return of_one(period.law); });
}

}  // namespace

std::string describe_law(const FrictionLaw& law) { return std::visit(LawNamer{}, law); }

void refuse_laws(std::span<const SurfacePair> pairs, std::span<const ContactSurface> surfaces,
                 const LawScope& scope, Diagnostics& diagnostics) {
  const std::vector<PairInterfaceLaw> laws = make_pair_laws(pairs, scope, diagnostics);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const SurfacePair& pair = pairs[i];
    const ContactSurface &first = surfaces[pair.first], &second = surfaces[pair.second];
    if (first.analytic_planes.empty() && second.analytic_planes.empty()) continue;
    if (!holds(laws[i])) continue;
    diagnostics.add_error(pair.location,
                          fmt::format("'{}' and '{}' cannot be {}: one is an analytic plane", first.name,
                                      second.name, describe_law(*pair.law)),
                          "nothing is held to planes");
  }
}

}  // namespace contactsim
