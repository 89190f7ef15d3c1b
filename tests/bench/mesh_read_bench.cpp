// SPDX-License-Identifier: BSD-3-Clause
// Reading a mesh of 100 x 100 x 100 hexes, beside plain netCDF reads of the same arrays. Both take fresh
// memory from the system in every round, as a run that reads one mesh does; a round that finds its memory in
// the process measures the cache in place of the reader.
#include <benchmark/benchmark.h>
#include <malloc.h>
#include <netcdf.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/mesh/element_checks.hpp"
#include "io/exodus/exodus_reader.hpp"

namespace {

constexpr int n_cells = 100, n_side = n_cells + 1;
constexpr std::size_t n_nodes = std::size_t{n_side} * n_side * n_side;
constexpr std::size_t n_elements = std::size_t{n_cells} * n_cells * n_cells;

void check(int status) {
  if (status == NC_NOERR) return;
  std::fprintf(stderr, "%s\n", nc_strerror(status));
  std::abort();
}

std::vector<int> make_connectivity() {
  std::vector<int> nodes;
  nodes.reserve(8 * n_elements);
  for (int k = 0; k < n_cells; ++k) {
    for (int j = 0; j < n_cells; ++j) {
      for (int i = 0; i < n_cells; ++i) {
        const int a = 1 + i + n_side * (j + n_side * k), b = a + n_side * n_side;
        nodes.insert(nodes.end(),
                     {a, a + 1, a + n_side + 1, a + n_side, b, b + 1, b + n_side + 1, b + n_side});
      }
    }
  }
  return nodes;
}

std::vector<double> make_axis(int axis) {
  std::vector<double> values;
  values.reserve(n_nodes);
  for (int n = 0; n < static_cast<int>(n_nodes); ++n) {
    const int at[] = {n % n_side, n / n_side % n_side, n / (n_side * n_side)};
    values.push_back(0.01 * at[axis]);
  }
  return values;
}

void write_cube(const std::string& path, int mode) {
  int file = 0, dim = 0, nodes = 0, elements = 0, columns = 0, blocks = 0, ids = 0, connect = 0, coord[3];
  check(nc_create(path.c_str(), NC_CLOBBER | mode, &file));
  check(nc_def_dim(file, "num_dim", 3, &dim));
  check(nc_def_dim(file, "num_nodes", n_nodes, &nodes));
  check(nc_def_dim(file, "num_elem", n_elements, &elements));
  check(nc_def_dim(file, "num_el_blk", 1, &blocks));
  check(nc_def_dim(file, "num_el_in_blk1", n_elements, &elements));
  check(nc_def_dim(file, "num_nod_per_el1", 8, &columns));
  const float version = 8.25F;
  check(nc_put_att_float(file, NC_GLOBAL, "version", NC_FLOAT, 1, &version));
  check(nc_def_var(file, "eb_prop1", NC_INT, 1, &blocks, &ids));
  const int shape[] = {elements, columns};
  check(nc_def_var(file, "connect1", NC_INT, 2, shape, &connect));
  check(nc_put_att_text(file, connect, "elem_type", 4, "HEX8"));
  const char* names[] = {"coordx", "coordy", "coordz"};
  for (int axis = 0; axis < 3; ++axis)
    check(nc_def_var(file, names[axis], NC_DOUBLE, 1, &nodes, &coord[axis]));
  check(nc_enddef(file));
  const int id = 1;
  check(nc_put_var_int(file, ids, &id));
  check(nc_put_var_int(file, connect, make_connectivity().data()));
  for (int axis = 0; axis < 3; ++axis) check(nc_put_var_double(file, coord[axis], make_axis(axis).data()));
  check(nc_close(file));
}

/// The cube in both formats, in a directory that goes away with the program.
class CubeFiles {
 public:
  CubeFiles() {
    mallopt(M_MMAP_THRESHOLD, 1 << 18);
    std::string name = (std::filesystem::temp_directory_path() / "contactsim_bench_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) std::abort();
    directory_ = name;
    write_cube(path(0), NC_64BIT_OFFSET);
    write_cube(path(1), NC_NETCDF4);
  }
  ~CubeFiles() { std::filesystem::remove_all(directory_); }
  CubeFiles(const CubeFiles&) = delete;
  CubeFiles& operator=(const CubeFiles&) = delete;

  /// Format 0 is CDF-2, 1 is netCDF-4.
  std::string path(std::int64_t format) const {
    return (directory_ / (format == 0 ? "cdf2.g" : "netcdf4.g")).string();
  }

 private:
  std::filesystem::path directory_;
};

const CubeFiles& cube_files() {
  static const CubeFiles files;
  return files;
}

void plain_netcdf(benchmark::State& state) {
  const std::string path = cube_files().path(state.range(0));
  for (auto _ : state) {
    int file = 0, variable = 0;
    check(nc_open(path.c_str(), NC_NOWRITE, &file));
    std::unique_ptr<double[]> axes[3];
    for (int axis = 0; axis < 3; ++axis) {
      axes[axis].reset(new double[n_nodes]);
      check(nc_inq_varid(file, axis == 0 ? "coordx" : axis == 1 ? "coordy" : "coordz", &variable));
      check(nc_get_var_double(file, variable, axes[axis].get()));
    }
    const std::unique_ptr<int[]> nodes(new int[8 * n_elements]);
    check(nc_inq_varid(file, "connect1", &variable));
    check(nc_get_var_int(file, variable, nodes.get()));
    check(nc_close(file));
    benchmark::DoNotOptimize(nodes.get());
  }
}

void read_mesh(benchmark::State& state) {
  const std::string path = cube_files().path(state.range(0));
  for (auto _ : state) {
    contactsim::Diagnostics warnings;
    const contactsim::Mesh mesh = contactsim::read_mesh(path, warnings);
    benchmark::DoNotOptimize(mesh.n_nodes());
  }
}

void check_all_elements(benchmark::State& state) {
  contactsim::Diagnostics warnings;
  const contactsim::Mesh mesh = contactsim::read_mesh(cube_files().path(0), warnings);
  const std::uint32_t blocks[] = {0};
  for (auto _ : state) contactsim::check_elements(mesh, blocks);
}

}  // namespace

BENCHMARK(plain_netcdf)->ArgName("netcdf4")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(read_mesh)->ArgName("netcdf4")->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond)->UseRealTime();
BENCHMARK(check_all_elements)->Unit(benchmark::kMillisecond)->UseRealTime();
