// SPDX-License-Identifier: BSD-3-Clause
#include <filesystem>

#include "core/mesh/mesh_piece.hpp"
#include "io/decompose/join_file.hpp"
#include "io/decompose/split_file.hpp"
#include "io/exodus/sample_mesh.hpp"
#include "io/exodus/sample_results.hpp"
#include "io/pieces/exodus_file.hpp"
#include "support/catch.hpp"
#include "support/temporary_directory.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// Those of a field's values that a piece has.
std::vector<double> values_of(const MeshPiece& piece, const OutputField& field, std::span<const double> all) {
  if (field.location == FieldLocation::global) return {all.begin(), all.end()};
  const auto n = static_cast<std::size_t>(field.n_components);
  std::vector<double> values;
  for (const std::uint32_t i :
       field.location == FieldLocation::node ? piece.nodes : piece.elements[field.block])
    values.insert(values.end(), all.begin() + static_cast<std::ptrdiff_t>(i * n),
                  all.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
  return values;
}

}  // namespace

TEST_CASE("pieces that are written each by itself are the whole, as far as all have come",
          "[io][decompose]") {
  const TemporaryDirectory directory;
  const std::string path = directory.file("r.e");
  SampleResults results(sample_mesh().build());
  const Mesh& mesh = results.mesh();
  const std::vector<OutputField> fields = results.fields();
  { const ResultsWriter without_steps(path, mesh, {"title", {}, {"deck"}}, fields); }
  // The second piece has nothing.
  std::vector<std::uint32_t> piece_of;
  for (std::uint32_t e = 0; e < mesh.n_elements(); ++e) piece_of.push_back(e * 5 % 3 == 0 ? 2 : 0);
  const PieceFiles files = name_pieces(path, 3);
  split_file(path, files, piece_of);
  std::filesystem::remove(path);
  for (std::uint32_t number = 0; number < 3; ++number) {
    const MeshPiece piece = find_piece(mesh, piece_of, number);
    ResultsWriter writer(files.path(number), piece, mesh, fields);
    const int n_steps = number == 2 ? 2 : 3;
    for (int step = 0; step < n_steps; ++step) {
      results.set_step(step);
      std::vector<double> values;
      writer.write_step(step, [&](std::size_t field) -> std::span<const double> {
        values = values_of(piece, fields[field], results.values()(field));
        return values;
      });
    }
    CHECK(writer.n_steps() == static_cast<std::size_t>(n_steps));
    CHECK_THROWS_AS(writer.write_step(9.0, results.values()), std::logic_error);
  }
  const JoinedFile joined = join_file(files.path(0), directory.file("j.e"));
  CHECK(joined.n_steps == 2);
  CHECK(joined.n_elements == mesh.n_elements());
  const NetcdfFile file(directory.file("j.e"));
  results.set_step(0);
  CHECK(results.is_step(file, 0));
  results.set_step(1);
  CHECK(results.is_step(file, 1));
}
