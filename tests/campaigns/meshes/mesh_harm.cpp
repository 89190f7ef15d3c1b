// SPDX-License-Identifier: BSD-3-Clause
#include "campaigns/meshes/mesh_harm.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "campaigns/meshes/mesh_invariants.hpp"
#include "campaigns/meshes/mesh_run.hpp"
#include "core/base/errors.hpp"
#include "core/mesh/element_checks.hpp"
#include "core/mesh/hanging_faces.hpp"
#include "core/mesh/mesh_digest.hpp"
#include "core/mesh/node_elements.hpp"
#include "core/mesh/omit_blocks.hpp"
#include "core/mesh/skin.hpp"
#include "io/exodus/exodus_reader.hpp"
#include "io/exodus/exodus_variables.hpp"
#include "io/exodus/qa_records.hpp"
#include "io/exodus/results_writer.hpp"
#include "support/slow_skin.hpp"

namespace contactsim::test {

namespace {

/// What a refusal lacks; a mesh of these sizes needs no great memory.
std::string harm_of_text(const std::string& text, bool is_one_line) {
  if (text.empty()) return "a problem has no text";
  if (text.find("not enough memory") != text.npos) return "wants too much memory: " + text;
  const auto is_control = [&](char c) {
    return (c >= 0 && c < 0x20 && (is_one_line || c != '\n')) || c == 0x7f;
  };
  if (std::any_of(text.begin(), text.end(), is_control)) return "a text has control characters: " + text;
  return "";
}

/// Does what may be refused; what is wrong with the refusal.
template <class Work>
std::string try_to(const Work& work) {
  try {
    return work();
  } catch (const FileError& error) {
    return harm_of_text(error.what(), false);
  } catch (const SolveError& error) {
    return harm_of_text(error.what(), false);
  } catch (const DeckError& error) {
    for (const Diagnostic& problem : error.diagnostics().all()) {
      if (std::string harm = harm_of_text(problem.text, true); !harm.empty()) return harm;
    }
    return error.diagnostics().has_errors() ? "" : "refuses without an error";
  }
}

std::string look_at_skin(const Mesh& mesh) {
  const std::vector<std::uint8_t> all(mesh.n_elements(), 1);
  const Skin skin = make_skin(mesh, all), slow = make_slow_skin(mesh, all);
  return skin.exterior == slow.exterior && skin.in_between == slow.in_between
             ? ""
             : "the skin is not that of the slow way";
}

std::string look_at_elements(const Mesh& mesh) {
  std::vector<std::uint32_t> blocks;
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) blocks.push_back(b);
  check_elements(mesh, blocks);
  return "";
}

std::string look_at_parts(const Mesh& mesh) {
  const NodeElements elements(mesh);
  digest_of(mesh);
  find_hanging_faces(mesh);
  for (std::uint32_t a = 0; a < mesh.assemblies().size(); ++a) {
    for (const Entity entity : mesh.members(a)) mesh.name(entity);
  }
  for (std::uint32_t b = 0; b < mesh.blocks().size(); ++b) {
    const std::string broken = find_broken_reference(without_blocks(mesh, std::vector{b}));
    if (!broken.empty()) return "without a block, " + broken;
  }
  return "";
}

std::string look_at_results(const Mesh& mesh) {
  const StoredVariables stored = read_stored_variables(mesh.path(), mesh);
  for (std::size_t t = 0; t < std::min<std::size_t>(stored.times.size(), 3); ++t) {
    for (std::size_t v = 0; v < std::min<std::size_t>(stored.nodal.names.size(), 9); ++v) {
      if (stored.nodal.read(v, t).size() != mesh.n_nodes()) return "stored values are not those of the nodes";
    }
    for (std::size_t v = 0; v < std::min<std::size_t>(stored.element.names.size(), 9); ++v) {
      if (stored.element.read(v, t).size() != mesh.n_elements())
        return "stored values are not those of the elements";
    }
  }
  return "";
}

/// The shape of a block that has elements: others are written without one.
Shape shape_of(const ElementBlock& block) { return block.n_elements > 0 ? block.shape : Shape::null; }

std::string find_difference(const Mesh& a, const Mesh& b) {
  if (a.coordinates() != b.coordinates()) return "coordinates";
  if (!std::ranges::equal(a.blocks(), b.blocks(), {}, shape_of, shape_of)) return "shapes";
  if (!std::ranges::equal(a.blocks(), b.blocks(), {}, &ElementBlock::nodes, &ElementBlock::nodes))
    return "nodes";
  if (!std::ranges::equal(a.node_sets(), b.node_sets(), {}, &NodeSet::nodes, &NodeSet::nodes))
    return "node sets";
  if (!std::ranges::equal(a.side_sets(), b.side_sets(), {}, &SideSet::sides, &SideSet::sides))
    return "side sets";
  return "";
}

std::string look_at_copy(const Mesh& mesh, const std::filesystem::path& scratch) {
  const std::string path = (scratch / "copy.e").string();
  const std::vector<OutputField> fields{{.name = "velocity", .shape = FieldShape::vector, .n_components = 3}};
  const std::vector<double> values(3 * mesh.n_nodes(), 1.0);
  {
    ResultsWriter writer(
        path, mesh, {.title = mesh.title(), .qa_records = read_qa_records(mesh.path()), .info = {}}, fields);
    writer.write_step(0.0, [&](std::size_t) { return std::span<const double>(values); });
  }
  Diagnostics warnings;
  const Mesh copy = read_mesh(path, warnings);
  const std::string difference = find_difference(mesh, copy);
  return difference.empty() ? "" : "what is written is not what was read: " + difference;
}

std::string look_at_mesh(const Mesh& mesh, const std::filesystem::path& scratch) {
  std::string harm = find_broken_reference(mesh);
  if (harm.empty()) harm = look_at_skin(mesh);
  if (harm.empty()) harm = look_at_parts(mesh);
  if (harm.empty()) harm = try_to([&] { return look_at_elements(mesh); });
  if (harm.empty()) harm = try_to([&] { return look_at_results(mesh); });
  if (harm.empty()) harm = try_to([&] { return look_at_copy(mesh, scratch); });
  if (harm.empty()) harm = try_to([&] { return run_mesh(mesh), std::string(); });
  return harm;
}

}  // namespace

std::string find_mesh_harm(const std::string& path, const std::filesystem::path& scratch) {
  Diagnostics warnings;
  std::optional<Mesh> mesh;
  try {
    mesh = read_mesh(path, warnings);
  } catch (const FileError& error) {
    const std::string text = error.what();
    return text.starts_with(path + ": ") ? harm_of_text(text, true)
                                         : "a refusal does not name the file: " + text;
  }
  for (const Diagnostic& warning : warnings.all()) {
    if (std::string harm = harm_of_text(warning.text, true); !harm.empty()) return harm;
  }
  return look_at_mesh(*mesh, scratch);
}

}  // namespace contactsim::test
