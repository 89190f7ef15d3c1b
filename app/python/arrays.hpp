// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <span>
#include <vector>

#include "io/exodus/file_order.hpp"

namespace contactsim {

/// A copy of columns of three as an array of rows, [n, 3].
inline pybind11::array_t<double> rows_of(const Eigen::Matrix3Xd& columns) {
  return pybind11::array_t<double>({columns.cols(), Eigen::Index{3}}, columns.data());
}

/// The same of values at the nodes of a mesh, in the order of its file.
inline pybind11::array_t<double> rows_of(const Mesh& mesh, const Eigen::Matrix3Xd& columns) {
  const std::span values(columns.data(), static_cast<std::size_t>(columns.size()));
  const std::vector<double> rows = FileOrder::of_nodes(mesh).to_file(values, 3, 0, 3);
  return pybind11::array_t<double>({columns.cols(), Eigen::Index{3}}, rows.data());
}

/// A copy of a list as an array.
template <class T>
pybind11::array_t<T> array_of(const std::vector<T>& values) {
  return pybind11::array_t<T>(static_cast<pybind11::ssize_t>(values.size()), values.data());
}

/// A copy of rows that follow each other, [n, n_columns].
template <class T>
pybind11::array_t<T> table_of(const std::vector<T>& values, std::size_t n_columns) {
  return pybind11::array_t<T>({values.size() / n_columns, n_columns}, values.data());
}

}  // namespace contactsim
