// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>

#include "core/parallel/ranks.hpp"

namespace contactsim {

/// What the library of MPI's ranks offers under the name join_ranks_function: starts MPI; to be deleted at
/// the end of the process.
using JoinRanks = Ranks* (*)();
constexpr const char* join_ranks_function = "contactsim_join_mpi";

/// How many processes mpirun, srun or mpiexec has started for this run, as its environment says; 1 when
/// nothing has.
int n_started_processes();

/// Joins the other processes of the run: null when there is none. Throws FileError when there are but the
/// library of MPI, which stands beside the program or in ../lib/contactsim, cannot be loaded.
std::unique_ptr<Ranks> load_ranks();

}  // namespace contactsim
