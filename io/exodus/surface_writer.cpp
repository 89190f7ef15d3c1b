// SPDX-License-Identifier: BSD-3-Clause
#include "io/exodus/surface_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "core/base/errors.hpp"
#include "core/base/version.hpp"
#include "io/exodus/exodus_conventions.hpp"
#include "io/netcdf/netcdf_output.hpp"

namespace contactsim {

namespace {

constexpr std::size_t shortest_name = 32;

/// How a block is written.
struct ElementType {
  const char* name = "";
  std::size_t n_nodes = 0;
};

ElementType find_type(const FacetBlock& block) {
  if (!block.edges.empty()) return {"BAR2", 2};
  if (block.facets.empty()) return {"SPHERE", 1};
  const auto is_triangle = [](const auto& facet) { return facet[2] == facet[3]; };
  const bool all = std::all_of(block.facets.begin(), block.facets.end(), is_triangle);
  return all ? ElementType{"SHELL3", 3} : ElementType{"SHELL4", 4};
}

std::size_t count_elements(const FacetBlock& block) {
  assert(block.facets.empty() || block.points.empty());
  assert(block.edges.empty() || (block.facets.empty() && block.points.empty()));
  return block.facets.size() + block.points.size() + block.edges.size();
}

std::vector<std::int32_t> make_connectivity(const FacetBlock& block, std::size_t n_nodes) {
  std::vector<std::int32_t> numbers;
  numbers.reserve(count_elements(block) * n_nodes);
  for (const auto& facet : block.facets) {
    for (std::size_t i = 0; i < n_nodes; ++i) numbers.push_back(static_cast<std::int32_t>(facet[i]) + 1);
  }
  for (const auto& edge : block.edges) {
    for (const std::uint32_t end : edge) numbers.push_back(static_cast<std::int32_t>(end) + 1);
  }
  for (std::uint32_t point : block.points) numbers.push_back(static_cast<std::int32_t>(point) + 1);
  return numbers;
}

bool needs_large_file(const FacetMesh& mesh) {
  const auto n_nodes = static_cast<std::size_t>(mesh.coordinates.cols());
  const auto is_large = [](const FacetBlock& block) {
    return count_elements(block) > NetcdfOutput::largest_plain_variable / (4 * sizeof(std::int32_t));
  };
  return n_nodes > NetcdfOutput::largest_plain_variable / sizeof(double) ||
         std::any_of(mesh.blocks.begin(), mesh.blocks.end(), is_large);
}

/// Defines and then fills the variables of one surface file.
class SurfaceFile {
 public:
  SurfaceFile(const std::string& path, const FacetMesh& mesh, const std::string& title)
      : mesh_(mesh), title_(title.substr(0, exodus_title_length)), file_(path, needs_large_file(mesh)) {
    for (const FacetBlock& block : mesh_.blocks) name_length_ = std::max(name_length_, block.name.size());
  }

  void write() {
    define_globals();
    define_coordinates();
    define_blocks();
    file_.end_definitions();
    write_coordinates();
    write_blocks();
    file_.commit();
  }

 private:
  void define_globals();
  void define_coordinates();
  void define_blocks();
  void write_coordinates();
  void write_blocks();

  const FacetMesh& mesh_;
  std::string title_;
  NetcdfOutput file_;
  std::size_t name_length_ = shortest_name;
  int name_dimension_ = 0, ids_ = 0, status_ = 0, names_ = 0, records_ = 0, axis_names_ = 0;
  std::vector<int> axes_, connectivity_;  // variables; connectivity of the blocks that have elements
};

void SurfaceFile::define_globals() {
  constexpr int global = NetcdfOutput::global;
  // 8.03 is the first version that knows maximum_name_length and the 64-bit status; nothing newer is used.
  file_.set_number(global, "api_version", NetcdfType::float32, 8.03);
  file_.set_number(global, "version", NetcdfType::float32, 8.03);
  file_.set_number(global, "floating_point_word_size", NetcdfType::int32, 8);
  file_.set_number(global, "file_size", NetcdfType::int32, 1);
  file_.set_number(global, "maximum_name_length", NetcdfType::int32, static_cast<double>(name_length_));
  file_.set_number(global, "int64_status", NetcdfType::int32, 0);
  file_.set_text(global, "title", title_);

  const int strings = file_.define_dimension("len_string", exodus_string_length);
  file_.define_dimension("len_line", exodus_line_length);
  const int four = file_.define_dimension("four", 4);
  name_dimension_ = file_.define_dimension("len_name", name_length_ + 1);
  const int steps = file_.define_dimension("time_step", NetcdfOutput::unlimited);
  file_.define_variable("time_whole", NetcdfType::float64, {steps});
  const int n_records = file_.define_dimension("num_qa_rec", 1);
  records_ = file_.define_variable("qa_records", NetcdfType::text, {n_records, four, strings});
}

void SurfaceFile::define_coordinates() {
  const int n_axes = file_.define_dimension("num_dim", 3);
  axis_names_ = file_.define_variable("coor_names", NetcdfType::text, {n_axes, name_dimension_});
  // A dimension of length 0 would be the record dimension.
  if (mesh_.coordinates.cols() == 0) return;
  const int n_nodes = file_.define_dimension("num_nodes", static_cast<std::size_t>(mesh_.coordinates.cols()));
  for (const char* axis : {"coordx", "coordy", "coordz"}) {
    axes_.push_back(file_.define_variable(axis, NetcdfType::float64, {n_nodes}));
  }
}

void SurfaceFile::define_blocks() {
  std::size_t n_elements = 0;
  for (const FacetBlock& block : mesh_.blocks) n_elements += count_elements(block);
  if (n_elements > 0) file_.define_dimension("num_elem", n_elements);
  if (mesh_.blocks.empty()) return;
  const int n_blocks = file_.define_dimension("num_el_blk", mesh_.blocks.size());
  status_ = file_.define_variable("eb_status", NetcdfType::int32, {n_blocks});
  ids_ = file_.define_variable("eb_prop1", NetcdfType::int32, {n_blocks});
  file_.set_text(ids_, "name", "ID");
  names_ = file_.define_variable("eb_names", NetcdfType::text, {n_blocks, name_dimension_});
  for (std::size_t b = 0; b < mesh_.blocks.size(); ++b) {
    const std::size_t n = count_elements(mesh_.blocks[b]);
    if (n == 0) continue;
    const ElementType type = find_type(mesh_.blocks[b]);
    const int rows = file_.define_dimension(fmt::format("num_el_in_blk{}", b + 1), n);
    const int columns = file_.define_dimension(fmt::format("num_nod_per_el{}", b + 1), type.n_nodes);
    connectivity_.push_back(
        file_.define_variable(fmt::format("connect{}", b + 1), NetcdfType::int32, {rows, columns}));
    file_.set_text(connectivity_.back(), "elem_type", type.name);
  }
}

void SurfaceFile::write_coordinates() {
  // Without date and time, so that the same surfaces give the same bytes.
  file_.write(records_, exodus_string_length, {"contactsim", version, "", ""});
  file_.write(axis_names_, name_length_ + 1, {"x", "y", "z"});
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    const Eigen::VectorXd values = mesh_.coordinates.row(static_cast<Eigen::Index>(axis));
    file_.write(axes_[axis], std::span<const double>(values.data(), static_cast<std::size_t>(values.size())));
  }
}

void SurfaceFile::write_blocks() {
  if (mesh_.blocks.empty()) return;
  std::vector<std::int32_t> ids, status;
  std::vector<std::string> names;
  auto variable = connectivity_.begin();
  for (const FacetBlock& block : mesh_.blocks) {
    ids.push_back(static_cast<std::int32_t>(ids.size()) + 1);
    status.push_back(count_elements(block) > 0 ? 1 : 0);
    names.push_back(block.name);
    if (count_elements(block) > 0)
      file_.write(*variable++, make_connectivity(block, find_type(block).n_nodes));
  }
  file_.write(ids_, ids);
  file_.write(status_, status);
  file_.write(names_, name_length_ + 1, names);
}

}  // namespace

void write_facet_mesh(const std::string& path, const FacetMesh& mesh, const std::string& title) {
  const auto n_nodes = static_cast<std::size_t>(mesh.coordinates.cols());
  if (n_nodes > static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    throw FileError(path, fmt::format("cannot hold {} nodes", n_nodes));
  }
  SurfaceFile(path, mesh, title).write();
}

}  // namespace contactsim
