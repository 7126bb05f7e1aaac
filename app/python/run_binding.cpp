#include <pybind11/stl.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "app/python/results_module.h"
#include "process/results/figure_table.h"
#include "process/results/storage/result_file.h"

namespace diefill::python {

namespace py = pybind11;

namespace {

using results::FillResult;

/// A dict whose KeyError says what is there (diefill/named.py); `what`: one of its entries, in messages.
py::object named(const char* what, const py::dict& entries) {
  return py::module_::import("diefill.named").attr("Named")(what, entries);
}

/// A property: the entries of a list in `owner` by name, each valid as long as it is referenced.
template <class Entry, class Name>
auto by_name(const char* what, std::vector<Entry> FillResult::*list, const Name& name) {
  return [what, list, name](const py::object& self) {
    py::dict entries;
    for (const Entry& entry : self.cast<const FillResult&>().*list)
      entries[py::str(name(entry))] = py::cast(&entry, py::return_value_policy::reference_internal, self);
    return named(what, entries);
  };
}

py::object figures_of(const FillResult& result) {
  py::dict entries;
  for (const auto& [name, value] : result.figures) entries[py::str(name)] = py::float_(value);
  return named("figure", entries);
}

/// "fill level"; where several profiles have one quantity "fill level over azimuth".
std::string profile_name(const results::Profile& profile, const FillResult& result) {
  const auto of_quantity =
      std::count_if(result.profiles.begin(), result.profiles.end(),
                    [&](const results::Profile& other) { return other.quantity == profile.quantity; });
  return of_quantity > 1 ? profile.quantity + " over " + profile.x_name : profile.quantity;
}

/// Each valid as long as it is referenced.
py::object profiles_of(const py::object& self) {
  const auto& result = self.cast<const FillResult&>();
  const auto name = [&result](const results::Profile& profile) { return profile_name(profile, result); };
  return by_name("profile", &FillResult::profiles, name)(self);
}

std::optional<std::pair<std::string, std::string>> meaning_of(const std::string& name) {
  const results::Figure* figure = results::find_figure(name);
  if (figure == nullptr) return std::nullopt;
  return std::pair<std::string, std::string>(figure->unit, figure->meaning);
}

std::vector<std::string> figure_names() {
  std::vector<std::string> names;
  for (const results::Figure& figure : results::figure_table()) names.emplace_back(figure.name);
  return names;
}

/// The topics of the run: statement by name, for each topic.
py::dict topics_of(const FillResult& result) {
  py::dict topics;
  for (const auto& topic : result.topics) {
    py::dict statements;
    for (std::size_t k = 0; k < topic.name.size(); ++k) statements[py::str(topic.name[k])] = topic.text[k];
    topics[py::str(topic.topic)] = statements;
  }
  return topics;
}

/// A property: the entries of a list in `owner` in their order, each valid as long as it is referenced.
template <class Entry>
auto in_order(std::vector<Entry> FillResult::*list) {
  return [list](const py::object& self) {
    py::list entries;
    for (const Entry& entry : self.cast<const FillResult&>().*list)
      entries.append(py::cast(&entry, py::return_value_policy::reference_internal, self));
    return entries;
  };
}

void add_texts(py::class_<FillResult>& run) {
  run.def_readonly("title", &FillResult::title, "of the scene")
      .def_readonly("strategy", &FillResult::strategy, "one line, such as \"1 passage at 0.2 m/s\"")
      .def_readonly("powder_name", &FillResult::powder_name, "such as \"Distaloy AE\"")
      .def_readonly("scene_text", &FillResult::scene_text, "the scene file as it was run")
      .def_readonly("program_version", &FillResult::program_version, "of the program that ran it")
      .def_readonly("seed", &FillResult::seed, "of the random numbers that place and turn the grains")
      .def_readonly("state_hash", &FillResult::state_hash, "the same hash: the same state, bit for bit")
      .def_readonly("warnings", &FillResult::warnings, "remarks of the run")
      .def_property_readonly("topics", topics_of, "statements on powder, model, walls, numerics, ...")
      .def("__repr__", [](const FillResult& result) {
        return "<diefill.Results " + result.title + ": " + std::to_string(result.powder.id.size()) +
               " grains>";
      });
}

void add_entries(py::class_<FillResult>& run) {
  run.def_property_readonly("figures", figures_of,
                            "numbers of report.json by name; figure_meaning() explains them")
      .def_property_readonly("maps",
                             by_name("map", &FillResult::maps, [](const auto& map) { return map.quantity; }),
                             "fields by quantity")
      .def_property_readonly(
          "sections",
          by_name("section", &FillResult::sections, [](const auto& section) { return section.plane.name; }),
          "fields on planes by name of the plane")
      .def_property_readonly("profiles", profiles_of,
                             "curves by quantity; where several have one quantity, by \"quantity over axis\"")
      .def_property_readonly(
          "probes", by_name("probe", &FillResult::probes, [](const auto& probe) { return probe.name; }),
          "by name in the scene")
      .def_property_readonly("tools",
                             by_name("tool", &FillResult::tools, [](const auto& tool) { return tool.name; }),
                             "by name in the scene")
      .def_property_readonly(
          "tool_checks",
          by_name("tool check", &FillResult::tool_checks, [](const auto& check) { return check.tool; }),
          "by name of the tool");
}

}  // namespace

void add_run(py::module_& module) {
  py::register_exception<results::ResultError>(module, "ResultError", PyExc_ValueError);
  py::class_<FillResult> run(module, "Results", "One run: powder, tools, fields and figures. SI units.");
  add_texts(run);
  run.def_readonly("powder", &FillResult::powder, "at the end of the run")
      .def_readonly("solid_fraction", &FillResult::solid_fraction, "of every grain")
      .def_readonly("contact_stress", &FillResult::contact_stress, "of every grain")
      .def_readonly("cavity", &FillResult::cavity, "the largest one")
      .def_readonly("summary", &FillResult::summary, "solid fraction of the grains in the cavity")
      .def_readonly("phase_seconds", &FillResult::phase_seconds,
                    "s of wall-clock time by phase of the step, since the last restart")
      .def_property_readonly("instants", in_order(&FillResult::instants),
                             "earlier times, ascending (measure.snapshot_interval)")
      .def_property_readonly("stages", in_order(&FillResult::stages), "the schedule as it happened")
      .def_property_readonly("other_cavities", in_order(&FillResult::other_cavities),
                             "smaller ones; figures and maps are of `cavity`");
  add_entries(run);
  module.def(
      "read", [](const std::string& directory) { return results::read_results(directory); },
      py::arg("directory"),
      "Reads directory/results.h5. Raises ResultError naming the file and what is wrong with it.");
  module.def(
      "figure_meaning", &meaning_of, py::arg("name"),
      "Unit of a figure (\"1\": a plain number), and how it is formed; None: there is no such figure.");
  module.def("figure_names", &figure_names,
             "Names of all figures; * stands for the name of an item of a scene.");
}

}  // namespace diefill::python

PYBIND11_MODULE(_results, module) {
  module.doc() = "Results of diefill as NumPy arrays, without copies.";
  diefill::python::add_grains(module);
  diefill::python::add_fields(module);
  diefill::python::add_run(module);
}
