// SPDX-License-Identifier: BSD-3-Clause
#include "app/report/report_json.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "app/report/packed_frames.hpp"
#include "app/report/packed_numbers.hpp"

namespace contactsim {

namespace {

using Json = nlohmann::ordered_json;

/// What a curve or a time shows.
Json rounded(double value) {
  if (!std::isfinite(value)) return nullptr;
  // std::stod throws at numbers too small to have all their digits.
  return std::strtod(fmt::format("{:.6g}", value).c_str(), nullptr);
}

Json rounded(const std::vector<double>& values) {
  Json list = Json::array();
  for (const double value : values) list.push_back(rounded(value));
  return list;
}

Json parsed_or_null(const std::string& text) {
  const Json json = Json::parse(text, nullptr, false);
  return json.is_discarded() ? Json(nullptr) : json;
}

Json deck_json(const ReportRun& run) {
  Json files = Json::array();
  for (const SourceFile& file : run.deck) files.push_back({{"name", file.name}, {"text", file.text}});
  return {{"expanded", run.is_deck_expanded},
          {"has_surface_lines", run.has_surface_lines},
          {"files", std::move(files)}};
}

Json place_json(const DeckLocation& location) {
  return {{"file", location.file->name}, {"line", location.line}, {"column", location.column}};
}

Json problems_json(const Diagnostics& found) {
  Json problems = Json::array();
  for (const DiagnosticGroup& group : found.grouped()) {
    const Diagnostic& first = group.first;
    Json places = Json::array();
    if (first.location.is_known()) places.push_back(place_json(first.location));
    for (const DeckLocation& other : group.others) {
      if (other.is_known()) places.push_back(place_json(other));
    }
    problems.push_back({{"severity", first.severity == Severity::error ? "error" : "warning"},
                        {"id", first.id},
                        {"text", first.text},
                        {"hint", first.hint},
                        {"places", std::move(places)},
                        {"alike", group.n_alike}});
  }
  return problems;
}

Json charts_json(const std::vector<CurveChart>& charts) {
  Json list = Json::array();
  for (const CurveChart& chart : charts) {
    Json curves = Json::array();
    for (const Curve& curve : chart.curves)
      curves.push_back({{"name", curve.name}, {"values", rounded(curve.values)}});
    list.push_back({{"title", chart.title},
                    {"source", chart.source},
                    {"dimension", chart.dimension},
                    {"times", rounded(chart.times)},
                    {"curves", std::move(curves)}});
  }
  return list;
}

/// Packs a number of each of some things.
template <class Things, class Value>
std::string pack_each(const Things& things, const Value& value) {
  std::vector<std::int64_t> numbers;
  numbers.reserve(things.size());
  for (const auto& thing : things) numbers.push_back(static_cast<std::int64_t>(value(thing)));
  return pack_numbers(numbers, std::max<std::size_t>(1, numbers.size()), false);
}

/// The n-th corner of all, then the next one: neighbours are alike.
template <class Things>
Json pack_corners(const Things& things, std::size_t n_corners) {
  Json lists = Json::array();
  for (std::size_t i = 0; i < n_corners; ++i)
    lists.push_back(pack_each(things, [i](const auto& thing) { return thing.points[i]; }));
  return lists;
}

/// Coordinates in 65536 steps of the box, a list for each axis.
Json coordinates_json(const ReportMesh& of) {
  Json axes = Json::array();
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const auto at = [&](NodeIndex node) { return of.mesh.coordinates()(axis, node.value); };
    double low = 0.0, high = 0.0;
    const auto& nodes = of.geometry.nodes;
    if (!nodes.empty()) {
      const auto [least, most] = std::ranges::minmax_element(nodes, {}, at);
      low = at(*least);
      high = at(*most);
    }
    const Quantiser scale(low, high, 65535.0);
    axes.push_back({{"first", scale.first},
                    {"step", scale.step},
                    {"numbers", pack_each(nodes, [&](NodeIndex node) { return scale.code(at(node)); })}});
  }
  return axes;
}

Json blocks_json(const Mesh& mesh, const std::vector<double>& radii) {
  Json blocks = Json::array();
  for (std::uint32_t i = 0; i < mesh.blocks().size(); ++i) {
    const ElementBlock& block = mesh.blocks()[i];
    blocks.push_back({{"name", mesh.name({EntityKind::block, i})},
                      {"shape", std::string(topology(block.shape).name)},
                      {"shell", topology(block.shape).family == Family::shell},
                      {"radius", radii[i] > 0.0 ? Json(radii[i]) : Json(nullptr)},
                      {"elements", block.n_elements}});
  }
  return blocks;
}

Json lines_json(const std::vector<ReportLine>& lines, const Mesh& mesh) {
  return {
      {"n", lines.size()},
      {"corners", pack_corners(lines, 2)},
      {"element", pack_each(lines, [&](const ReportLine& line) { return mesh.element_id(line.element); })},
      {"block", pack_each(lines, [](const ReportLine& line) { return line.block; })},
      {"owner", pack_each(lines, [](const ReportLine& line) { return line.owner; })}};
}

Json mesh_json(const ReportMesh& of) {
  const ReportGeometry& geometry = of.geometry;
  const auto id_of = [&](const auto& thing) { return of.mesh.element_id(thing.element); };
  Json faces{{"n", geometry.faces.size()},
             {"corners", pack_corners(geometry.faces, 4)},
             {"element", pack_each(geometry.faces, id_of)},
             {"side", pack_each(geometry.faces, [](const ReportFace& face) { return face.side; })},
             {"block", pack_each(geometry.faces, [](const ReportFace& face) { return face.block; })},
             {"owner", pack_each(geometry.faces, [](const ReportFace& face) { return face.owner; })},
             {"claims", pack_each(geometry.faces, [](const ReportFace& face) { return face.claims; })}};
  const auto dies = [](const ReportFace& face) {
    return face.shown_from > 0 || face.hidden_from.has_value();
  };
  if (std::ranges::any_of(geometry.faces, dies)) {
    faces["shown_from"] = pack_each(geometry.faces, [](const ReportFace& face) { return face.shown_from; });
    faces["hidden_from"] =
        pack_each(geometry.faces, [](const ReportFace& face) { return *face.hidden_from; });
  }
  return {{"path", of.mesh.path()},
          {"title", of.mesh.title()},
          {"nodes", of.mesh.n_nodes()},
          {"elements", of.mesh.n_elements()},
          {"blocks", blocks_json(of.mesh, geometry.radii)},
          {"points", geometry.nodes.size()},
          {"coordinates", coordinates_json(of)},
          {"faces", std::move(faces)},
          {"lines", lines_json(geometry.lines, of.mesh)},
          {"particles", lines_json(geometry.particles, of.mesh)},
          {"owners", geometry.owners},
          {"lost", geometry.lost},
          {"knows_claims", geometry.knows_claims}};
}

Json frames_json(const ReportMesh& of, std::size_t max_bytes, Json& notes) {
  const PackedFrames packed =
      pack_frames({of.mesh, of.geometry, of.fields, of.stored.times.size()}, max_bytes);
  std::vector<double> times;
  for (const std::size_t i : packed.chosen) times.push_back(of.stored.times[i]);
  Json fields = Json::array();
  for (const PackedField& field : packed.fields) {
    fields.push_back({{"name", field.name},
                      {"nodal", field.is_nodal},
                      {"first", field.scale.first},
                      {"step", field.scale.step},
                      {"linear_part", field.scale.linear_part},
                      {"lowest", field.lowest},
                      {"highest", field.highest},
                      {"numbers", field.numbers}});
  }
  if (packed.chosen.size() < of.stored.times.size())
    notes.push_back(fmt::format("Of {} times of the results {} are shown, so that the file stays small.",
                                of.stored.times.size(), packed.chosen.size()));
  if (!of.fields.left_out.empty())
    notes.push_back(
        fmt::format("Stored variables that are not shown: {}.", fmt::join(of.fields.left_out, ", ")));
  return {{"times", rounded(times)},
          {"positions", packed.chosen},
          {"displacement", {{"step", packed.displacement_step}, {"numbers", packed.displacement}}},
          {"fields", std::move(fields)}};
}

std::string dump(const Json& json) {
  std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
  for (std::size_t at = text.find('<'); at != std::string::npos; at = text.find('<', at))
    text.replace(at, 1, "\\u003c");
  return text;
}

}  // namespace

std::string format_report_json(const ReportRun& run, std::size_t max_bytes) {
  Json notes = run.notes;
  if (run.mesh) {
    for (const std::string& sentence : run.mesh->fields.not_found) notes.push_back(sentence);
  }
  Json json{{"name", run.name},
            {"title", run.title},
            {"deck", deck_json(run)},
            {"summary", parsed_or_null(run.summary)},
            {"surfaces", parsed_or_null(run.surfaces)},
            {"problems", problems_json(run.found)},
            {"charts", charts_json(run.charts)},
            {"mesh", run.mesh ? mesh_json(*run.mesh) : Json(nullptr)},
            {"frames", nullptr},
            {"notes", nullptr}};
  const std::size_t n_bytes = dump(json).size();
  if (run.mesh) json["frames"] = frames_json(*run.mesh, max_bytes > n_bytes ? max_bytes - n_bytes : 0, notes);
  json["notes"] = std::move(notes);
  return dump(json);
}

}  // namespace contactsim
