// SPDX-License-Identifier: BSD-3-Clause
// The library is loaded when a run asks for it, so that others start as fast as without, and is no condition
// of a build: its header alone is.
#include "core/base/errors.hpp"
#include "core/parallel/ranks.hpp"
#include "core/statics/sparse_factor.hpp"

#if __has_include(<dmumps_c.h>)

#include <dlfcn.h>
#include <dmumps_c.h>
#include <fmt/format.h>

#include <cstdlib>
#include <exception>
#include <new>
#include <span>
#include <string>
#include <vector>

#include "core/base/memory_error.hpp"

namespace contactsim {

namespace {

/// What is called of a library.
struct Mumps {
  void (*call)(DMUMPS_STRUC_C*) = nullptr;  ///< null where it is not installed
  void (*reset_random)() = nullptr;  ///< of Scotch, which orders equations for it; null where another does
  void (*find_mpi)(int*) = nullptr;  ///< MPI_Initialized of the MPI that it works by; null without any
};

/// OpenBLAS asks for its buffers for ever where there is no room for them: it is made to ask for them where
/// there is. Throws std::bad_alloc where there is none.
void allocate_buffers(void* library) {
  using Solve = void (*)(const char*, const char*, const char*, const char*, const int*, const int*,
                         const double*, const double*, const int*, double*, const int*);
  const auto solve = reinterpret_cast<Solve>(dlsym(library, "dtrsm_"));
  if (solve == nullptr) return;
  constexpr std::size_t bytes = std::size_t{144} << 20;  // a buffer has 128 MiB
  ::operator delete(::operator new(bytes));
  constexpr int n = 1;
  constexpr double one = 1.0;
  double solution = 1.0;
  solve("L", "L", "N", "N", &n, &n, &one, &one, &n, &solution, &n);
}

/// The file of a library of the version that the header is of.
///   name  libdmumps_seq, or libdmumps, which works by MPI
std::string file_of(const char* name) {
  const std::string version = MUMPS_VERSION;
  return fmt::format("{}-{}.so", name, version.substr(0, version.rfind('.')));
}

Mumps load_mumps(const char* name) {
  void* library = dlopen(file_of(name).c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return {};
  // Several threads of OpenBLAS would add in an order that depends on their number.
  if (void* set_threads = dlsym(library, "openblas_set_num_threads"))
    reinterpret_cast<void (*)(int)>(set_threads)(1);
  // Those of Scotch would order equations as it happens, from some ten thousand on: other bits on every run.
  ::setenv("SCOTCH_PTHREAD_NUMBER", "1", 1);
  allocate_buffers(library);
  return {reinterpret_cast<void (*)(DMUMPS_STRUC_C*)>(dlsym(library, "dmumps_c")),
          reinterpret_cast<void (*)()>(dlsym(library, "SCOTCH_randomReset")),
          reinterpret_cast<void (*)(int*)>(dlsym(library, "MPI_Initialized"))};
}

const Mumps& find_mumps() {
  static const Mumps found = load_mumps("libdmumps_seq");
  return found;
}

/// That which works by MPI. Throws FileError.
const Mumps& find_mumps_of_ranks() {
  constexpr const char* name = "libdmumps";
  static const Mumps found = load_mumps(name);
  if (found.call == nullptr)
    throw FileError(file_of(name),
                    "cannot be loaded: LINEAR SOLVER = DISTRIBUTED needs it (Debian: libmumps-5.5)");
  int has_begun = 0;
  if (found.find_mpi != nullptr) found.find_mpi(&has_begun);
  if (has_begun == 0)
    throw FileError(file_of(name),
                    "works by another MPI than the program: LINEAR SOLVER = DISTRIBUTED needs the same");
  return found;
}

/// Jobs and settings by the names of the manual, 5.2 and 6.
enum Job { end = -2, begin = -1, analyse_and_factorise = 4, substitute = 3 };
constexpr int fortran_world = -987654, no_memory = -13;

class MumpsFactor final : public SparseFactor {
 public:
  MumpsFactor(const Mumps& mumps, bool is_symmetric, Ranks& ranks)
      : mumps_(mumps), is_symmetric_(is_symmetric), ranks_(ranks) {
    data_.par = 1;
    data_.sym = is_symmetric ? 2 : 0;
    data_.comm_fortran = fortran_world;
    run(begin);
    for (const int stream : {1, 2, 3, 4}) set(stream, 0);  // prints nothing
    set(14, 60);                          // percent of memory beyond what the analysis asks for
    if (ranks.are_several()) set(18, 3);  // each rank gives a part of the entries
  }
  /// A rank that stops by itself does not wait for the others here.
  ~MumpsFactor() override {
    if (!ranks_.are_several() || std::uncaught_exceptions() == 0) run(end);
  }
  MumpsFactor(const MumpsFactor&) = delete;
  MumpsFactor& operator=(const MumpsFactor&) = delete;

  bool factorise(const Matrix& matrix) override {
    take_entries(matrix);
    // Random numbers that went on from one factor to the next would give a run that is resumed other bits.
    if (mumps_.reset_random != nullptr) mumps_.reset_random();
    const bool is_done = run(analyse_and_factorise);
    if (data_.infog[0] == no_memory) throw MemoryError(fmt::format("factorising {} equations", data_.n));
    return is_done;
  }

  Eigen::VectorXd solve(const Eigen::VectorXd& right) const override {
    Eigen::VectorXd solution = right;
    data_.rhs = solution.data();  // of rank 0 alone
    run(substitute);
    if (ranks_.are_several())
      ranks_.broadcast(
          std::as_writable_bytes(std::span(solution.data(), static_cast<std::size_t>(solution.size()))));
    return solution;
  }

  std::int64_t n_negative() const override { return is_symmetric_ ? data_.infog[11] : 0; }
  std::optional<FactorMemory> memory() const override {
    return FactorMemory{data_.infog[20], data_.infog[21]};
  }

 private:
  void set(int control, int value) { data_.icntl[control - 1] = value; }
  bool run(Job job) const {
    data_.job = job;
    mumps_.call(&data_);
    return data_.infog[0] >= 0;
  }

  /// Of several ranks each takes an equal stretch of the columns.
  void take_entries(const Matrix& matrix) {
    rows_.clear();
    columns_.clear();
    values_.clear();
    const auto column_of = [&](int rank) { return matrix.outerSize() * rank / ranks_.count(); };
    const Eigen::Index last = column_of(ranks_.rank() + 1);
    for (Eigen::Index column = column_of(ranks_.rank()); column < last; ++column) {
      for (Matrix::InnerIterator entry(matrix, column); entry; ++entry) {
        rows_.push_back(static_cast<MUMPS_INT>(entry.row()) + 1);
        columns_.push_back(static_cast<MUMPS_INT>(column) + 1);
        values_.push_back(entry.value());
      }
    }
    data_.n = static_cast<MUMPS_INT>(matrix.rows());
    data_.nnz = data_.nnz_loc = static_cast<MUMPS_INT8>(values_.size());
    data_.irn = data_.irn_loc = rows_.data();
    data_.jcn = data_.jcn_loc = columns_.data();
    data_.a = data_.a_loc = values_.data();
  }

  const Mumps& mumps_;
  bool is_symmetric_;
  Ranks& ranks_;
  mutable DMUMPS_STRUC_C data_{};  // of which every call changes something
  std::vector<MUMPS_INT> rows_, columns_;
  std::vector<double> values_;
};

}  // namespace

bool has_mumps() { return find_mumps().call != nullptr; }

std::unique_ptr<SparseFactor> make_mumps_factor(bool is_symmetric) {
  return has_mumps() ? std::make_unique<MumpsFactor>(find_mumps(), is_symmetric, one_rank()) : nullptr;
}

std::unique_ptr<SparseFactor> make_distributed_factor(bool is_symmetric, Ranks& ranks) {
  return std::make_unique<MumpsFactor>(find_mumps_of_ranks(), is_symmetric, ranks);
}

}  // namespace contactsim

#else

namespace contactsim {

bool has_mumps() { return false; }
std::unique_ptr<SparseFactor> make_mumps_factor(bool /*is_symmetric*/) { return nullptr; }
std::unique_ptr<SparseFactor> make_distributed_factor(bool /*is_symmetric*/, Ranks& /*ranks*/) {
  throw FileError("dmumps_c.h",
                  "was not there when the program was built: LINEAR SOLVER = DISTRIBUTED needs it");
}

}  // namespace contactsim

#endif
