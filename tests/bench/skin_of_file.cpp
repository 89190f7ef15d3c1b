// SPDX-License-Identifier: BSD-3-Clause
// Times the skin of an Exodus mesh: contactsim_skin_of_file MESH [ROUNDS]. Writes the number of exterior
// faces and the least seconds of one thread for reading and for the skin alone.
#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "core/mesh/skin.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "machine_limits.hpp"

int main(int n, char** words) {
  using namespace contactsim;
  if (n < 2) return 2;
  omp_set_num_threads(1);
  const int n_rounds = n > 2 ? std::atoi(words[2]) : 5;
  Diagnostics warnings;
  const double begin = bench::thread_seconds();
  const Mesh mesh = read_mesh(words[1], warnings);
  const double reading = bench::thread_seconds() - begin;
  const std::vector<std::uint8_t> present(mesh.n_elements(), 1);
  double least = std::numeric_limits<double>::infinity();
  std::size_t n_faces = 0;
  for (int round = 0; round < n_rounds; ++round) {
    const double start = bench::thread_seconds();
    const Skin skin = make_skin(mesh, present);
    least = std::min(least, bench::thread_seconds() - start);
    n_faces = skin.exterior.size();
  }
  fmt::print("skin faces {} read {:.5g} seconds {:.5g}\n", n_faces, reading, least);
  return 0;
}
