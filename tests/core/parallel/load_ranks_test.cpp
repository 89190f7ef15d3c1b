// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/load_ranks.hpp"

#include <cstdlib>

#include "core/base/errors.hpp"
#include "support/catch.hpp"

using namespace contactsim;

namespace {

/// A variable of the environment, as long as it lives.
class Variable {
 public:
  Variable(const char* name, const char* value) : name_(name) { setenv(name, value, 1); }
  ~Variable() { unsetenv(name_); }
  Variable(const Variable&) = delete;
  Variable& operator=(const Variable&) = delete;

 private:
  const char* name_;
};

}  // namespace

TEST_CASE("a program that nobody has started on several ranks is by itself", "[core][load_ranks]") {
  CHECK(n_started_processes() == 1);
  CHECK(load_ranks() == nullptr);
}

TEST_CASE("Open MPI and MPICH say how many processes they have started", "[core][load_ranks]") {
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE"}) {
    CHECK(n_started_processes() == 1);
    const Variable size(name, "12");
    CHECK(n_started_processes() == 12);
  }
  const Variable nonsense("PMI_SIZE", "many");
  CHECK(n_started_processes() == 1);
}

TEST_CASE("Slurm says how many tasks a step has, which are of one run where PMIx binds them",
          "[core][load_ranks]") {
  const Variable tasks("SLURM_STEP_NUM_TASKS", "6");
  CHECK(n_started_processes() == 1);
  const Variable rank("PMIX_RANK", "3");
  CHECK(n_started_processes() == 6);
}

TEST_CASE("several processes without the library of MPI beside the program are refused",
          "[core][load_ranks]") {
  const Variable size("OMPI_COMM_WORLD_SIZE", "2");
  CHECK_THROWS_AS(load_ranks(), FileError);  // the test program has none beside it
}
