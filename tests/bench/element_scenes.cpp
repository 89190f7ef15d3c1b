// SPDX-License-Identifier: BSD-3-Clause
#include "element_scenes.hpp"

#include <cmath>

#include "core/elements/element_table.hpp"
#include "core/elements/elements.hpp"
#include "core/materials/elastic.hpp"
#include "core/materials/johnson_cook.hpp"
#include "core/materials/linear_hardening.hpp"
#include "core/materials/power_hardening.hpp"
#include "kernel.hpp"

namespace contactsim::bench {

MaterialLaw elastic_law() { return ElasticLaw{steel}; }
MaterialLaw elastic_plastic_law() { return PlasticLaw<LinearHardening>{steel, {200e6, 1e7, 0.0}}; }
MaterialLaw ep_power_hard_law() { return PlasticLaw<PowerHardening>{steel, {200e6, 500e6, 0.3, 0.001}}; }
MaterialLaw johnson_cook_law() {
  return PlasticLaw<JohnsonCookHardening>{steel, {{200e6, 500e6, 0.3}, 0.015, 1.0}};
}

void MovedElements::begin(ModelBlock block) {
  model_.blocks.push_back(std::move(block));
  state_ = make_state(mesh_.coordinates(), model_.blocks, 0.0);
  internal_.emplace(model_, state_);
  x_ = mesh_.coordinates();
  v_.resizeLike(x_);
  forces_.resizeLike(x_);
}

double MovedElements::n_bytes_with(double n_arrays) const {
  return bytes_of_forces(model_, state_) + n_arrays * sizeof(double) * static_cast<double>(x_.size());
}

SolidScene::SolidScene(Mesh mesh, const char* formulation, const MaterialLaw& law)
    : MovedElements(std::move(mesh)) {
  const ElementFormulation& row = *find_solid_element(mesh_.blocks()[0].shape, formulation);
  begin(make_solid_block(mesh_, 0, row, ElementProperties{law, 7800.0}));
  for (Eigen::Index i = 0; i < x_.cols(); ++i)
    v_.col(i) = Eigen::Vector3d(std::sin(0.3 * x_(1, i)), 0.0, 0.0) * 2500.0;
}

void SolidScene::step() {
  x_ += dt * v_;
  stable_step_ = internal_->set_forces({0.0, dt, x_, v_}, forces_).stable_step;
  v_ = -v_;
}

ShellScene::ShellScene(std::uint32_t n, const MaterialLaw& law, std::int64_t n_layers)
    : MovedElements(make_shell_sheet(n)) {
  ShellSettings settings;
  settings.layers = make_layers("gauss", n_layers);
  const std::vector<double> thickness(mesh_.n_elements(), 0.1);
  begin(make_shell_block(mesh_, 0, shell4_bt_shell, ElementProperties{law, 7800.0}, settings, thickness));
  for (auto* values : {&w_, &moments_}) values->resizeLike(x_);
  for (Eigen::Index i = 0; i < x_.cols(); ++i) {
    v_.col(i) = Eigen::Vector3d(std::sin(0.3 * x_(1, i)), 0.0, 0.1 * std::sin(0.2 * x_(0, i))) * 2500.0;
    w_.col(i) = Eigen::Vector3d(std::sin(0.3 * x_(1, i)), std::cos(0.2 * x_(0, i)), 0.0) * 100.0;
  }
}

void ShellScene::step() {
  x_ += dt * v_;
  Motion motion{0.0, dt, x_, v_};
  motion.angular_velocity = &w_;
  stable_step_ = internal_->set_forces(motion, forces_).stable_step;
  internal_->set_moments(motion, moments_);
  v_ = -v_;
  w_ = -w_;
}

TimeStepControl endless() { return {{TimePeriod{"all", 0.0, {}}}, 1e30}; }

WholeStepScene::WholeStepScene(std::uint32_t n) : mesh_(make_hex_cube(n)) {
  model_.mesh = &mesh_;
  model_.blocks.push_back(
      make_solid_block(mesh_, 0, hex8_mean_quadrature, ElementProperties{elastic_law(), 7800.0}));
  model_.mass = lumped_mass(mesh_, model_.blocks);
  state_ = make_state(mesh_.coordinates(), model_.blocks, 0.0);
  for (Eigen::Index i = 0; i < state_.velocity.cols(); ++i)
    state_.velocity(0, i) = 10.0 * std::sin(0.3 * mesh_.coordinates()(1, i));
  internal_.emplace(model_, state_);
  start(model_, {*internal_, none_}, control_, state_);
}

void WholeStepScene::step() { advance(model_, {*internal_, none_}, control_, state_); }

double WholeStepScene::n_bytes() const {
  return bytes_of_forces(model_, state_) + bytes_of_integration(state_);
}

}  // namespace contactsim::bench
