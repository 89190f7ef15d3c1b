// SPDX-License-Identifier: BSD-3-Clause
#include "core/model.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/elements/element_table.hpp"
#include "core/mesh/block_names.hpp"
#include "core/names.hpp"
#include "core/rigid/make_rigid_bodies.hpp"
#include "core/shell_section.hpp"

namespace contactsim {

namespace {

/// Builds the blocks of a model, one after another, and collects what is wrong with them.
class BlockMaker {
 public:
  BlockMaker(const SimulationDefinition& definition, const FiniteElementModel& model, const Mesh& mesh,
             Diagnostics& diagnostics)
      : definition_(definition), model_(model), mesh_(mesh), diagnostics_(diagnostics) {}

  void add_block(std::uint32_t index, std::span<const std::string> names, std::vector<SolidBlock>& blocks) {
    const BlockParameters* parameters = find_block_parameters(model_, names);
    block_name_ = mesh_.name({EntityKind::block, index});
    if (parameters == nullptr) {
      add_error(model_.name.location,
                fmt::format("{} has no PARAMETERS FOR BLOCK in '{}'", block_name_, model_.name.text), "");
      return;
    }
    const bool is_shell = topology(mesh_.blocks()[index].shape).family == Family::shell;
    auto block = is_shell ? make_shells(index, *parameters) : make_solids(index, *parameters);
    if (!block) return;
    check_volumes(*block, *parameters);
    const SectionDefinition* section = find_section(definition_, *parameters);
    block->is_rigid = section != nullptr && section->rigid_body;
    block->material = fmt::format("{} ({})", parameters->material->text, parameters->model->text);
    blocks.push_back(std::move(*block));
  }

 private:
  std::optional<SolidBlock> make_solids(std::uint32_t index, const BlockParameters& parameters) {
    const SolidSection* section = find_solid_section(index, parameters);
    const SolidElement* element =
        section ? find_formulation(topology(mesh_.blocks()[index].shape), *section, parameters) : nullptr;
    const auto properties = make_properties(parameters, section);
    if (element == nullptr || !properties) return std::nullopt;
    return make_solid_block(mesh_, index, *element, *properties);
  }

  std::optional<SolidBlock> make_shells(std::uint32_t index, const BlockParameters& parameters) {
    const ShellSection* section = find_shell_section(index, parameters);
    const auto properties = make_properties(parameters, nullptr);
    if (section == nullptr || !properties) return std::nullopt;
    const SolidElement* element = find_formulation(index, *section, parameters);
    if (!can_be_plane(properties->law)) {
      add_error(
          parameters.location,
          fmt::format("{}: shells of the model {} are not supported", block_name_, parameters.model->text),
          "");
      return std::nullopt;
    }
    const DeckLocation& location = section_location_.is_known() ? section_location_ : parameters.location;
    const auto settings = make_shell_settings(*section, parameters, location, diagnostics_);
    const auto thicknesses = find_thicknesses(*section, mesh_, index, location, diagnostics_);
    if (element == nullptr || !settings || !thicknesses) return std::nullopt;
    return make_shell_block(mesh_, index, *element, *properties, *settings, *thicknesses);
  }

  /// A block without a section has the default one, with the thickness of the mesh.
  const ShellSection* find_shell_section(std::uint32_t index, const BlockParameters& parameters) {
    const SectionDefinition* section = find_section(definition_, parameters);
    section_location_ = section != nullptr ? section->name.location : DeckLocation{};
    if (section == nullptr) return &default_shell_section_;
    const auto* shell = std::get_if<ShellSection>(&section->properties);
    if (shell == nullptr) {
      add_error(section->name.location,
                fmt::format("{} has elements of type {}, but its section '{}' is not a SHELL SECTION",
                            block_name_, topology(mesh_.blocks()[index].shape).name, section->name.text),
                "");
    }
    return shell;
  }

  const SolidElement* find_formulation(std::uint32_t index, const ShellSection& section,
                                       const BlockParameters& parameters) {
    const Topology& shape = topology(mesh_.blocks()[index].shape);
    const std::string wanted = fold(section.formulation.text);
    const bool is_alike = wanted == "bl_shell" || wanted == "kh_shell";
    if (is_alike) {
      diagnostics_.add_warning(
          "shell-formulation", section.formulation.location,
          fmt::format("{}: BT_SHELL stands in for {}", block_name_, section.formulation.text),
          "both have one point of integration in the surface");
    }
    const SolidElement* element = find_shell_element(shape.shape, is_alike ? "bt_shell" : wanted);
    if (element != nullptr) return element;
    const std::string known = list_formulations(shape.shape);
    add_error(section.formulation.location.is_known() ? section.formulation.location : parameters.location,
              known.empty() ? fmt::format("{} has elements of type {}, which are not supported", block_name_,
                                          shape.name)
                            : fmt::format("{}: there is no {} with the formulation {}", block_name_,
                                          shape.name, section.formulation.text),
              known.empty() ? "shells of three and four nodes are" : fmt::format("it has {}", known));
    return nullptr;
  }

  void add_error(const DeckLocation& location, std::string text, std::string hint) {
    diagnostics_.add_error(location, std::move(text), std::move(hint));
  }

  const SolidSection* find_solid_section(std::uint32_t index, const BlockParameters& parameters) {
    const Topology& shape = topology(mesh_.blocks()[index].shape);
    const SectionDefinition* section = find_section(definition_, parameters);
    const SolidSection* solid = &default_section_;
    if (section != nullptr) solid = std::get_if<SolidSection>(&section->properties);
    if (shape.family != Family::solid) {
      add_error(parameters.location,
                fmt::format("{} has elements of type {}: only solids and shells can move so far", block_name_,
                            shape.name),
                "--check resolves the surfaces of all of them");
      return nullptr;
    }
    if (solid == nullptr) {
      add_error(section->name.location,
                fmt::format("{} has elements of type {}, but its section '{}' is not a SOLID SECTION",
                            block_name_, shape.name, section->name.text),
                "");
      return nullptr;
    }
    check_options(*solid);
    return solid;
  }

  /// Everything but the formulation that a SOLID SECTION may ask for.
  void check_options(const SolidSection& solid) {
    const DeckName& strain = solid.strain_incrementation;
    // Hughes and Winget's increment is objective and taken in the middle of the step: it is both.
    if (fold(strain.text) != "midpoint_increment" && fold(strain.text) != "strongly_objective") {
      add_error(strain.location, fmt::format("there is no strain incrementation '{}'", strain.text),
                "there are midpoint_increment and strongly_objective");
    }
    if (solid.is_hourglass_total || solid.is_hourglass_rotation_scaled) {
      diagnostics_.add_warning(
          "hourglass-incremental", strain.location,
          fmt::format("{}: hourglass forces are incremental and turn with the material", block_name_),
          "HOURGLASS FORMULATION and HOURGLASS ROTATION have no effect");
    }
  }

  const SolidElement* find_formulation(const Topology& shape, const SolidSection& solid,
                                       const BlockParameters& parameters) {
    const SolidElement* element = find_solid_element(shape.shape, solid.formulation.text);
    if (element != nullptr) return element;
    const bool is_known = !list_formulations(shape.shape).empty();
    const DeckLocation& location =
        is_known && solid.formulation.location.is_known() ? solid.formulation.location : parameters.location;
    if (!is_known) {
      add_error(location,
                fmt::format("{} has elements of type {}, which are not supported", block_name_, shape.name),
                "linear hexahedra, tetrahedra, wedges and pyramids are");
    } else {
      add_error(location,
                fmt::format("{}: there is no {} with the formulation {}", block_name_, shape.name,
                            solid.formulation.text),
                fmt::format("it has {}", list_formulations(shape.shape)));
    }
    return nullptr;
  }

  std::optional<SolidProperties> make_properties(const BlockParameters& parameters,
                                                 const SolidSection* section) {
    if (!parameters.material || !parameters.model) {
      add_error(parameters.location,
                fmt::format("{} has no {}", block_name_, parameters.material ? "MODEL" : "MATERIAL"), "");
      return std::nullopt;
    }
    const MaterialDefinition* material = find_by_name(definition_.materials, parameters.material->text);
    const MaterialModel* model = material ? find_model(*material, parameters.model->text) : nullptr;
    if (model == nullptr) return std::nullopt;  // the binder has said so
    if (parameters.effective_moduli_model != EffectiveModuliModel::elastic) {
      diagnostics_.add_warning("effective-moduli", parameters.location,
                               fmt::format("{}: EFFECTIVE MODULI MODEL has no effect", block_name_),
                               "viscosity and hourglass resistance follow the elastic moduli");
    }
    const auto law = make_material_law(*model, diagnostics_);
    if (!law) return std::nullopt;
    return SolidProperties{*law,
                           material->density,
                           parameters.hourglass_stiffness,
                           parameters.hourglass_viscosity,
                           parameters.linear_bulk_viscosity,
                           parameters.quadratic_bulk_viscosity,
                           section != nullptr ? section->deviatoric_parameter.value_or(1.0) : 1.0};
  }

  /// Elements without a positive volume have no mass and no gradients.
  void check_volumes(const SolidBlock& block, const BlockParameters& parameters) {
    std::size_t n_bad = 0, first = 0;
    for (std::size_t element = 0; element < block.n_elements; ++element) {
      if (block.mass[element / n_lanes](static_cast<Eigen::Index>(element % n_lanes)) > 0.0) continue;
      if (n_bad++ == 0) first = element;
    }
    if (n_bad == 0) return;
    const auto id = mesh_.element_id({block.first_element.value + static_cast<std::uint32_t>(first)});
    const std::string others = n_bad > 1 ? fmt::format(" and {} more", n_bad - 1) : "";
    add_error(
        parameters.location,
        fmt::format("{}: element {}{} without a positive volume", block_name_, id,
                    n_bad > 1 ? others + " are" : " is"),
        block.element->n_points > 1 ? "at an integration point; mean quadrature asks less of a shape" : "");
  }

  const SimulationDefinition& definition_;
  const FiniteElementModel& model_;
  const Mesh& mesh_;
  Diagnostics& diagnostics_;
  SolidSection default_section_;
  ShellSection default_shell_section_;
  DeckLocation section_location_;  ///< of the block at hand; not known when it has none
  std::string block_name_;
};

/// An element gives each of its nodes an equal share of what it has.
///   of_elements  [n_batches]
void add_shares(const SolidBlock& block, const Mesh& mesh, std::span<const Lanes> of_elements,
                Eigen::Matrix3Xd& sums) {
  const ElementBlock& source = mesh.blocks()[block.mesh_block];
  for (std::uint32_t element = 0; element < source.n_elements; ++element) {
    const double of_element = of_elements[element / n_lanes](element % n_lanes);
    const auto nodes = source.element_nodes(element);
    for (const NodeIndex node : nodes)
      sums.col(node.value).array() += of_element / static_cast<double>(nodes.size());
  }
}

}  // namespace

Eigen::Matrix3Xd lumped_mass(const Mesh& mesh, std::span<const SolidBlock> blocks) {
  Eigen::Matrix3Xd mass = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  for (const SolidBlock& block : blocks) add_shares(block, mesh, block.mass, mass);
  return mass.cwiseMax(least_mass);
}

Eigen::Matrix3Xd lumped_inertia(const Mesh& mesh, std::span<const SolidBlock> blocks) {
  const auto turns = [](const SolidBlock& block) { return block.element->has_rotations; };
  if (std::none_of(blocks.begin(), blocks.end(), turns)) return Eigen::Matrix3Xd(3, 0);
  Eigen::Matrix3Xd inertia = Eigen::Matrix3Xd::Zero(3, mesh.n_nodes());
  for (const SolidBlock& block : blocks) {
    if (turns(block)) add_shares(block, mesh, block.inertia, inertia);
  }
  return inertia.cwiseMax(least_mass);
}

Model make_model(const SimulationDefinition& definition, const Region& region, const Mesh& mesh,
                 Diagnostics& diagnostics) {
  Model model;
  model.mesh = &mesh;
  const FiniteElementModel* elements = find_finite_element_model(definition, region);
  if (elements == nullptr) {
    diagnostics.add_error(region.name.location, "the region has no finite element model",
                          "without one only --check can be run");
    return model;
  }
  BlockMaker maker(definition, *elements, mesh, diagnostics);
  const auto names = find_block_names(mesh, elements->aliases);
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    if (mesh.blocks()[i].n_elements > 0) maker.add_block(i, names[i], model.blocks);
  }
  model.mass = lumped_mass(mesh, model.blocks);
  model.inertia = lumped_inertia(mesh, model.blocks);
  make_rigid_bodies(definition, region, model, diagnostics);
  return model;
}

}  // namespace contactsim
