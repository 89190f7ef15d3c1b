// SPDX-License-Identifier: BSD-3-Clause
#include "contact/friction_words.hpp"

#include <fmt/format.h>

#include <set>
#include <string_view>

namespace contactsim {

namespace {

/// A law's name, and whether a run acts on it.
struct LawWords {
  std::string text;
  bool is_supported = false;
};

struct LawNamer {
  LawWords operator()(const Frictionless&) const { return {"frictionless", true}; }
  LawWords operator()(const ConstantFriction& law) const {
    return {fmt::format("friction {:.6g}", law.coefficient), true};
  }
  LawWords operator()(const Tied&) const { return {"tied", true}; }
  LawWords operator()(const Glued&) const { return {"glued", true}; }
  LawWords operator()(const SpringWeld&) const { return {"spring weld"}; }
  LawWords operator()(const SurfaceWeld& law) const {
    return {law.is_per_area ? "area weld" : "surface weld"};
  }
  LawWords operator()(const Adhesion&) const { return {"adhesion"}; }
  LawWords operator()(const CohesiveZone&) const { return {"cohesive zone"}; }
  LawWords operator()(const Junction&) const { return {"junction"}; }
  LawWords operator()(const Threaded&) const { return {"threaded"}; }
  LawWords operator()(const PressureVelocityFriction&) const { return {"pv dependent"}; }
  LawWords operator()(const HybridFriction&) const { return {"hybrid"}; }
  LawWords operator()(const TimeVariantFriction&) const { return {"time variant"}; }
};

}  // namespace

std::string describe_law(const FrictionLaw& law) { return std::visit(LawNamer{}, law).text; }

void refuse_laws(std::span<const SurfacePair> pairs, std::span<const ContactSurface> surfaces,
                 Diagnostics& diagnostics) {
  std::set<std::string> told;
  for (const SurfacePair& pair : pairs) {
    const LawWords words = std::visit(LawNamer{}, pair.law);
    const bool holds = std::holds_alternative<Tied>(pair.law) || std::holds_alternative<Glued>(pair.law);
    const bool has_plane =
        !surfaces[pair.first].analytic_planes.empty() || !surfaces[pair.second].analytic_planes.empty();
    if (holds && has_plane) {
      diagnostics.add_error(pair.location,
                            fmt::format("'{}' and '{}' cannot be {}: one is an analytic plane",
                                        surfaces[pair.first].name, surfaces[pair.second].name, words.text),
                            "planes only push");
    }
    const bool is_news = !words.is_supported && told.insert(to_string(pair.location)).second;
    if (!is_news) continue;
    diagnostics.add_error(pair.location,
                          fmt::format("the friction model '{}' is not supported in a run yet", words.text),
                          "frictionless, constant friction, tied and glued are");
  }
}

}  // namespace contactsim
