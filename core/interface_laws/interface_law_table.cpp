// SPDX-License-Identifier: BSD-3-Clause
#include "core/interface_laws/interface_law_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/interface_laws/adhesion.hpp"
#include "core/interface_laws/cohesive_zone.hpp"
#include "core/interface_laws/constant_friction.hpp"
#include "core/interface_laws/hybrid.hpp"
#include "core/interface_laws/junction.hpp"
#include "core/interface_laws/pressure_function.hpp"
#include "core/interface_laws/pressure_velocity.hpp"
#include "core/interface_laws/spring_weld.hpp"
#include "core/interface_laws/sticking.hpp"
#include "core/interface_laws/surface_weld.hpp"
#include "core/interface_laws/threaded.hpp"
#include "core/interface_laws/time_variant.hpp"

namespace contactsim {

namespace {

InterfaceLawRow tied() {
  InterfaceLawRow row{"tied", "What touches at the start stays together"};
  row.holding = ContactLaw::tied;
  row.holds_at_start = true;
  return row;
}

InterfaceLawRow glued() {
  InterfaceLawRow row{"glued", "What touches once stays together from then on"};
  row.holding = ContactLaw::glued;
  return row;
}

}  // namespace

std::span<const InterfaceLawRow> interface_law_rows() {
  static const std::vector<InterfaceLawRow> rows{
      {"frictionless", "Normal force only"},
      constant_friction(),
      sticking(),
      tied(),
      glued(),
      spring_weld(),
      surface_weld(),
      area_weld(),
      adhesion(),
      cohesive_zone(),
      junction(),
      threaded(),
      pressure_velocity(),
      pressure_function(),
      exponential_pressure(),
      hybrid(),
      time_variant(),
  };
  return rows;
}

const InterfaceLawRow& row_of(const FrictionLaw& law) {
  const auto row = std::ranges::find(interface_law_rows(), law.type, &InterfaceLawRow::name);
  if (row == interface_law_rows().end())
    throw std::logic_error(fmt::format("there is no interface law '{}'", law.type));
  return *row;
}

FrictionLaw make_friction_law(std::string_view name) {
  FrictionLaw law{std::string(name)};
  law.values = ParameterValues(row_of(law).parameters);
  return law;
}

bool has_pressure(const FrictionLaw& law, std::span<const FrictionModel> models) {
  if (row_of(law).has_pressure) return true;
  return std::ranges::any_of(law.values.names(ParameterKind::friction_model), [&](const DeckName& name) {
    const FrictionLaw* named = find_friction_law(models, name.text);
    return named != nullptr && row_of(*named).has_pressure;
  });
}

std::string describe_law(const FrictionLaw& law) {
  const InterfaceLawRow& row = row_of(law);
  return row.describe != nullptr ? row.describe(law.values) : row.name;
}

}  // namespace contactsim
