// SPDX-License-Identifier: BSD-3-Clause
#include <fmt/format.h>
#include <pybind11/stl.h>

#include <limits>
#include <map>

#include "app/python/arrays.hpp"
#include "app/python/bindings.hpp"
#include "app/python/deck_run.hpp"
#include "core/base/version.hpp"

namespace py = pybind11;

namespace contactsim {

namespace {

/// Values of Aprepro variables as text, "mu=0.3"; numbers as Python writes them.
std::vector<std::string> definitions_of(const py::dict& values) {
  std::vector<std::string> texts;
  for (const auto& [name, value] : values)
    texts.push_back(fmt::format("{}={}", std::string(py::str(name)), std::string(py::str(value))));
  return texts;
}

std::unique_ptr<DeckRun> make_run(const std::string& deck, std::optional<std::string> mesh,
                                  const py::dict& define, bool lenient, std::optional<std::string> output) {
  return std::make_unique<DeckRun>(
      DeckRunRequest{deck, std::move(mesh), definitions_of(define), lenient, std::move(output)});
}

std::vector<std::string> surface_names(const DeckRun& run) {
  std::vector<std::string> names;
  if (run.contact() == nullptr) return names;
  for (const ContactSurface& surface : run.contact()->surfaces.surfaces) names.push_back(surface.name);
  return names;
}

/// The face table as columns of one length.
py::dict facets_of(const DeckRun& run) {
  std::vector<std::string> surfaces, blocks, kinds;
  std::vector<std::int64_t> elements, sides;
  std::vector<double> areas;
  if (run.contact() != nullptr) {
    const auto& owners = run.contact()->surfaces.surfaces;
    for (const FacetRow& row : list_facets(*run.contact(), run.mesh())) {
      surfaces.push_back(owners[row.surface].name);
      blocks.push_back(row.block);
      kinds.emplace_back(row.kind);
      elements.push_back(row.element);
      sides.push_back(row.side);
      areas.push_back(row.area);
    }
  }
  const py::object as_array = py::module_::import("numpy").attr("array");
  py::dict columns;
  columns["surface"] = as_array(surfaces);
  columns["block"] = as_array(blocks);
  columns["element"] = array_of(elements);
  columns["side"] = array_of(sides);
  columns["kind"] = as_array(kinds);
  columns["area"] = array_of(areas);
  return columns;
}

std::vector<std::pair<std::string, std::string>> pairs_of(const DeckRun& run) {
  std::vector<std::pair<std::string, std::string>> pairs;
  if (run.contact() == nullptr) return pairs;
  const std::vector<std::string> names = surface_names(run);
  for (const SurfacePair& pair : run.contact()->pairs)
    pairs.emplace_back(names[pair.first.value], names[pair.second.value]);
  return pairs;
}

std::map<std::string, double> energies_of(const DeckRun& run) {
  const Energies& energies = run.simulation().state().energies;
  return {{"kinetic", energies.kinetic},   {"internal", energies.internal},
          {"external", energies.external}, {"contact", energies.contact},
          {"friction", energies.friction}, {"contact_damping", energies.contact_damping},
          {"impact", energies.impact},     {"hourglass", energies.hourglass},
          {"error", energies.error},       {"stabilization", energies.stabilization}};
}

/// Steps until a time or the end; Python's interrupts are heard after every step.
void run_until(DeckRun& run, double time) {
  run.begin();
  while (!run.is_over() && run.simulation().state().time < time) {
    {
      const py::gil_scoped_release others_may_work;
      run.step();
    }
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  }
}

const State& state_of(const DeckRun& run) { return run.simulation().state(); }

py::array_t<double> contact_forces(const DeckRun& run) {
  const State& state = state_of(run);
  const Eigen::Matrix3Xd& forces = state.forces.contact;
  return rows_of(run.mesh(),
                 forces.cols() > 0 ? forces : Eigen::Matrix3Xd::Zero(3, state.coordinates.cols()));
}

using Bound = py::class_<DeckRun>;

void bind_definition(Bound& bound) {
  bound
      .def(
          py::init(&make_run), py::arg("deck"), py::arg("mesh") = py::none(), py::arg("define") = py::dict(),
          py::arg("lenient") = false, py::arg("output") = py::none(),
          "Reads a deck and a mesh and resolves the contact surfaces. define gives Aprepro variables. Raises "
          "DeckError with all problems, FileError")
      .def_property_readonly("mesh", &DeckRun::mesh, py::return_value_policy::reference_internal)
      .def_property_readonly(
          "warnings", [](const DeckRun& run) { return run.diagnostics().all(); },
          "Found so far, a list of Problem")
      .def_property_readonly("surfaces", &surface_names, "Names in the order of the deck")
      .def_property_readonly("pairs", &pairs_of, "Names of the surfaces that may meet")
      .def("facets", &facets_of,
           "Who owns what, as arrays of one length: surface, block, element (id), side (from 1), kind, area");
}

void bind_motion(Bound& bound) {
  bound
      .def("begin", &DeckRun::begin, py::call_guard<py::gil_scoped_release>(),
           "Prepares the run and completes the state of the start")
      .def("step", &DeckRun::step, py::call_guard<py::gil_scoped_release>(),
           "Moves the run by a step. Raises SolveError when the motion cannot go on")
      .def("run", &run_until, py::arg("until") = std::numeric_limits<double>::infinity(),
           "Steps until a time, or to the end")
      .def("finish", &DeckRun::finish, "Ends the run where it is and completes its files")
      .def_property_readonly("is_over", &DeckRun::is_over)
      .def_property_readonly("time", [](const DeckRun& run) { return state_of(run).time; })
      .def_property_readonly("n_steps", [](const DeckRun& run) { return state_of(run).step; })
      .def_property_readonly(
          "time_step", [](const DeckRun& run) { return state_of(run).next_dt; },
          "Of the step to come [time]");
}

void bind_state(Bound& bound) {
  bound
      .def_property_readonly(
          "positions", [](const DeckRun& run) { return rows_of(run.mesh(), state_of(run).coordinates); },
          "[n_nodes, 3] [length]")
      .def_property_readonly(
          "velocities", [](const DeckRun& run) { return rows_of(run.mesh(), state_of(run).velocity); },
          "[n_nodes, 3] [length/time]")
      .def_property_readonly("contact_forces", &contact_forces, "[n_nodes, 3] [force]")
      .def_property_readonly("energies", &energies_of, "By name [energy]")
      .def_property_readonly(
          "momentum", [](const DeckRun& run) { return rows_of(state_of(run).momentum).attr("ravel")(); },
          "[3] [mass length/time]")
      .def_property_readonly(
          "outputs", [](const DeckRun& run) { return run.simulation().output_paths(); },
          "Paths of the files written");
}

}  // namespace

void bind_run(py::module_& module) {
  module.attr("__version__") = version;
  Bound bound(module, "Simulation", "A deck with its mesh and contact surfaces, and its run");
  bind_definition(bound);
  bind_motion(bound);
  bind_state(bound);
}

}  // namespace contactsim
