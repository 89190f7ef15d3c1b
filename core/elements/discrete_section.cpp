// SPDX-License-Identifier: BSD-3-Clause
#include "core/elements/discrete_section.hpp"

#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/definition/simulation.hpp"
#include "core/elements/element_table.hpp"

namespace contactsim {

namespace {

/// The steepest slope of a table; nothing of other functions and of jumps.
std::optional<double> steepest_slope(const FunctionDefinition& definition) {
  if (definition.type != FunctionType::piecewise_linear || find_jump(definition)) return std::nullopt;
  const auto& values = definition.values;
  double steepest = 0.0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double rise = definition.y_scale * (values[i].ordinate - values[i - 1].ordinate);
    const double run = definition.x_scale * (values[i].abscissa - values[i - 1].abscissa);
    steepest = std::max(steepest, std::abs(rise / run));
  }
  return steepest;
}

/// Reads sections for one block.
class DiscreteReader {
 public:
  DiscreteReader(const SectionDefinition& section, const std::optional<ElementProperties>& material,
                 const DiscreteScope& scope)
      : section_(section),
        material_(material),
        scope_(scope),
        source_(scope.mesh.blocks()[scope.block]),
        name_(scope.mesh.name({EntityKind::block, scope.block})) {}

  std::optional<ModelBlock> read(const PointMassSection& section) const;
  std::optional<ModelBlock> read(const SpringSection& section) const;
  std::optional<ModelBlock> read(const DamperSection& section) const;
  template <class Section>
  std::optional<ModelBlock> read(const Section&) const {
    return std::nullopt;
  }

 private:
  std::optional<ModelBlock> fail(std::string text) const {
    scope_.diagnostics.add_error(section_.name.location, fmt::format("{}{}", name_, text));
    return std::nullopt;
  }

  /// Nothing when the shape is not one of the formulation, or a line has no length.
  std::optional<ModelBlock> make(std::string_view formulation, double density, double area) const;
  std::vector<Lanes> lengths() const;
  bool set_function(const SpringSection& section, ModelBlock& block) const;
  bool is_sound(const Eigen::Matrix3d& inertia) const;

  const SectionDefinition& section_;
  const std::optional<ElementProperties>& material_;
  const DiscreteScope& scope_;
  const ElementBlock& source_;
  std::string name_;
};

std::optional<ModelBlock> DiscreteReader::make(std::string_view formulation, double density,
                                               double area) const {
  const ElementFormulation* element = find_line_element(source_.shape, formulation);
  if (element == nullptr) {
    return fail(fmt::format(" has elements of type {}, which its {} is not for", topology(source_.shape).name,
                            source_.shape == Shape::sphere ? "spring or damper section" : "section"));
  }
  ModelBlock block = make_discrete_block(scope_.mesh, scope_.block, *element, density,
                                         std::vector<double>(source_.n_elements, area));
  if (source_.shape == Shape::sphere) return block;
  block.discrete.length = lengths();
  block.discrete.stable_step.assign(block.n_batches(),
                                    Lanes::Constant(std::numeric_limits<double>::infinity()));
  for (const Lanes& length : block.discrete.length) {
    if (!(length > 0.0).all()) return fail(" has elements without length, which have no direction");
  }
  return block;
}

std::vector<Lanes> DiscreteReader::lengths() const {
  std::vector<Lanes> lengths((source_.n_elements + n_lanes - 1) / n_lanes);
  for (std::size_t i = 0; i < lengths.size() * n_lanes; ++i) {
    const auto element = static_cast<std::uint32_t>(std::min<std::size_t>(i, source_.n_elements - 1));
    const auto nodes = source_.element_nodes(element);
    const auto& x = scope_.mesh.coordinates();
    lengths[i / n_lanes](static_cast<Eigen::Index>(i % n_lanes)) =
        (x.col(nodes[1].value) - x.col(nodes[0].value)).norm();
  }
  return lengths;
}

bool DiscreteReader::is_sound(const Eigen::Matrix3d& inertia) const {
  const Eigen::Vector3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(inertia).eigenvalues();
  const double round_off = 1e-9 * axes[2];
  return axes[0] >= -round_off && axes[0] + axes[1] >= axes[2] - round_off;
}

std::optional<ModelBlock> DiscreteReader::read(const PointMassSection& s) const {
  if (!s.mass) return fail(" is of point masses, but its section has no MASS");
  const double ixy = s.ixy.value_or(0.0), iyz = s.iyz.value_or(0.0), izx = s.izx.value_or(0.0);
  Eigen::Matrix3d inertia;
  inertia << s.ixx.value_or(0.0), ixy, izx, ixy, s.iyy.value_or(0.0), iyz, izx, iyz, s.izz.value_or(0.0);
  if (!is_sound(inertia)) return fail(": its section's moments of inertia are those of no body");
  const bool is_same = inertia.isApprox(inertia(0, 0) * Eigen::Matrix3d::Identity());
  if (!is_same && !section_.rigid_body) {
    return fail(
        ": free nodes have the same inertia about all axes; IXX, IYY and IZZ must be equal, without "
        "products, "
        "but in a rigid body");
  }
  const bool turns = inertia(0, 0) > 0.0 && !section_.rigid_body;
  auto block = make(turns ? "point_inertia" : "point_mass", *s.mass, 1.0);
  if (!block) return std::nullopt;
  block->discrete.inertia = inertia;
  if (turns) block->inertia.assign(block->n_batches(), Lanes::Constant(inertia(0, 0)));
  return block;
}

std::optional<ModelBlock> DiscreteReader::read(const SpringSection& s) const {
  if (!s.default_stiffness && !s.force_strain_function)
    return fail(" is of springs, but its section has neither DEFAULT STIFFNESS nor FORCE STRAIN FUNCTION");
  const double area = s.area.value_or(1.0);
  auto block = make("spring", s.mass_per_unit_length.value_or(0.0) / area, area);
  if (!block) return std::nullopt;
  for (const Lanes& mass : block->mass) {
    if (!mass.eigen().isFinite().all()) return fail(" has springs whose mass is not finite");
  }
  block->discrete.stiffness.assign(block->n_batches(), Lanes::Constant(s.default_stiffness.value_or(0.0)));
  if (s.force_strain_function && !set_function(s, *block)) return std::nullopt;
  return block;
}

bool DiscreteReader::set_function(const SpringSection& section, ModelBlock& block) const {
  const DeckName& name = *section.force_strain_function;
  auto function = make_named_function(name, scope_.functions, scope_.diagnostics);
  if (!function) return false;
  if (!function->inputs().empty()) {
    scope_.diagnostics.add_error(name.location,
                                 fmt::format("the function '{}' must be one of the strain", name.text));
    return false;
  }
  block.discrete.force_of_strain = std::move(function);
  if (section.default_stiffness) return true;
  const FunctionDefinition* definition = find_by_name(scope_.functions, name.text);
  const auto slope = definition != nullptr ? steepest_slope(*definition) : std::nullopt;
  if (!slope) {
    scope_.diagnostics.add_error(
        name.location, fmt::format("the steepest slope of the function '{}' is not known", name.text),
        "give it by DEFAULT STIFFNESS: the stable time step follows from it");
    return false;
  }
  for (std::size_t i = 0; i < block.n_batches(); ++i)
    block.discrete.stiffness[i] = *slope / block.discrete.length[i];
  return true;
}

std::optional<ModelBlock> DiscreteReader::read(const DamperSection& s) const {
  if (!material_) return std::nullopt;  // whoever looked for it has said so
  const double youngs = material_->law.moduli().youngs(), area = s.area.value_or(1.0);
  auto block = make("damper", material_->density, area);
  if (!block) return std::nullopt;
  for (const Lanes& length : block->discrete.length)
    block->discrete.stiffness.push_back(youngs * area / length);
  return block;
}

}  // namespace

bool is_discrete(const SectionDefinition& section) {
  const auto& is = section.properties;
  return std::holds_alternative<PointMassSection>(is) || std::holds_alternative<SpringSection>(is) ||
         std::holds_alternative<DamperSection>(is);
}

std::optional<ModelBlock> make_discrete(const SectionDefinition& section,
                                        const std::optional<ElementProperties>& material,
                                        const DiscreteScope& scope) {
  const DiscreteReader reader(section, material, scope);
  return std::visit([&](const auto& properties) { return reader.read(properties); }, section.properties);
}

}  // namespace contactsim
