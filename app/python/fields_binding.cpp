#include <pybind11/stl.h>

#include <algorithm>

#include "app/python/array_views.h"
#include "app/python/results_module.h"
#include "process/results/fill_result.h"

namespace diefill::python {

namespace {

using results::CavityState;
using results::Field2D;
using results::ProbeSeries;
using results::Profile;
using results::SectionField;
using results::Stage;
using results::ToolCheck;
using results::ToolState;

/// A copy of three numbers.
py::array_t<double> three(const Eigen::Vector3d& vector) {
  return py::array_t<double>(3, vector.data());
}

template <class Owner>
auto vector_of(Eigen::Vector3d Owner::*member) {
  return [member](const Owner& owner) { return three(owner.*member); };
}

auto plane_vector(Eigen::Vector3d results::SectionPlane::*member) {
  return [member](const SectionField& section) { return three(section.plane.*member); };
}

py::array values_of(const py::object& self) {
  const auto& field = self.cast<const Field2D&>();
  return view_of(
      field.value.data(),
      {static_cast<py::ssize_t>(field.second.size()), static_cast<py::ssize_t>(field.first.size())}, self);
}

py::array rows_of(const py::object& self) {
  const auto& probe = self.cast<const ProbeSeries&>();
  const auto columns = static_cast<py::ssize_t>(probe.columns.size());
  const auto rows = columns == 0 ? 0 : static_cast<py::ssize_t>(probe.values.size()) / columns;
  return view_of(probe.values.data(), {rows, columns}, self);
}

py::array column_of(const py::object& self, const py::object& key) {
  if (!py::isinstance<py::str>(key))
    throw py::type_error("Probe: found a column of type " +
                         std::string(py::str(py::type::of(key).attr("__name__"))) +
                         ", expected its name as a text; `columns` lists all");
  const auto name = key.cast<std::string>();
  const auto& columns = self.cast<const ProbeSeries&>().columns;
  const auto found = std::find(columns.begin(), columns.end(), name);
  if (found == columns.end()) throw py::key_error(name + ": no such column; `columns` lists all");
  return rows_of(self)[py::make_tuple(py::ellipsis(), found - columns.begin())];
}

void add_grids(py::module_& module) {
  py::class_<Field2D>(module, "Field", "A field on a rectangular grid.")
      .def_readonly("quantity", &Field2D::quantity, "such as \"solid fraction\"")
      .def_readonly("first_name", &Field2D::first_name, "of the coordinate that varies along a row of values")
      .def_readonly("first_unit", &Field2D::first_unit, "of first")
      .def_readonly("second_name", &Field2D::second_name,
                    "of the coordinate that varies along a column of values")
      .def_readonly("second_unit", &Field2D::second_unit, "of second")
      .def_readonly("averaging_width", &Field2D::averaging_width, "m, sigma of Bierwisch 2009, Eq. 2.27")
      .def_property_readonly("first", shown(&Field2D::first), "(a,) nodes in first_unit")
      .def_property_readonly("second", shown(&Field2D::second), "(b,) nodes in second_unit")
      .def_property_readonly("values", values_of,
                             "(b, a): values[j, i] at first[i], second[j]; NaN: no powder")
      .def("__repr__", [](const Field2D& field) {
        return shown_as("Field", "{}, {} x {} nodes", field.quantity, field.first.size(),
                        field.second.size());
      });
  py::class_<SectionField>(module, "Section", "A field on a plane, coordinates in mm from its origin.")
      .def_property_readonly(
          "name", [](const SectionField& section) { return section.plane.name; },
          "such as \"along the shoe's motion\"")
      .def_property_readonly("origin", plane_vector(&results::SectionPlane::origin),
                             "(3,) m, where both coordinates are 0")
      .def_property_readonly("normal", plane_vector(&results::SectionPlane::normal), "(3,) unit vector")
      .def_property_readonly("first_axis", plane_vector(&results::SectionPlane::first_axis),
                             "(3,) unit vector")
      .def_property_readonly("second_axis", plane_vector(&results::SectionPlane::second_axis),
                             "(3,) unit vector")
      .def_readonly("field", &SectionField::field,
                    "on the plane, in mm from origin along first_axis and second_axis")
      .def("__repr__", [](const SectionField& section) {
        return shown_as("Section", "{}, {} x {} nodes", section.plane.name, section.field.first.size(),
                        section.field.second.size());
      });
}

void add_curves(py::module_& module) {
  py::class_<Profile>(module, "Profile", "A curve, such as the fill level over the azimuth.")
      .def_readonly("quantity", &Profile::quantity, "such as \"fill level\"")
      .def_readonly("unit", &Profile::unit, "of y")
      .def_readonly("x_name", &Profile::x_name, "such as \"azimuth\"")
      .def_readonly("x_unit", &Profile::x_unit, "of x")
      .def_property_readonly("x", shown(&Profile::x), "(n,) in x_unit")
      .def_property_readonly("y", shown(&Profile::y), "(n,) in unit; NaN where nothing was found")
      .def("__repr__", [](const Profile& profile) {
        return shown_as("Profile", "{} over {}, {} points", profile.quantity, profile.x_name,
                        profile.x.size());
      });
  py::class_<ProbeSeries>(module, "Probe",
                          "What a probe recorded while the scene ran; probe[column] is one column.")
      .def_readonly("name", &ProbeSeries::name, "in the scene")
      .def_readonly("columns", &ProbeSeries::columns, "names; the first is the time")
      .def_readonly("units", &ProbeSeries::units, "one a column")
      .def_property_readonly("values", rows_of, "(rows, columns)")
      .def("__getitem__", column_of,
           "(rows,) one column, in its unit. Raises KeyError for an unknown name, TypeError for what is no "
           "text.")
      .def("__repr__",
           [](const ProbeSeries& probe) { return shown_as("Probe", "{}: {}", probe.name, probe.columns); });
}

void add_records(py::module_& module) {
  py::class_<Stage>(module, "Stage", "One stage of the schedule as it happened.")
      .def_readonly("tool", &Stage::tool, "tool that moved; empty: none")
      .def_readonly("words", &Stage::words, "such as \"1 passage at 0.2 m/s\"")
      .def_readonly("start", &Stage::start, "s since the start of the scene")
      .def_readonly("end", &Stage::end, "s since the start of the scene")
      .def("__repr__", [](const Stage& stage) {
        return shown_as("Stage", "{}{}{}, {:g} to {:g} s", stage.tool, stage.tool.empty() ? "" : ": ",
                        stage.words, stage.start, stage.end);
      });
  py::class_<ToolCheck>(module, "ToolCheck", "What the check of a tool's mesh and wall spheres found.")
      .def_readonly("tool", &ToolCheck::tool, "its name in the scene")
      .def_readonly("file", &ToolCheck::file, "its CAD file, without folders")
      .def_readonly("findings", &ToolCheck::findings, "about the mesh; empty: none")
      .def_readonly("volume", &ToolCheck::volume, "m^3, enclosed by the mesh")
      .def_readonly("mean_deviation", &ToolCheck::mean_deviation,
                    "m, of the wall spheres' envelope from the CAD surface")
      .def_readonly("largest_deviation", &ToolCheck::largest_deviation, "m")
      .def_readonly("largest_gap", &ToolCheck::largest_gap, "m, between wall spheres")
      .def("__repr__", [](const ToolCheck& check) {
        return shown_as("ToolCheck", "{} ({}): {} findings", check.tool, check.file, check.findings.size());
      });
}

void add_tooling(py::module_& module) {
  py::class_<ToolState>(module, "Tool", "A tool as it stood at the end of the run, laboratory frame.")
      .def_readonly("name", &ToolState::name, "in the scene")
      .def_readonly("role", &ToolState::role, "die, core, punch, shoe or plate")
      .def_readonly("wall_sphere_radius", &ToolState::wall_sphere_radius, "m")
      .def_property_readonly("vertices", shown(&ToolState::vertices), "(v, 3) m")
      .def_property_readonly("triangles", shown(&ToolState::triangles),
                             "(t, 3) numbers of vertices, counter-clockwise seen from outside")
      .def_property_readonly("wall_sphere_centres", shown(&ToolState::wall_sphere_centres), "(w, 3) m")
      .def("__repr__", [](const ToolState& tool) {
        return shown_as("Tool", "{} ({}): {} triangles, {} wall spheres", tool.name, tool.role,
                        tool.triangles.size(), tool.wall_sphere_centres.size());
      });
  py::class_<CavityState>(module, "Cavity", "Where the powder is collected.")
      .def_readonly("is_ring", &CavityState::is_ring, "whether a core stands in its middle")
      .def_readonly("inner_radius", &CavityState::inner_radius, "m, of rings")
      .def_readonly("outer_radius", &CavityState::outer_radius, "m, of rings")
      .def_readonly("volume", &CavityState::volume, "m^3 below the fill plane; 0: unknown")
      .def_readonly("narrowest_width", &CavityState::narrowest_width, "m; 0: unknown")
      .def_property_readonly("axis_origin", vector_of(&CavityState::axis_origin),
                             "(3,) m, of rings: where their vertical axis meets the fill plane")
      .def_property_readonly("lower_corner", vector_of(&CavityState::lower_corner),
                             "(3,) m, of the box around the cavity")
      .def_property_readonly("upper_corner", vector_of(&CavityState::upper_corner),
                             "(3,) m, of the box around the cavity; its z is the fill plane")
      .def("__repr__", [](const CavityState& cavity) {
        constexpr double kCubicMillimetres = 1e9;
        return shown_as("Cavity", "{}, {:g} mm^3", cavity.is_ring ? "ring" : "without a core",
                        kCubicMillimetres * cavity.volume);
      });
}

}  // namespace

void add_fields(py::module_& module) {
  add_grids(module);
  add_curves(module);
  add_records(module);
  add_tooling(module);
}

}  // namespace diefill::python
