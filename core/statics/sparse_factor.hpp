// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/SparseCore>
#include <cstdint>
#include <memory>
#include <optional>

namespace contactsim {

class Ranks;

/// The memory that a factor takes, as its library counts it [10^6 bytes].
struct FactorMemory {
  std::int64_t largest = 0;  ///< on the rank that has most of it
  std::int64_t all = 0;      ///< on all ranks
};

/// A factor of a sparse matrix, by which equations are solved. The same bits for any number of threads.
class SparseFactor {
 public:
  using Matrix = Eigen::SparseMatrix<double>;

  virtual ~SparseFactor() = default;
  /// Returns false when there is no factor: the matrix is singular.
  ///   matrix  whole, or the lower half of a symmetric one
  virtual bool factorise(const Matrix& matrix) = 0;
  /// The solution of matrix x = right. Precondition: the last factorise() was true.
  virtual Eigen::VectorXd solve(const Eigen::VectorXd& right) const = 0;
  /// Negative pivots of a symmetric matrix: as many directions have a negative stiffness.
  virtual std::int64_t n_negative() const = 0;
  /// Of the last factorise(); absent where the library does not tell.
  virtual std::optional<FactorMemory> memory() const { return std::nullopt; }
};

/// The factor of the library MUMPS, which is loaded when first asked for, else Eigen's, which is ten times
/// slower from some thousand unknowns on.
std::unique_ptr<SparseFactor> make_sparse_factor(bool is_symmetric);

/// Whether make_sparse_factor() makes that of MUMPS.
bool has_mumps();

/// Eigen's factor.
std::unique_ptr<SparseFactor> make_eigen_factor(bool is_symmetric);

/// MUMPS' factor, null where the library cannot be loaded. Source: MUMPS 5.5 Users' guide.
std::unique_ptr<SparseFactor> make_mumps_factor(bool is_symmetric);

/// MUMPS' factor that ranks make together, each with a part of it; all call its functions alike, with the
/// same numbers, and get the same solution. Its last bits differ from run to run, since parts are added up as
/// they arrive. Throws FileError where its library cannot be loaded, or works by another MPI than the ranks.
///   ranks  must outlive it
std::unique_ptr<SparseFactor> make_distributed_factor(bool is_symmetric, Ranks& ranks);

}  // namespace contactsim
