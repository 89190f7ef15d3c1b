// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "campaigns/meshes/netcdf_model.hpp"

namespace contactsim::test {

/// The meshes that are mutated: some made here, of every shape, with sets, assemblies, number maps,
/// attributes and results, and a small one of the repository.
///   scratch  folder for files on the way
std::vector<NetcdfModel> make_mesh_seeds(const std::filesystem::path& repository,
                                         const std::filesystem::path& scratch);

}  // namespace contactsim::test
