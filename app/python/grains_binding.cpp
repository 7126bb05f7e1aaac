#include <pybind11/stl.h>

#include "app/python/array_views.h"
#include "app/python/results_module.h"
#include "process/results/fill_result.h"

namespace diefill::python {

namespace {

using results::ContactStress;
using results::GrainSolidFraction;
using results::Instant;
using results::PowderState;
using results::SolidFractionSummary;

template <class Owner>
auto shown_flags(std::vector<std::uint8_t> Owner::*member) {
  return [member](const py::object& self) { return flags_of(self.cast<const Owner&>().*member, self); };
}

/// One number per grain, computed.
template <class Value>
py::array_t<double> of_each_grain(const PowderState& powder, const Value& value) {
  py::array_t<double> array(static_cast<py::ssize_t>(powder.id.size()));
  for (std::size_t k = 0; k < powder.id.size(); ++k) array.mutable_data()[k] = value(powder, k);
  return array;
}

void add_powder(py::module_& module) {
  py::class_<PowderState>(module, "Powder", "Powder at one instant; arrays run over grains. SI units.")
      .def_readonly("time", &PowderState::time, "s since the start of the scene")
      .def_readonly("grain_diameter", &PowderState::grain_diameter, "m, size d of the model grains")
      .def_readonly("sphere_radius", &PowderState::sphere_radius, "m, radius R of the basic spheres")
      .def_readonly("grain_mass", &PowderState::grain_mass, "kg")
      .def_readonly("grain_solid_volume", &PowderState::grain_solid_volume, "m^3, union of the spheres")
      .def_readonly("period", &PowderState::period, "m, periodic lengths along x, y, z; 0: none")
      .def_property_readonly("sphere_offsets", shown(&PowderState::sphere_offsets),
                             "(s, 3) m, sphere centres in the grain's body frame")
      .def_property_readonly("id", shown(&PowderState::id), "(n,) identity of the grain")
      .def_property_readonly("position", shown(&PowderState::position),
                             "(n, 3) m, grain centres, laboratory frame, z up")
      .def_property_readonly("orientation", shown(&PowderState::orientation),
                             "(n, 4) unit quaternion w, x, y, z, body to laboratory")
      .def_property_readonly("velocity", shown(&PowderState::velocity), "(n, 3) m/s")
      .def_property_readonly("angular_velocity", shown(&PowderState::angular_velocity),
                             "(n, 3) rad/s, laboratory frame")
      .def_property_readonly("kind", shown(&PowderState::kind),
                             "(n,) number of the grain's type; empty for powder of one size")
      .def_property_readonly(
          "diameter",
          [](const PowderState& powder) {
            return of_each_grain(powder, [](const auto& p, std::size_t k) { return p.diameter_of(k); });
          },
          "(n,) m, a copy")
      .def_property_readonly(
          "mass",
          [](const PowderState& powder) {
            return of_each_grain(powder, [](const auto& p, std::size_t k) { return p.mass_of(k); });
          },
          "(n,) kg, a copy")
      .def(
          "__len__", [](const PowderState& powder) { return powder.id.size(); }, "Number of grains.")
      .def("__repr__", [](const PowderState& powder) {
        return shown_as("Powder", "{} grains at {:g} s", powder.id.size(), powder.time);
      });
}

void add_summary(py::module_& module) {
  py::class_<SolidFractionSummary>(
      module, "Summary",
      "Solid fraction over the closed cells of the cavity at least 2 d below the powder's surface.")
      .def_readonly("mean", &SolidFractionSummary::mean, "sum of solid volumes over sum of cell volumes")
      .def_readonly("arithmetic_mean", &SolidFractionSummary::arithmetic_mean, "of the grains' values")
      .def_readonly("std", &SolidFractionSummary::std, "standard deviation of the grains' values")
      .def_readonly("min", &SolidFractionSummary::min, "of the grains' values")
      .def_readonly("max", &SolidFractionSummary::max, "of the grains' values")
      .def_readonly("cv", &SolidFractionSummary::cv, "std over arithmetic_mean")
      .def_readonly("grains", &SolidFractionSummary::grains, "grains counted")
      .def("__repr__", [](const SolidFractionSummary& summary) {
        return shown_as("Summary", "solid fraction {:.4f}, cv {:.3f}, {} grains", summary.mean, summary.cv,
                        summary.grains);
      });
}

}  // namespace

void add_grains(py::module_& module) {
  add_powder(module);
  add_summary(module);
  py::class_<GrainSolidFraction>(module, "SolidFraction", "Voronoi measure of every grain.")
      .def_property_readonly("cell_volume", shown(&GrainSolidFraction::cell_volume), "(n,) m^3")
      .def_property_readonly("solid_fraction", shown(&GrainSolidFraction::solid_fraction),
                             "(n,) grain volume over cell volume")
      .def_property_readonly("open", shown_flags(&GrainSolidFraction::open),
                             "(n,) true where the cell reaches a free surface: its values mean nothing")
      .def_property_readonly("in_cavity", shown_flags(&GrainSolidFraction::in_cavity),
                             "(n,) true where the grain's centre lies in the cavity")
      .def("__repr__", [](const GrainSolidFraction& measure) {
        return shown_as("SolidFraction", "{} grains", measure.solid_fraction.size());
      });
  py::class_<ContactStress>(module, "ContactStress",
                            "Stress times volume that contacts carried through every grain (Bierwisch 2009, "
                            "Eq. 3.8), compression negative; over cell_volume it is a stress in Pa.")
      .def_property_readonly("normal", shown(&ContactStress::normal), "(n, 3) J: xx, yy, zz")
      .def_property_readonly("shear", shown(&ContactStress::shear), "(n, 3) J: yz, xz, xy")
      .def("__repr__", [](const ContactStress& stress) {
        return shown_as("ContactStress", "{} grains", stress.normal.size());
      });
  py::class_<Instant>(module, "Instant", "Powder and places of the tools at an earlier time of the run.")
      .def_readonly("time", &Instant::time, "s since the start of the scene")
      .def_property_readonly("id", shown(&Instant::id), "(n,) identity of the grain")
      .def_property_readonly("position", shown(&Instant::position), "(n, 3) m, laboratory frame")
      .def_property_readonly("orientation", shown(&Instant::orientation),
                             "(n, 4) unit quaternion w, x, y, z, body to laboratory")
      .def_property_readonly("velocity", shown(&Instant::velocity), "(n, 3) m/s")
      .def_property_readonly("kind", shown(&Instant::kind),
                             "(n,) number of the grain's type; empty for powder of one size")
      .def_property_readonly("tool_orientation", shown(&Instant::tool_orientation),
                             "(tools, 4) unit quaternion from the tool's place at the end of the run")
      .def_property_readonly("tool_displacement", shown(&Instant::tool_displacement),
                             "(tools, 3) m, added after turning about the origin")
      .def(
          "__len__", [](const Instant& instant) { return instant.id.size(); }, "Number of grains.")
      .def("__repr__", [](const Instant& instant) {
        return shown_as("Instant", "{} grains at {:g} s", instant.id.size(), instant.time);
      });
}

}  // namespace diefill::python
