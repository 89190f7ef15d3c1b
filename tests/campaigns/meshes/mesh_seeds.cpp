// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/mesh_seeds.hpp"

#include <netcdf.h>

#include <cmath>
#include <utility>

#include "support/exodus_file.hpp"
#include "support/mesh_builder.hpp"
#include "support/sample_sets.hpp"

namespace contactsim::test {

namespace {

/// Solids, shells, lines and particles with sets, assemblies, number maps and attributes.
Mesh mixed_mesh() {
  MeshBuilder builder;
  builder.add_hexes({.id = 10, .name = "lower", .cells = {2, 1, 1}})
      .add_tets({.id = 7, .name = "Upper Part", .cells = {1, 1, 1}, .origin = {0, 0, 1}})
      .add_block(99, "", Shape::null, {})
      .add_shells({.id = 3, .cells = {2, 1}, .origin = {0, 0, 3}})
      .set_attributes(3, {"thickness"}, {0.5, 0.25})
      .add_beams({.id = 4, .name = "rod", .cells = 2, .from = {0, 0, 4}, .to = {1, 0, 4}})
      .add_spheres(0, "dust", {{4, 0, 0}, {5, 0, 0}})
      .set_attributes(0, {"radius", "volume"}, {1.0, 2.0, 3.0, 4.0});
  return with_sample_sets(std::move(builder)).build();
}

Mesh stacked_mesh() {
  MeshBuilder builder;
  builder.add_hexes({.id = 1, .cells = {2, 2, 1}})
      .add_hexes({.id = 2,
                  .cells = {1, 1, 1},
                  .origin = {0.1, 0.1, 1.0},
                  .size = {0.8, 0.8, 0.5},
                  .share_nodes = false})
      .add_wedges({.id = 3, .origin = {2, 0, 0}})
      .add_pyramids({.id = 4, .origin = {4, 0, 0}})
      .add_ten_node_tets({.id = 5, .origin = {6, 0, 0}})
      .add_triangles({.id = 6, .origin = {8, 0, 0}});
  builder.add_side_set(1, "", [](const CandidateSide& face) { return face.centroid.z() == 1.0; })
      .add_node_set(1, "", [](const Eigen::Vector3d& x) { return x.z() == 0.0; });
  return builder.build();
}

/// An element of every shape, its nodes wherever.
Mesh mesh_of_all_shapes() {
  MeshBuilder builder;
  std::int64_t id = 1;
  for (int s = 0; s < static_cast<int>(Shape::null); ++s) {
    const auto shape = static_cast<Shape>(s);
    if (topology(shape).family == Family::cohesive) continue;
    std::vector<std::uint32_t> nodes;
    for (int n = 0; n < topology(shape).n_nodes; ++n) {
      const double t = 0.7 * n + 3.0 * s;
      nodes.push_back(builder.add_node({10.0 * s + std::cos(t), std::sin(1.7 * t), 0.1 * n}).value);
    }
    builder.add_block(id++, "", shape, nodes);
  }
  return builder.build();
}

std::size_t add_dimension(NetcdfModel& model, const std::string& name, std::size_t length) {
  model.dimensions.push_back({name, length, name == "time_step"});
  return model.dimensions.size() - 1;
}

std::size_t find_dimension(const NetcdfModel& model, const std::string& name) {
  for (std::size_t i = 0; i < model.dimensions.size(); ++i) {
    if (model.dimensions[i].name == name) return i;
  }
  return 0;
}

void add_texts(NetcdfModel& model, const std::string& name, const std::vector<std::size_t>& dimensions,
               std::size_t width, const std::vector<std::string>& texts) {
  std::string all;
  for (std::string text : texts) {
    text.resize(width, '\0');
    all += text;
  }
  model.arrays.push_back({name, dimensions, {}, {NC_CHAR, all, {}, {}}, false});
}

/// Results of two times and a QA record, as programs leave them in mesh files.
void add_results(NetcdfModel& model) {
  const std::size_t steps = add_dimension(model, "time_step", 2),
                    width = add_dimension(model, "len_line", 33);
  const std::size_t n_nodal = add_dimension(model, "num_nod_var", 3),
                    n_element = add_dimension(model, "num_elem_var", 1);
  const std::size_t nodes = find_dimension(model, "num_nodes"),
                    elements = find_dimension(model, "num_el_in_blk1");
  model.arrays.push_back({"time_whole", {steps}, {}, {NC_DOUBLE, {}, {}, {0.0, 1.0}}, false});
  add_texts(model, "name_nod_var", {n_nodal, width}, 33, {"displ_x", "displ_y", "displ_z"});
  add_texts(model, "name_elem_var", {n_element, width}, 33, {"eqps"});
  for (const char* number : {"1", "2", "3"}) {
    const std::vector<double> values(2 * model.dimensions[nodes].length, 0.25);
    model.arrays.push_back(
        {std::string("vals_nod_var") + number, {steps, nodes}, {}, {NC_DOUBLE, {}, {}, values}, false});
  }
  const std::vector<double> values(2 * model.dimensions[elements].length, 0.5);
  model.arrays.push_back({"vals_elem_var1eb1", {steps, elements}, {}, {NC_DOUBLE, {}, {}, values}, false});
  const std::size_t records = add_dimension(model, "num_qa_rec", 1), four = add_dimension(model, "four", 4);
  add_texts(model, "qa_records", {records, four, width}, 33, {"cubit", "16", "01/01/2024", "12:00:00"});
}

}  // namespace

std::vector<NetcdfModel> make_mesh_seeds(const std::filesystem::path& repository,
                                         const std::filesystem::path& scratch) {
  std::vector<NetcdfModel> seeds;
  const std::string path = (scratch / "seed.g").string();
  for (const Mesh& mesh : {mixed_mesh(), stacked_mesh(), mesh_of_all_shapes()}) {
    for (const bool is_combined : {false, true}) {
      write_exodus(
          path, mesh,
          {.format = FileFormat::cdf5, .wide_integers = is_combined, .combined_coordinates = is_combined});
      seeds.push_back(read_netcdf_model(path));
      add_results(seeds.back());
    }
  }
  seeds.push_back(read_netcdf_model((repository / "decks" / "two_blocks.g").string()));
  return seeds;
}

}  // namespace contactsim::test
