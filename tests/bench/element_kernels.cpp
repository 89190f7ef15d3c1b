// SPDX-License-Identifier: BSD-3-Clause
#include <memory>

#include "element_scenes.hpp"
#include "kernel.hpp"

namespace contactsim::bench {

namespace {

template <class Scene, class... Arguments>
Kernel make_kernel(Arguments&&... arguments) {
  const auto scene = std::make_shared<Scene>(std::forward<Arguments>(arguments)...);
  return {static_cast<double>(scene->mesh().n_elements()), scene->n_bytes(), {}, [scene] { scene->step(); }};
}

Kernel whole_step(std::size_t n) { return make_kernel<WholeStepScene>(static_cast<std::uint32_t>(n)); }

template <auto make_mesh, auto make_law>
Kernel solids(std::size_t n, const char* formulation) {
  return make_kernel<SolidScene>(make_mesh(static_cast<std::uint32_t>(n)), formulation, make_law());
}

Mesh hex_cube(std::uint32_t n) { return make_hex_cube(n); }

template <auto make_law>
Kernel hexahedra(std::size_t n) {
  return solids<hex_cube, make_law>(n, "mean_quadrature");
}

template <auto make_law>
Kernel selective_hexahedra(std::size_t n) {
  return solids<hex_cube, make_law>(n, "selective_deviatoric");
}

template <auto make_law>
Kernel tetrahedra(std::size_t n) {
  return solids<make_tet_cube, make_law>(n, "mean_quadrature");
}

template <auto make_law, int n_layers>
Kernel shells(std::size_t n) {
  return make_kernel<ShellScene>(static_cast<std::uint32_t>(n), make_law(), n_layers);
}

constexpr KernelRow rows[] = {
    {"whole_step", "element", Reference::flops, 64, 8, whole_step},
    {"hex8_elastic", "element", Reference::flops, 64, 8, hexahedra<elastic_law>},
    {"hex8_plastic", "element", Reference::flops, 64, 8, hexahedra<elastic_plastic_law>},
    {"hex8_selective", "element", Reference::flops, 64, 8, selective_hexahedra<elastic_law>},
    {"hex8_johnson_cook", "element", Reference::flops, 64, 8, hexahedra<johnson_cook_law>},
    {"tet4_elastic", "element", Reference::flops, 40, 4, tetrahedra<elastic_law>},
    {"shells_plastic_5", "element", Reference::flops, 512, 16, shells<elastic_plastic_law, 5>},
};

}  // namespace

std::span<const KernelRow> element_kernels() { return rows; }

}  // namespace contactsim::bench
