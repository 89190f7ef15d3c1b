// SPDX-License-Identifier: BSD-3-Clause
// Random meshes through the Exodus reader and what follows it, in this process: see
// tests/campaigns/README.md.
#include <netcdf.h>
#include <omp.h>

#include <array>
#include <fstream>
#include <iterator>

#include "campaigns/meshes/byte_mutator.hpp"
#include "campaigns/meshes/mesh_harm.hpp"
#include "campaigns/meshes/mesh_mutator.hpp"
#include "campaigns/meshes/mesh_seeds.hpp"
#include "campaigns/support/campaign_cases.hpp"
#include "support/temporary_directory.hpp"

namespace contactsim::test {

namespace {

// HDF5 takes several times as long as the classic formats.
constexpr std::array<int, 8> formats{0,
                                     0,
                                     NC_64BIT_OFFSET,
                                     NC_64BIT_OFFSET,
                                     NC_64BIT_DATA,
                                     NC_64BIT_DATA,
                                     NC_NETCDF4,
                                     NC_NETCDF4 | NC_CLASSIC_MODEL};

class MeshCases : public CampaignCases {
 public:
  explicit MeshCases(const CampaignOptions& options)
      : seed_(options.seed), seeds_(make_mesh_seeds(options.source, scratch_.path())) {}

  std::string run(std::uint64_t number) override {
    const std::string path = scratch_.file("case.g");
    write_case(number, path);
    return find_mesh_harm(path, scratch_.path());
  }

  std::string replay(const std::filesystem::path& file) override {
    return find_mesh_harm(file.string(), scratch_.path());
  }

  void keep(std::uint64_t number, const std::filesystem::path& folder) override {
    write_case(number, (folder / "mesh.g").string());
  }

 private:
  /// Two of three cases are whole files of odd content, one is a file with odd bytes.
  void write_case(std::uint64_t number, const std::string& path) const {
    CaseRandom random("meshes", seed_, number);
    NetcdfModel model = random.pick(seeds_);
    const bool has_odd_bytes = random.once_in(3);
    std::size_t n_changes = random.once_in(2) ? 1 : 1 + random.below(4);
    if (has_odd_bytes && !random.once_in(4)) n_changes = 0;
    for (std::size_t n = n_changes; n > 0; --n) mutate_model(model, random);
    std::filesystem::remove(path);
    write_netcdf_model(path, model, random.pick(formats));
    if (!has_odd_bytes) return;
    std::string bytes = read_bytes(path);
    mutate_bytes(bytes, random);
    std::ofstream(path, std::ios::binary | std::ios::trunc) << bytes;
  }

  std::uint64_t seed_;
  TemporaryDirectory scratch_;
  std::vector<NetcdfModel> seeds_;
};

}  // namespace

}  // namespace contactsim::test

int main(int argc, char** argv) {
  using namespace contactsim::test;
  omp_set_num_threads(1);
  // Files of cases live in memory where they can.
  std::error_code ignored;
  if (std::filesystem::is_directory("/dev/shm", ignored)) setenv("TMPDIR", "/dev/shm", 0);
  CaseLimits limits;
  limits.seconds = 5.0;
  limits.seconds_sanitized = 30.0;
  limits.cases_per_process = 1000;
  return run_campaign_program<MeshCases>("meshes", argc, argv, limits);
}
