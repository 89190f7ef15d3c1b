// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

/// Strains and stresses of one element, and how tensors are laid out on files.
namespace contactsim {

/// Eigenvalues of a symmetric tensor, the greatest first.
Eigen::Vector3d principal_values(const Eigen::Matrix3d& a);

/// Logarithm of the left stretch, ln V with F = V R: in space, as the Cauchy stress is. Precondition: det F >
/// 0.
Eigen::Matrix3d log_strain(const Eigen::Matrix3d& f);

/// (F^T F - 1) / 2: in the undeformed body.
Eigen::Matrix3d green_lagrange_strain(const Eigen::Matrix3d& f);

/// The rotation R of F = R U. Precondition: det F > 0.
Eigen::Matrix3d rotation_of(const Eigen::Matrix3d& f);

/// The tensor less a third of its trace on the diagonal.
Eigen::Matrix3d deviator(const Eigen::Matrix3d& a);

/// sqrt(3/2 s:s) of the deviator s of a stress.
double von_mises_stress(const Eigen::Matrix3d& stress);

/// sqrt(2/3 e:e) of the deviator e of a strain.
double effective_strain(const Eigen::Matrix3d& strain);

/// A symmetric tensor from and to the order xx yy zz xy yz zx.
Eigen::Matrix3d symmetric(std::span<const double, 6> components);
std::array<double, 6> components_of_symmetric(const Eigen::Matrix3d& a);

/// Any tensor to the order xx yy zz xy yz zx yx zy xz.
std::array<double, 9> components_of(const Eigen::Matrix3d& a);

}  // namespace contactsim
