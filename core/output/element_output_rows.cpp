// SPDX-License-Identifier: BSD-3-Clause
#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <tuple>

#include "core/elements/element_table.hpp"
#include "core/output/element_geometry.hpp"
#include "core/output/output_table.hpp"
#include "core/output/strain_measures.hpp"

namespace contactsim {

namespace {

using Values = std::span<double>;

// One element and what its variables are made of.
struct ElementMoment {
  const OutputMoment& moment;
  const EntityRange& range;
  std::size_t i;  // element range.first + i

  const SolidBlock& block() const { return moment.model.blocks[range.block]; }
  const ElementBlock& mesh_block() const { return moment.model.mesh->blocks()[block().mesh_block]; }
  std::size_t element() const { return range.first + i; }
  const Topology& shape() const { return topology(mesh_block().shape); }

  ElementVectors gathered(const Eigen::Matrix3Xd& values) const {
    return gather(mesh_block().element_nodes(static_cast<std::uint32_t>(element())), values);
  }
  ElementVectors coordinates() const { return gathered(moment.state.coordinates); }
  double of_lane(const std::vector<Lanes>& numbers) const {
    return numbers[element() / n_lanes](static_cast<Eigen::Index>(element() % n_lanes));
  }
  double mass() const { return of_lane(block().mass); }
  double strain_energy() const {
    return moment.state.blocks[range.block].at(block().layout, element(), block().layout.energy());
  }
  Eigen::Matrix3d stress() const { return stress_of(moment, range, i); }

  // Mean of the gradient, by the mesh's coordinates, of the motion from the mesh to now.
  Eigen::Matrix3d deformation_gradient() const {
    const ElementVectors start = gathered(moment.model.mesh->coordinates());
    if (shape().family == Family::shell) return shell_deformation_gradient(start);
    const ElementVectors gradient = volume_gradient(shape(), start);
    return coordinates() * gradient.transpose() / solid_volume(start, gradient);
  }
  // Of the surface; its thickness stays.
  Eigen::Matrix3d shell_deformation_gradient(const ElementVectors& start) const {
    const ElementVectors now = coordinates();
    return now * surface_gradient(shape(), start).transpose() +
           surface_normal(shape(), now) * surface_normal(shape(), start).transpose();
  }
  Eigen::Matrix3d log_strain() const { return contactsim::log_strain(deformation_gradient()); }
  Eigen::Matrix3d rate_of_deformation() const {
    const ElementVectors x = coordinates();
    if (shape().family == Family::shell) {
      const Eigen::Vector3d normal = surface_normal(shape(), x);
      const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - normal * normal.transpose();
      const Eigen::Matrix3d l =
          along * gathered(moment.state.velocity) * surface_gradient(shape(), x).transpose();
      return 0.5 * (l + l.transpose());
    }
    const ElementVectors gradient = volume_gradient(shape(), x);
    const Eigen::Matrix3d l =
        gathered(moment.state.velocity) * gradient.transpose() / solid_volume(x, gradient);
    return 0.5 * (l + l.transpose());
  }
  double thickness() const { return of_lane(block().thickness); }
  double volume() const {
    const ElementVectors x = coordinates();
    if (shape().family == Family::shell) return surface_area(shape(), x) * thickness();
    return solid_volume(x, volume_gradient(shape(), x));
  }
};

void put(double value, double* to) { *to = value; }
void put(const Eigen::Vector3d& value, double* to) { Eigen::Map<Eigen::Vector3d>{to} = value; }
template <std::size_t n>
void put(const std::array<double, n>& value, double* to) {
  std::copy(value.begin(), value.end(), to);
}

// Fills a range with value(element), a number, vector or array. It is a type, so that a row needs no object.
template <class Value>
void fill_range(const OutputMoment& moment, const EntityRange& range, Values values) {
  const std::size_t n_components = values.size() / range.count;
  for (std::size_t i = 0; i < range.count; ++i)
    put(Value{}(ElementMoment{moment, range, i}), values.data() + i * n_components);
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

using E = ElementMoment;

Eigen::Matrix3d unrotated_stress(const E& e) {
  const Eigen::Matrix3d rotation = rotation_of(e.deformation_gradient());
  return rotation.transpose() * e.stress() * rotation;
}

Eigen::Matrix3d first_pk_stress(const E& e) {
  const Eigen::Matrix3d f = e.deformation_gradient();
  return f.determinant() * e.stress() * f.inverse().transpose();
}

double max_shear(const Eigen::Vector3d& principal) { return 0.5 * (principal[0] - principal[2]); }

constexpr auto scalar = FieldShape::scalar, vector = FieldShape::vector, list = FieldShape::list,
               symmetric_tensor = FieldShape::symmetric_tensor, full_tensor = FieldShape::full_tensor;

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
        "principal_stresses", list, [](const E& e) { return principal_values(e.stress()); },
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
    sum += layers[point].weight * stress_of(e.moment, at_point, e.i);
  }
  return sum;
}

constexpr OutputRow of_shells(OutputRow row) {
  row.is_of_shells = true;
  return row;
}

constexpr std::array shell_rows{
    of_shells(make_row(
        "element_thickness", scalar, [](const E& e) { return e.thickness(); }, "Of shells [length]")),
    of_shells(make_row(
        "memb_stress", symmetric_tensor,
        [](const E& e) { return components_of_symmetric(membrane_stress(e)); },
        "Mean of a shell's Cauchy stress over its thickness, along the global axes [force/length^2]")),
};

constexpr std::array other_rows{
    make_row(
        "volume", scalar, [](const E& e) { return e.volume(); }, "Of now [length^3]"),
    make_row(
        "centroid", vector, [](const E& e) { return Eigen::Vector3d(e.coordinates().rowwise().mean()); },
        "Mean of the nodes now [length]"),
    make_row(
        "element_mass", scalar, [](const E& e) { return e.mass(); }, "[mass]"),
    make_row(
        "strain_energy", scalar, [](const E& e) { return e.strain_energy(); },
        "Work of the material's stress so far, plastic work included [energy]"),
    make_row(
        "strain_energy_density", scalar,
        [](const E& e) { return e.strain_energy() * e.block().properties.density / e.mass(); },
        "By undeformed volume [energy/length^3]"),
    make_row(
        "death_status", scalar, [](const E&) { return 1.0; }, "1 of an element that lives [1]"),
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

// The mean of a number over the range's integration points.
template <class Value>
double point_mean(const EntityRange& range, std::size_t n_points, Value value) {
  if (range.point) return value(*range.point);
  double sum = 0.0;
  for (std::size_t p = 0; p < n_points; ++p) sum += value(p);
  return sum / static_cast<double>(n_points);
}

double state_value(const OutputMoment& moment, const EntityRange& range, std::size_t i, std::size_t place) {
  const StateLayout& layout = moment.model.blocks[range.block].layout;
  return point_mean(range, layout.n_points, [&](std::size_t point) {
    return moment.state.blocks[range.block].at(layout, range.first + i, point * layout.point_size + place);
  });
}

constexpr std::size_t n_stresses = 6;

// A tensor of the state along the global axes. Elements with a frame of their own keep it along that.
Eigen::Matrix3d tensor_of(const OutputMoment& moment, const EntityRange& range, std::size_t i,
                          std::size_t place) {
  std::array<double, 6> components{};
  for (std::size_t c = 0; c < 6; ++c) components[c] = state_value(moment, range, i, place + c);
  const Eigen::Matrix3d tensor = symmetric(components);
  const SolidBlock& block = moment.model.blocks[range.block];
  if (block.element->frame == nullptr) return tensor;
  const Eigen::Matrix3d frame = block.element->frame(ElementMoment{moment, range, i}.coordinates());
  return frame.transpose() * tensor * frame;
}

}  // namespace

Eigen::Matrix3d stress_of(const OutputMoment& moment, const EntityRange& range, std::size_t i) {
  return tensor_of(moment, range, i, 0);
}

double material_value(const OutputMoment& moment, const EntityRange& range, std::size_t i,
                      std::size_t place) {
  return state_value(moment, range, i, n_stresses + place);
}

Eigen::Matrix3d material_tensor(const OutputMoment& moment, const EntityRange& range, std::size_t i,
                                std::size_t place) {
  return tensor_of(moment, range, i, n_stresses + place);
}

std::span<const OutputRow> element_output_rows() {
  static constexpr auto rows = joined(stress_rows, strain_rows, shell_rows, other_rows);
  return rows;
}

}  // namespace contactsim
