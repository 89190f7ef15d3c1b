// SPDX-License-Identifier: BSD-3-Clause
#include "core/output/element_view.hpp"

#include <Eigen/Geometry>
#include <array>

#include "core/elements/element_table.hpp"
#include "core/output/strain_measures.hpp"

namespace contactsim {

namespace {

constexpr std::size_t n_stresses = 6;

// The mean of a number over the range's integration points.
template <class Value>
double point_mean(const EntityRange& range, std::size_t n_points, Value value) {
  if (range.point) return value(*range.point);
  double sum = 0.0;
  for (std::size_t p = 0; p < n_points; ++p) sum += value(p);
  return sum / static_cast<double>(n_points);
}

double state_value(const OutputContext& context, const EntityRange& range, std::size_t i, std::size_t place) {
  const StateLayout& layout = context.model.blocks[range.block].layout;
  return point_mean(range, layout.n_points, [&](std::size_t point) {
    return context.state.blocks[range.block].at(layout, range.first + i, point * layout.point_size + place);
  });
}

// A tensor of the state along the global axes.
Eigen::Matrix3d tensor_of(const OutputContext& context, const EntityRange& range, std::size_t i,
                          std::size_t place) {
  std::array<double, 6> components{};
  for (std::size_t c = 0; c < 6; ++c) components[c] = state_value(context, range, i, place + c);
  const Eigen::Matrix3d tensor = symmetric(components);
  const ElementView element{context, range, i};
  if (element.shape().family == Family::solid) return tensor;
  const Eigen::Matrix3d frame = element.frame();
  return frame.transpose() * tensor * frame;
}

Eigen::Matrix3d stretch_of_line(const ElementVectors& start, const ElementVectors& now) {
  if (start.cols() < 2) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d before = start.col(1) - start.col(0), after = now.col(1) - now.col(0);
  const Eigen::Vector3d axis = before.normalized();
  const Eigen::Matrix3d stretch =
      Eigen::Matrix3d::Identity() + (after.norm() / before.norm() - 1.0) * axis * axis.transpose();
  return Eigen::Quaterniond::FromTwoVectors(before, after) * stretch;
}

Eigen::Matrix3d rate_of_line(const ElementVectors& x, const ElementVectors& v) {
  if (x.cols() < 2) return Eigen::Matrix3d::Zero();
  const Eigen::Vector3d way = x.col(1) - x.col(0), speed = v.col(1) - v.col(0);
  const double length_squared = way.squaredNorm();
  return way.dot(speed) / (length_squared * length_squared) * way * way.transpose();
}

}  // namespace

ElementVectors ElementView::gathered(const Eigen::Matrix3Xd& values) const {
  return gather(mesh_block().element_nodes(static_cast<std::uint32_t>(element())), values);
}

double ElementView::strain_energy() const {
  return context.state.blocks[range.block].at(block().layout, element(), block().layout.energy());
}

double ElementView::thickness_growth() const {
  return context.state.blocks[range.block].at(block().layout, element(), block().thickness_growth());
}

double ElementView::volume() const {
  const ElementVectors x = coordinates();
  if (shape().family == Family::shell) return surface_area(shape(), x) * thickness();
  if (!block().element->has_material()) return 0.0;
  if (shape().family != Family::solid) return mass() / block().properties.density;
  return solid_volume(x, volume_gradient(shape(), x));
}

Eigen::Matrix3d ElementView::deformation_gradient() const {
  if (shape().family == Family::cohesive) return Eigen::Matrix3d::Identity();
  const ElementVectors start = gathered(context.model.mesh->coordinates()), now = coordinates();
  if (shape().family == Family::shell) {
    return now * surface_gradient(shape(), start).transpose() +
           (1.0 + thickness_growth()) * surface_normal(shape(), now) *
               surface_normal(shape(), start).transpose();
  }
  if (shape().family != Family::solid) return stretch_of_line(start, now);
  const ElementVectors gradient = volume_gradient(shape(), start);
  return now * gradient.transpose() / solid_volume(start, gradient);
}

Eigen::Matrix3d ElementView::log_strain() const { return contactsim::log_strain(deformation_gradient()); }

Eigen::Matrix3d ElementView::rate_of_deformation() const {
  if (shape().family == Family::cohesive) return Eigen::Matrix3d::Zero();
  const ElementVectors x = coordinates(), v = gathered(context.state.velocity);
  Eigen::Matrix3d l;
  if (shape().family == Family::shell) {
    const Eigen::Vector3d normal = surface_normal(shape(), x);
    l = (v - normal * (normal.transpose() * v)) * surface_gradient(shape(), x).transpose();
  } else if (shape().family == Family::solid) {
    const ElementVectors gradient = volume_gradient(shape(), x);
    l = v * gradient.transpose() / solid_volume(x, gradient);
  } else {
    l = rate_of_line(x, v);
  }
  return 0.5 * (l + l.transpose());
}

Eigen::Matrix3d ElementView::frame() const {
  const ElementVectors x = coordinates();
  if (block().element->frame != nullptr) return block().element->frame(x);
  if (x.cols() != 2) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d axis = Eigen::Vector3d(x.col(1) - x.col(0)).normalized();
  Eigen::Vector3d t = axis.unitOrthogonal();  // a truss has no stress across it; beams keep their t axis
  const StateLayout& layout = block().layout;
  for (std::size_t k = 0; k < layout.n_own; ++k) {
    t(static_cast<Eigen::Index>(k)) =
        context.state.blocks[range.block].at(layout, element(), layout.energy() - layout.n_own + k);
  }
  Eigen::Matrix3d frame;
  frame << axis.transpose(), t.transpose(), axis.cross(t).transpose();
  return frame;
}

Eigen::Matrix3d stress_of(const OutputContext& context, const EntityRange& range, std::size_t i) {
  const double life = context.state.blocks[range.block].life_of(range.first + i);
  if (life == 0.0) return Eigen::Matrix3d::Zero();
  return life * tensor_of(context, range, i, 0);
}

double material_value(const OutputContext& context, const EntityRange& range, std::size_t i,
                      std::size_t place) {
  return state_value(context, range, i, n_stresses + place);
}

Eigen::Matrix3d material_tensor(const OutputContext& context, const EntityRange& range, std::size_t i,
                                std::size_t place) {
  return tensor_of(context, range, i, n_stresses + place);
}

}  // namespace contactsim
