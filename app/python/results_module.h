// The compiled part of the Python package: results.h5 as objects with NumPy arrays.
#pragma once

#include <pybind11/pybind11.h>

namespace diefill::python {

/// How an object shows itself in a Python session: "<diefill.NAME words>", `words` as str.format takes them.
template <class... Values>
pybind11::str shown_as(const char* name, const char* words, const Values&... values) {
  return pybind11::str("<diefill.{} {}>").format(name, pybind11::str(words).format(values...));
}

/// Powder, solid fraction with its summary, contact stress and instants: arrays over grains.
void add_grains(pybind11::module_& module);
/// Maps, sections, profiles, probes, stages, tools with their checks, and the cavity.
void add_fields(pybind11::module_& module);
/// A whole run, and the function that reads it.
void add_run(pybind11::module_& module);

}  // namespace diefill::python
