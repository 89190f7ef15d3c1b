// SPDX-License-Identifier: BSD-3-Clause
#include "core/parallel/load_ranks.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <charconv>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <vector>

#include "core/base/errors.hpp"

namespace contactsim {

namespace {

constexpr const char* library_name = "libcontactsim_mpi.so";

std::filesystem::path find_library() {
  std::error_code none;
  const std::filesystem::path folder = std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
  // In a build; installed in bin; installed in libexec/contactsim, for a level of the processor.
  for (const char* place : {".", "../lib/contactsim", "../lib/x86_64-linux-gnu/contactsim",
                            "../../lib/contactsim", "../../lib/x86_64-linux-gnu/contactsim"}) {
    if (const auto path = folder / place / library_name; std::filesystem::exists(path, none)) return path;
  }
  return {};
}

}  // namespace

int n_started_processes() {
  // Of Open MPI; MPICH and Intel MPI; Slurm where it starts MPI programs itself, by PMIx of tasks that it
  // counts.
  std::vector<const char*> names{"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_SIZE"};
  if (std::getenv("PMIX_RANK") != nullptr) names.push_back("SLURM_STEP_NUM_TASKS");
  for (const char* name : names) {
    const char* value = std::getenv(name);
    int n = 0;
    if (value == nullptr) continue;
    if (std::from_chars(value, value + std::strlen(value), n).ec == std::errc() && n > 0) return n;
  }
  return 1;
}

std::unique_ptr<Ranks> load_ranks() {
  const int n = n_started_processes();
  if (n == 1) return nullptr;
  const std::filesystem::path path = find_library();
  if (path.empty()) {
    throw FileError(library_name,
                    fmt::format("is not beside the program: it is started on {} ranks, but was built without "
                                "MPI (CONTACTSIM_MPI), or the package contactsim-mpi is not installed",
                                n));
  }
  // MPI loads plugins that look for its own symbols.
  void* library = dlopen(path.c_str(), RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) throw FileError(path, fmt::format("cannot be loaded: {}", dlerror()));
  const auto join = reinterpret_cast<JoinRanks>(dlsym(library, join_ranks_function));
  if (join == nullptr) throw FileError(path, "is not the MPI library of this program");
  return std::unique_ptr<Ranks>(join());
}

}  // namespace contactsim
