// SPDX-License-Identifier: BSD-3-Clause
#include "parser/name_resolution.hpp"

#include <fmt/format.h>

#include <map>
#include <set>

#include "core/functions/function.hpp"
#include "parser/commands/material_commands.hpp"
#include "parser/commands/time_commands.hpp"
#include "parser/region_names.hpp"

namespace contactsim {

namespace {

int length_of(const DeckName& name) { return static_cast<int>(name.text.size()); }

class NameResolution {
 public:
  NameResolution(const SimulationDefinition& simulation, Diagnostics& diagnostics)
      : simulation_(simulation), diagnostics_(diagnostics), is_fragment_(simulation.form != DeckForm::full) {
    define_names();
  }

  /// From the regions inwards: what a definition uses is used only if the definition is.
  void resolve() {
    for (const Procedure& procedure : simulation_.procedures) use(procedure);
    if (is_fragment_) {
      for (const FiniteElementModel& model : simulation_.finite_element_models)
        models_.use(model.name, diagnostics_);
    }
    for_each_used(simulation_.finite_element_models, models_, [&](const auto& model) { use_model(model); });
    for_each_used(simulation_.sections, sections_, [&](const auto& section) { use_section(section); });
    for_each_used(simulation_.materials, outside_.materials, [&](const auto& material) { check(material); });
    for_each_used(simulation_.rigid_bodies, outside_.rigid_bodies, [&](const auto& body) { use_body(body); });
    for_each_used(simulation_.coordinate_systems, outside_.coordinate_systems, [&](const auto& system) {
      for (const DeckName* point : {&system.origin, &system.point_on_z, &system.point_in_xz})
        use_point(*point);
    });
    for_each_used(simulation_.axes, outside_.axes, [&](const auto& axis) { use_axis(axis); });
    for_each_used(simulation_.functions, outside_.functions, [&](const auto& function) {
      make_function(function, diagnostics_);
      used_keys_.insert(use_key("function", function.name.text));
    });
  }

  void report(const HeldDiagnostics& held) const {
    const bool is_used = used_keys_.count(held.key) > 0;
    for (Diagnostic problem : held.found.all()) {
      if (!is_used && problem.severity == Severity::error) {
        problem.severity = Severity::warning;
        problem.id = "deck-unused";
        problem.text += ", but nothing uses this definition";
      }
      diagnostics_.add(std::move(problem));
    }
  }

 private:
  template <class T>
  void define(const std::vector<T>& definitions, KnownNames& names) {
    for (const T& definition : definitions) names.define(definition.name, diagnostics_);
    if (is_fragment_) names.allow_unknown();
  }

  template <class T, class Use>
  void for_each_used(const std::vector<T>& definitions, const KnownNames& names, Use use_definition) {
    for (const T& definition : definitions) {
      if (names.is_used(definition.name.text)) use_definition(definition);
    }
  }

  void define_names() {
    define(simulation_.points, points_);
    define(simulation_.directions, outside_.directions);
    define(simulation_.axes, outside_.axes);
    define(simulation_.coordinate_systems, outside_.coordinate_systems);
    outside_.functions.add_built_in(constant_one_function);
    define(simulation_.functions, outside_.functions);
    define(simulation_.materials, outside_.materials);
    define(simulation_.sections, sections_);
    define(simulation_.rigid_bodies, outside_.rigid_bodies);
    define(simulation_.finite_element_models, models_);
    define(simulation_.output_schedulers, outside_.output_schedulers);
    KnownNames procedures("procedure");
    define(simulation_.procedures, procedures);
    for (const MaterialDefinition& material : simulation_.materials) {
      const auto [models, is_new] = material_models_.try_emplace(
          fold(material.name.text),
          KnownNames("model", fmt::format("the material '{}'", material.name.text)));
      if (is_new) define(material.models, models->second);
    }
  }

  void use(const Procedure& procedure) {
    KnownNames regions("region", "this procedure");
    define(procedure.regions, regions);
    outside_.periods = KnownNames("time stepping block");
    if (is_fragment_) outside_.periods.allow_unknown();
    if (procedure.time_control) use(*procedure.time_control, regions);
    for (const Region& region : procedure.regions) {
      use_model_of(region);
      resolve_region_names(region, outside_, diagnostics_);
    }
  }

  void use(const TimeControl& control, KnownNames& regions) {
    define(control.time_stepping_blocks, outside_.periods);
    check_time_control(control, diagnostics_);
    for (const TimeSteppingBlock& block : control.time_stepping_blocks) {
      for (const auto& parameters : block.explicit_parameters) regions.use(parameters.name, diagnostics_);
      for (const auto& parameters : block.implicit_parameters) {
        regions.use(parameters.name, diagnostics_);
        if (parameters.increment_function)
          outside_.functions.use(*parameters.increment_function, diagnostics_);
      }
    }
  }

  void use_model_of(const Region& region) {
    if (region.finite_element_model) {
      models_.use(*region.finite_element_model, diagnostics_);
      return;
    }
    if (is_fragment_) return;
    const auto& models = simulation_.finite_element_models;
    const std::string text = fmt::format("the region '{}' has no USE FINITE ELEMENT MODEL", region.name.text);
    if (models.size() > 1) {
      diagnostics_.add_error(region.name.location, text, "name one of the models", length_of(region.name));
      return;
    }
    diagnostics_.add_warning("deck-model", region.name.location, text,
                             models.empty() ? "the mesh is that of the command line, or <deck base>.g"
                                            : fmt::format("'{}' is taken", models.front().name.text),
                             length_of(region.name));
    if (!models.empty()) models_.use(models.front().name, diagnostics_);
  }

  void use_model(const FiniteElementModel& model) {
    std::map<std::string, DeckLocation> blocks;
    for (const BlockParameters& parameters : model.block_parameters) {
      for (const DeckName& name : parameters.names) {
        const auto [entry, is_new] = blocks.try_emplace(fold(name.text), name.location);
        if (is_new) continue;
        diagnostics_.add_error(name.location,
                               fmt::format("the block '{}' is given parameters a second time", name.text),
                               "the first stand at " + to_string(entry->second), length_of(name));
      }
      use(parameters);
    }
  }

  void use(const BlockParameters& parameters) {
    if (parameters.section) sections_.use(*parameters.section, diagnostics_);
    if (parameters.material && outside_.materials.use(*parameters.material, diagnostics_) &&
        parameters.model) {
      const std::string material = fold(parameters.material->text);
      if (material_models_.at(material).use(*parameters.model, diagnostics_)) {
        used_keys_.insert(model_use_key(material, fold(parameters.model->text)));
      }
    }
    if (parameters.model && !parameters.material) {
      diagnostics_.add_error(
          parameters.model->location,
          fmt::format("the model '{}' is chosen without a material", parameters.model->text),
          "add MATERIAL = <material>", length_of(*parameters.model));
    }
  }

  void use_section(const SectionDefinition& section) {
    used_keys_.insert(use_key("section", section.name.text));
    if (section.rigid_body) outside_.rigid_bodies.use(*section.rigid_body, diagnostics_);
    if (const auto* shell = std::get_if<ShellSection>(&section.properties); shell && shell->orientation) {
      outside_.coordinate_systems.use(*shell->orientation, diagnostics_);
    }
    if (const auto* spring = std::get_if<SpringSection>(&section.properties);
        spring && spring->force_strain_function) {
      outside_.functions.use(*spring->force_strain_function, diagnostics_);
    }
  }

  void use_body(const RigidBodyDefinition& body) {
    if (body.direction) outside_.directions.use(*body.direction, diagnostics_);
    if (body.cylindrical_axis) outside_.axes.use(*body.cylindrical_axis, diagnostics_);
  }

  void use_point(const DeckName& point) { points_.use(point, diagnostics_); }

  void use_axis(const AxisDefinition& axis) {
    use_point(axis.point);
    if (axis.direction) outside_.directions.use(*axis.direction, diagnostics_);
    if (axis.second_point) use_point(*axis.second_point);
  }

  void check(const MaterialDefinition& material) {
    used_keys_.insert(use_key("material", material.name.text));
    check_used_material(material, diagnostics_);
    for (const MaterialModel& model : material.models) {
      const std::string key = model_use_key(fold(material.name.text), fold(model.name.text));
      if (used_keys_.count(key) == 0) continue;
      check_used_model(material, model, diagnostics_);
      for (const DeckName& system : model.values.names(ParameterKind::coordinate_system))
        outside_.coordinate_systems.use(system, diagnostics_);
      for (const DeckName& function : model.values.names(ParameterKind::function))
        outside_.functions.use(function, diagnostics_);
    }
  }

  const SimulationDefinition& simulation_;
  Diagnostics& diagnostics_;
  bool is_fragment_;
  OutsideNames outside_;
  KnownNames points_{"point"}, sections_{"section"}, models_{"finite element model"};
  std::map<std::string, KnownNames> material_models_;  ///< by the folded name of the material
  std::set<std::string> used_keys_;                    ///< as use_key and model_use_key make them
};

}  // namespace

void resolve_names(const SimulationDefinition& simulation, const std::vector<HeldDiagnostics>& held,
                   Diagnostics& diagnostics) {
  NameResolution resolution(simulation, diagnostics);
  resolution.resolve();
  for (const HeldDiagnostics& problems : held) resolution.report(problems);
}

}  // namespace contactsim
