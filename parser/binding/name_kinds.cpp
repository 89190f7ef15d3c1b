// SPDX-License-Identifier: BSD-3-Clause
#include "parser/binding/name_kinds.hpp"

#include <cassert>

#include "core/definition/built_in_friction.hpp"
#include "core/definition/function.hpp"

namespace contactsim {

namespace {

NameKindText of_mesh(NameKind kind, std::string_view word) {
  NameKindText text{kind, word};
  text.is_in_mesh = true;
  return text;
}

NameKindText function_text() {
  NameKindText text{NameKind::function, "function", {}, {}, Counts::even_reading_when_used};
  text.built_in = {constant_one_function};
  return text;
}

NameKindText friction_model_text() {
  NameKindText text{
      NameKind::friction_model, "friction model", NameKind::contact_definition, {}, Counts::when_used};
  for (const BuiltInFriction& built_in : built_in_friction) text.built_in.push_back(built_in.name);
  text.redefines_built_in = true;
  text.mistake = {NameKind::material, "cohesive materials as friction models are not supported"};
  text.made_by = "BEGIN CONSTANT FRICTION MODEL <name>, say";
  return text;
}

NameKindText direction_text() {
  NameKindText text{NameKind::direction, "direction"};
  text.made_by = "DEFINE DIRECTION <name> WITH VECTOR <x> <y> <z>";
  return text;
}

/// In the order of NameKind.
std::vector<NameKindText> make_texts() {
  using K = NameKind;
  return {
      {K::point, "point"},
      direction_text(),
      {K::axis, "axis", {}, {}, Counts::when_used},
      {K::coordinate_system, "coordinate system", {}, {}, Counts::when_used},
      function_text(),
      {K::material, "material", {}, {}, Counts::even_reading_when_used},
      {K::model, "model", K::material, "the material '{}'", Counts::even_reading_when_used},
      {K::section, "section", {}, {}, Counts::even_reading_when_used},
      {K::rigid_body, "rigid body", {}, {}, Counts::when_used},
      {K::finite_element_model, "finite element model", {}, {}, Counts::when_used},
      {K::output_scheduler, "output scheduler"},
      {K::procedure, "procedure"},
      {K::region, "region", K::procedure, "this procedure"},
      {K::time_stepping_block, "time stepping block", K::procedure},
      {K::analytic_object, "analytic object", K::region},
      {K::user_variable, "user variable", K::region},
      {K::contact_definition, "contact definition", K::region},
      {K::contact_surface, "contact surface", K::contact_definition},
      friction_model_text(),
      {K::interaction, "interaction", K::contact_definition},
      {K::surface_smoothing, "surface smoothing", K::contact_definition},
      of_mesh(K::block, "block"),
      of_mesh(K::node_set, "node set"),
      of_mesh(K::side_set, "side set"),
      of_mesh(K::assembly, "assembly"),
  };
}

}  // namespace

const NameKindText& text_of(NameKind kind) {
  static const std::vector<NameKindText> texts = make_texts();
  const NameKindText& text = texts[static_cast<std::size_t>(kind)];
  assert(text.kind == kind);
  return text;
}

}  // namespace contactsim
