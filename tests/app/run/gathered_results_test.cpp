// SPDX-License-Identifier: BSD-3-Clause
#include "app/run/gathered_results.hpp"

#include <atomic>

#include "core/base/errors.hpp"
#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/thread_ranks.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

OutputField field(const char* name, FieldLocation location, int n_components, std::uint32_t block = 0) {
  OutputField made;
  made.name = name;
  made.location = location;
  made.n_components = n_components;
  made.block = block;
  return made;
}

/// Twelve hexahedra in two blocks, that ranks have in no order, and a last one that was added to them.
struct DividedBar {
  DividedBar()
      : mesh(MeshBuilder()
                 .add_hexes({.id = 1, .cells = {7, 1, 1}, .size = {7, 1, 1}})
                 .add_hexes({.id = 2, .cells = {6, 1, 1}, .origin = {7, 0, 0}, .size = {6, 1, 1}})
                 .build()) {}

  /// A number for each value.
  static double value(std::size_t field, std::size_t entity, std::size_t component) {
    return 1e4 * static_cast<double>(field) + 10.0 * static_cast<double>(entity) +
           static_cast<double>(component);
  }
  std::vector<double> whole(std::size_t f) const {
    const OutputField& of = fields[f];
    const std::size_t n = of.location == FieldLocation::global ? 1
                          : of.location == FieldLocation::node ? mesh.n_nodes()
                                                               : mesh.blocks()[of.block].n_elements;
    std::vector<double> values;
    for (std::size_t e = 0; e < n; ++e) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(of.n_components); ++c)
        values.push_back(value(f, e, c));
    }
    return values;
  }
  std::vector<double> part(std::size_t f, const MeshPiece& piece) const {
    const OutputField& of = fields[f];
    if (of.location == FieldLocation::global) return whole(f);
    std::vector<double> values;
    for (const std::uint32_t e :
         of.location == FieldLocation::node ? piece.nodes : piece.elements[of.block]) {
      for (std::size_t c = 0; c < static_cast<std::size_t>(of.n_components); ++c)
        values.push_back(value(f, e, c));
    }
    return values;
  }
  ResultsPieces pieces(Ranks& ranks) const { return {ranks, {0, 2, 1, 0, 2, 2, 1, 1, 0, 0, 2, 1}}; }

  Mesh mesh;
  std::vector<OutputField> fields{
      field("velocity", FieldLocation::node, 3), field("energy", FieldLocation::global, 1),
      field("stress", FieldLocation::element, 6, 0), field("eqps", FieldLocation::element, 1, 1)};
};

}  // namespace

TEST_CASE("rank 0 writes the values of all ranks", "[app][outputs]") {
  const DividedBar bar;
  std::vector<double> times;
  std::atomic<int> n_right = 0, n_opened = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    const auto open = [&] {
      ++n_opened;
      return OutputWriters::OpenResults{[&](double time, const OutputWriters::FieldValues& values) {
        times.push_back(time);
        for (std::size_t f = 0; f < bar.fields.size(); ++f) {
          const std::span<const double> got = values(f);
          n_right += std::vector<double>(got.begin(), got.end()) == bar.whole(f) ? 1 : 0;
        }
      }};
    };
    const auto opened = open_gathered_results(bar.pieces(ranks), bar.mesh, bar.fields, open);
    std::vector<double> own;
    for (const double time : {0.0, 1.5}) {
      opened.append(time, [&](std::size_t f) {
        own = bar.part(f, *opened.piece);
        return std::span<const double>(own);
      });
    }
  });
  CHECK(n_opened == 1);
  CHECK(times == std::vector<double>{0.0, 1.5});
  CHECK(n_right == 8);
}

TEST_CASE("what rank 0 cannot write ends all ranks, before and within a state", "[app][outputs]") {
  const DividedBar bar;
  std::atomic<int> n_refused = 0, n_failed = 0;
  ThreadRanks(3).run([&](Ranks& ranks) {
    const auto refuse = []() -> OutputWriters::OpenResults { throw FileError("r.e", "no folder"); };
    try {
      open_gathered_results(bar.pieces(ranks), bar.mesh, bar.fields, refuse);
    } catch (const FileError&) {
      ++n_refused;
    }
    const auto open = [] {
      return OutputWriters::OpenResults{[](double, const OutputWriters::FieldValues& values) {
        values(0);
        throw FileError("r.e", "no space left");
      }};
    };
    const auto opened = open_gathered_results(bar.pieces(ranks), bar.mesh, bar.fields, open);
    std::vector<double> own;
    try {
      opened.append(0.0, [&](std::size_t f) {
        own = bar.part(f, *opened.piece);
        return std::span<const double>(own);
      });
    } catch (const FileError&) {
      ++n_failed;
    }
  });
  CHECK(n_refused == 3);
  CHECK(n_failed == 3);
}
