// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <tuple>

#include "core/elements/element_table.hpp"
#include "core/output/cohesive_values.hpp"
#include "core/output/element_view.hpp"
#include "core/output/output_table.hpp"
#include "core/output/strain_measures.hpp"

namespace contactsim {

namespace {

using Values = std::span<double>;

void put(double value, double* to) { *to = value; }
void put(const Eigen::Vector3d& value, double* to) { Eigen::Map<Eigen::Vector3d>{to} = value; }
template <std::size_t n>
void put(const std::array<double, n>& value, double* to) {
  std::copy(value.begin(), value.end(), to);
}

// Fills a range with value(element), a number, vector or array. It is a type, so that a row needs no object.
template <class Value>
void fill_range(const OutputContext& context, const EntityRange& range, Values values) {
  const std::size_t n_components = values.size() / range.count;
  for (std::size_t i = 0; i < range.count; ++i)
    put(Value{}(ElementView{context, range, i}), values.data() + i * n_components);
}

template <class Value>
constexpr OutputRow make_row(std::string_view name, FieldShape shape, Value, std::string_view help) {
  return {name, FieldLocation::element, shape, false, fill_range<Value>, help, 3};
}

// A variable that every integration point has.
template <class Value>
constexpr OutputRow point_row(std::string_view name, FieldShape shape, Value value, std::string_view help) {
  OutputRow row = make_row(name, shape, value, help);
  row.is_at_points = true;
  return row;
}

using E = ElementView;

Eigen::Matrix3d unrotated_stress(const E& e) {
  if (e.life() == 0.0) return Eigen::Matrix3d::Zero();  // its nodes may be anywhere
  const Eigen::Matrix3d rotation = rotation_of(e.deformation_gradient());
  return rotation.transpose() * e.stress() * rotation;
}

Eigen::Matrix3d first_pk_stress(const E& e) {
  if (e.life() == 0.0) return Eigen::Matrix3d::Zero();
  const Eigen::Matrix3d f = e.deformation_gradient();
  return f.determinant() * e.stress() * f.inverse().transpose();
}

double max_shear(const Eigen::Vector3d& principal) { return 0.5 * (principal[0] - principal[2]); }

constexpr auto scalar = FieldShape::scalar, symmetric_tensor = FieldShape::symmetric_tensor,
               full_tensor = FieldShape::full_tensor;

constexpr std::array stress_rows{
    point_row(
        "stress", symmetric_tensor, [](const E& e) { return components_of_symmetric(e.stress()); },
        "Cauchy stress along the global axes [force/length^2]"),
    point_row(
        "unrotated_stress", symmetric_tensor,
        [](const E& e) { return components_of_symmetric(unrotated_stress(e)); },
        "R^T stress R with the rotation R of the mean deformation gradient [force/length^2]"),
    point_row(
        "von_mises", scalar, [](const E& e) { return von_mises_stress(e.stress()); },
        "Of the stress (the mean of the integration points) [force/length^2]"),
    point_row(
        "hydrostatic_stress", scalar, [](const E& e) { return e.stress().trace() / 3.0; },
        "A third of the trace of the stress, > 0 in tension [force/length^2]"),
    point_row(
        "fluid_pressure", scalar, [](const E& e) { return -e.stress().trace() / 3.0; },
        "-hydrostatic_stress, > 0 in compression [force/length^2]"),
    point_row(
        "max_principal_stress", scalar, [](const E& e) { return principal_values(e.stress())[0]; },
        "[force/length^2]"),
    point_row(
        "intermediate_principal_stress", scalar, [](const E& e) { return principal_values(e.stress())[1]; },
        "[force/length^2]"),
    point_row(
        "min_principal_stress", scalar, [](const E& e) { return principal_values(e.stress())[2]; },
        "[force/length^2]"),
    point_row(
        "principal_stresses", FieldShape::list, [](const E& e) { return principal_values(e.stress()); },
        "All three, the greatest first [force/length^2]"),
    point_row(
        "first_pk_stress", full_tensor, [](const E& e) { return components_of(first_pk_stress(e)); },
        "First Piola-Kirchhoff stress of the mean deformation gradient: force by undeformed area, rows in "
        "space [force/length^2]"),
};

constexpr std::array strain_rows{
    make_row(
        "log_strain", symmetric_tensor, [](const E& e) { return components_of_symmetric(e.log_strain()); },
        "ln V of the mean deformation gradient F = V R: in space, as the stress [1]"),
    make_row(
        "effective_log_strain", scalar, [](const E& e) { return effective_strain(e.log_strain()); },
        "sqrt(2/3 e:e) of its deviator e [1]"),
    make_row(
        "max_principal_log_strain", scalar, [](const E& e) { return principal_values(e.log_strain())[0]; },
        "[1]"),
    make_row(
        "intermediate_principal_log_strain", scalar,
        [](const E& e) { return principal_values(e.log_strain())[1]; }, "[1]"),
    make_row(
        "min_principal_log_strain", scalar, [](const E& e) { return principal_values(e.log_strain())[2]; },
        "[1]"),
    make_row(
        "max_shear_log_strain", scalar,
        [](const E& e) { return max_shear(principal_values(e.log_strain())); },
        "Half the difference of the greatest and the least principal log strain [1]"),
    make_row(
        "green_lagrange_strain", symmetric_tensor,
        [](const E& e) { return components_of_symmetric(green_lagrange_strain(e.deformation_gradient())); },
        "(F^T F - 1) / 2 of the mean deformation gradient [1]"),
    make_row(
        "deformation_gradient", full_tensor,
        [](const E& e) { return components_of(e.deformation_gradient()); },
        "Mean over the element, from the mesh to now [1]"),
    make_row(
        "rate_of_deformation", symmetric_tensor,
        [](const E& e) { return components_of_symmetric(e.rate_of_deformation()); },
        "Symmetric part of the mean velocity gradient [1/time]"),
    make_row(
        "max_principal_rate_of_deformation", scalar,
        [](const E& e) { return principal_values(e.rate_of_deformation())[0]; }, "[1/time]"),
    make_row(
        "min_principal_rate_of_deformation", scalar,
        [](const E& e) { return principal_values(e.rate_of_deformation())[2]; }, "[1/time]"),
};

// The mean over the thickness.
Eigen::Matrix3d membrane_stress(const E& e) {
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  const auto& layers = e.block().shell.layers;
  for (std::size_t point = 0; point < layers.size(); ++point) {
    EntityRange at_point = e.range;
    at_point.point = point;
    sum += layers[point].weight * stress_of(e.context, at_point, e.i);
  }
  return sum;
}

constexpr OutputRow shells_only(OutputRow row) {
  row.is_of_shells = true;
  return row;
}

constexpr std::array shell_rows{
    shells_only(make_row(
        "element_thickness", scalar, [](const E& e) { return e.thickness(); }, "Of shells [length]")),
    shells_only(make_row(
        "memb_stress", symmetric_tensor,
        [](const E& e) { return components_of_symmetric(membrane_stress(e)); },
        "Mean of a shell's Cauchy stress over its thickness, along the global axes [force/length^2]")),
};

constexpr OutputRow cohesive_only(OutputRow row) {
  row.is_of_cohesive = true;
  return row;
}

/// Opening and sliding, or the tractions against them.
constexpr OutputRow two_modes(OutputRow row) {
  row.list_size = 2;
  return cohesive_only(row);
}

constexpr std::array cohesive_rows{
    two_modes(make_row(
        "cohesive_separation", FieldShape::list, [](const E& e) { return CohesiveValues(e).separation; },
        "Opening, less than 0 in compression, and sliding, means over the pairs of nodes [length]")),
    two_modes(make_row(
        "cohesive_traction", FieldShape::list, [](const E& e) { return CohesiveValues(e).traction; },
        "Against opening and against sliding, means over the pairs of nodes [force/length^2]")),
    cohesive_only(make_row(
        "cohesive_damage", scalar, [](const E& e) { return CohesiveValues(e).damage; },
        "Share of the stiffness that is lost, 1 when all has failed: of ELEMENT DEATH criteria [1]")),
    cohesive_only(make_row(
        "cohesive_dissipation", scalar, [](const E& e) { return CohesiveValues(e).dissipation; },
        "Work on the element that it does not give back [energy]")),
};

constexpr std::array other_rows{
    make_row(
        "volume", scalar, [](const E& e) { return e.volume(); }, "Of now [length^3]"),
    make_row(
        "centroid", FieldShape::vector,
        [](const E& e) { return Eigen::Vector3d(e.coordinates().rowwise().mean()); },
        "Mean of the nodes now [length]"),
    make_row(
        "element_mass", scalar, [](const E& e) { return e.mass(); }, "[mass]"),
    make_row(
        "strain_energy", scalar, [](const E& e) { return e.strain_energy(); },
        "Work of the material's stress so far, plastic work included [energy]"),
    make_row(
        "strain_energy_density", scalar,
        [](const E& e) {
          const bool has_volume = e.block().element->has_material();
          return has_volume ? e.strain_energy() * e.block().properties.density / e.mass() : 0.0;
        },
        "By undeformed volume, 0 of springs and dampers [energy/length^3]"),
    make_row(
        "death_status", scalar, [](const E& e) { return e.life(); },
        "1 of an element that lives, 0 of a dead one, the share of its forces that is left while it dies "
        "[1]"),
    make_row(
        "processor_id", scalar, [](const E&) { return 0.0; }, "0: there is one process [1]"),
};

template <class... Rows>
constexpr auto joined(const Rows&... rows) {
  std::array<OutputRow, (std::tuple_size_v<Rows> + ...)> all{};
  std::size_t n = 0;
  ((std::copy(rows.begin(), rows.end(), all.begin() + n), n += rows.size()), ...);
  return all;
}

}  // namespace

std::span<const OutputRow> element_output_rows() {
  static constexpr auto rows = joined(stress_rows, strain_rows, shell_rows, cohesive_rows, other_rows);
  return rows;
}

}  // namespace contactsim
