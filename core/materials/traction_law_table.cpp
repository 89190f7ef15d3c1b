// SPDX-License-Identifier: BSD-3-Clause
#include "core/materials/traction_law_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "core/base/names.hpp"

namespace contactsim {

namespace {

TractionLaw make_trapezoid(const ParameterValues& values) {
  TractionLaw law{values.real("peak traction"),
                  values.real("lambda_1"),
                  values.real("lambda_2"),
                  values.real("normal length scale"),
                  values.real("tangential length scale"),
                  values.real("penetration stiffness multiplier")};
  if (!(law.lambda_1 <= law.lambda_2 && law.lambda_2 < 1.0)) {
    throw std::invalid_argument(
        fmt::format("0 < LAMBDA_1 <= LAMBDA_2 < 1 must hold, found {} and {}", law.lambda_1, law.lambda_2));
  }
  return law;
}

TractionLawRow tvergaard_hutchinson() {
  using namespace parameter;
  return {"tvergaard_hutchinson",
          "Traction over separation of cohesive elements: a trapezoid, the same toughness in every mode",
          {positive("peak traction", "Largest traction against opening [force/length^2]").required(),
           positive("lambda_1", "Separation over that at failure where the peak begins [1]").required(),
           positive("lambda_2", "Separation over that at failure where the peak ends, < 1 [1]").required(),
           positive("normal length scale", "Opening at failure [length]").required(),
           positive("tangential length scale", "Sliding at failure [length]").required(),
           positive("penetration stiffness multiplier",
                    "Stiffness in compression over the undamaged one against opening [1]")
               .otherwise(1.0)},
          make_trapezoid};
}

}  // namespace

std::span<const TractionLawRow> traction_law_rows() {
  static const std::vector<TractionLawRow> rows{tvergaard_hutchinson()};
  return rows;
}

const TractionLawRow* find_traction_law_row(std::string_view name) {
  const auto rows = traction_law_rows();
  const auto found = std::ranges::find(rows, fold(name), &TractionLawRow::name);
  return found == rows.end() ? nullptr : &*found;
}

std::optional<TractionLaw> make_traction_law(const MaterialModel& model, Diagnostics& diagnostics) {
  const auto fail = [&](std::string_view what, std::string hint) {
    diagnostics.add_error(model.name.location, fmt::format("model '{}': {}", model.name.text, what),
                          std::move(hint), static_cast<int>(model.name.text.size()));
    return std::nullopt;
  };
  const TractionLawRow* row = find_traction_law_row(model.name.text);
  if (row == nullptr)
    return fail("cohesive elements take no such model",
                fmt::format("there is {}", traction_law_rows()[0].name));
  try {
    return row->make(model.values);
  } catch (const std::invalid_argument& problem) {
    return fail(problem.what(), "");
  }
}

}  // namespace contactsim
