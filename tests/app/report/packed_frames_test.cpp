// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/packed_frames.hpp"

#include <cmath>
#include <random>

#include "support/catch.hpp"
#include "support/mesh_builder.hpp"
#include "support/unpacked_numbers.hpp"

using namespace contactsim;
using namespace contactsim::test;

namespace {

/// A plate that waves, with noise, and a field on nodes that some do not have.
struct Waves {
  explicit Waves(std::size_t n_times, double amplitude = 0.2) {
    MeshBuilder builder;
    builder.add_hexes({.id = 1, .cells = {20, 20, 1}, .size = {1, 1, 0.1}});
    mesh = builder.build();
    geometry = make_report_geometry(mesh, std::nullopt, {});
    fields.displacement = [this, amplitude](std::size_t time) { return moved(time, amplitude); };
    fields.fields.push_back({"p", "p", true, [this](std::size_t time) {
                               std::vector<double> values(mesh.n_nodes());
                               for (std::uint32_t i = 0; i < values.size(); ++i)
                                 values[i] =
                                     i == 3 ? NAN : mesh.coordinates()(0, i) + static_cast<double>(time);
                               return values;
                             }});
    n = n_times;
  }

  Eigen::Matrix3Xd moved(std::size_t time, double amplitude) const {
    std::mt19937 random(static_cast<unsigned>(time));
    std::uniform_real_distribution<double> noise(-0.01, 0.01);
    Eigen::Matrix3Xd u = mesh.coordinates();
    for (Eigen::Index i = 0; i < u.size(); ++i)
      u.data()[i] = amplitude * (std::sin(3.0 * u.data()[i] + static_cast<double>(time)) + noise(random));
    return u;
  }

  FrameInput input() const { return {mesh, geometry, fields, n}; }

  Mesh mesh;
  ReportGeometry geometry;
  ReportFields fields;
  std::size_t n = 0;
};

}  // namespace

TEST_CASE("with room enough all times are packed, and are right to what a screen shows", "[app][report]") {
  const double amplitude = GENERATE(0.2, 1e-6, 50.0);
  const Waves waves(9, amplitude);
  const PackedFrames packed = pack_frames(waves.input(), 10'000'000);
  CHECK(packed.chosen == std::vector<std::size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8});
  const std::size_t n_points = waves.geometry.nodes.size();
  const auto codes = unpack_numbers(packed.displacement, 3 * n_points, true);
  REQUIRE(codes.size() == 9 * 3 * n_points);
  const double size = std::sqrt(2.01), largest = amplitude * 1.01;
  const double allowed = std::min(size / 16384.0, largest / 2048.0);
  double worst = 0.0;
  for (std::size_t time = 0; time < 9; ++time) {
    const Eigen::Matrix3Xd u = waves.moved(time, amplitude);
    for (std::size_t i = 0; i < 3 * n_points; ++i) {
      const double value =
          u(static_cast<Eigen::Index>(i / n_points), waves.geometry.nodes[i % n_points].value);
      const double shown = packed.displacement_step * static_cast<double>(codes[time * 3 * n_points + i]);
      worst = std::max(worst, std::abs(shown - value));
    }
  }
  CHECK(worst <= 1.001 * allowed + 1e-7 * largest);  // values pass through 32 bits
}

TEST_CASE("a field has its least and largest value exactly, and no value where there is none",
          "[app][report]") {
  const Waves waves(2);
  const PackedField field = pack_frames(waves.input(), 10'000'000).fields.front();
  CHECK(field.scale.first == 0.0);
  CHECK(field.highest == 2.0);
  const auto codes = unpack_numbers(field.numbers, waves.geometry.nodes.size(), true);
  REQUIRE(codes.size() == 2 * waves.geometry.nodes.size());
  for (std::size_t i = 0; i < waves.geometry.nodes.size(); ++i) {
    const NodeIndex node = waves.geometry.nodes[i];
    const double shown = field.scale.first + field.scale.step * static_cast<double>(codes[i] - 1);
    if (node.value == 3) {
      CHECK(codes[i] == 0);
    } else {
      CHECK(shown == Approx(waves.mesh.coordinates()(0, node.value)).margin(2.0 / 4094.0));
    }
  }
}

TEST_CASE("one value that passes all others by far does not hide them", "[app][report]") {
  Waves waves(2);
  waves.fields.fields.front().read = [&](std::size_t) {
    std::vector<double> values(waves.mesh.n_nodes());
    for (std::uint32_t i = 0; i < values.size(); ++i) values[i] = waves.mesh.coordinates()(0, i);
    values[0] = 1e9;
    return values;
  };
  const PackedField field = pack_frames(waves.input(), 10'000'000).fields.front();
  CHECK(field.highest == 1e9);
  const auto codes = unpack_numbers(field.numbers, waves.geometry.nodes.size(), true);
  for (std::size_t i = 0; i < waves.geometry.nodes.size(); ++i) {
    const NodeIndex node = waves.geometry.nodes[i];
    const double bent = field.scale.first + field.scale.step * static_cast<double>(codes[i] - 1);
    const double value = node.value == 0 ? 1e9 : waves.mesh.coordinates()(0, node.value);
    CHECK(field.scale.linear_part * std::sinh(bent) == Approx(value).epsilon(0.01).margin(0.001));
  }
}

TEST_CASE("with little room there are fewer times, first and last always", "[app][report]") {
  const Waves waves(100);
  const std::size_t all = pack_frames(waves.input(), 100'000'000).bytes();
  const PackedFrames packed = pack_frames(waves.input(), all / 3);
  CHECK(packed.bytes() <= all / 3);
  CHECK(packed.chosen.size() >= 20);
  CHECK(packed.chosen.front() == 0);
  CHECK(packed.chosen.back() == 99);
  CHECK(pack_frames(waves.input(), 10).chosen == std::vector<std::size_t>{0, 99});
}

TEST_CASE("results of one time or of none are packed too", "[app][report]") {
  CHECK(pack_frames(Waves(1).input(), 1'000'000).chosen == std::vector<std::size_t>{0});
  CHECK(pack_frames(Waves(0).input(), 1'000'000).chosen.empty());
}
