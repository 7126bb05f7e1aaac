// NumPy arrays that view memory of results without copying it: read-only, and valid as long as they are
// referenced.
#pragma once

#include <pybind11/numpy.h>

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace diefill::python {

namespace py = pybind11;

/// Read-only array of `shape` on memory that `owner` keeps.
template <class Number>
py::array view_of(const Number* first, std::vector<py::ssize_t> shape, const py::object& owner,
                  const py::dtype& type = py::dtype::of<Number>()) {
  py::array array(type, std::move(shape), first, owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// One number an entry.
template <class Number>
py::array view_of(const std::vector<Number>& values, const py::object& owner) {
  return view_of(values.data(), {static_cast<py::ssize_t>(values.size())}, owner);
}

/// The same for bytes of 0 and 1, as truth values.
inline py::array flags_of(const std::vector<std::uint8_t>& values, const py::object& owner) {
  return view_of(values.data(), {static_cast<py::ssize_t>(values.size())}, owner, py::dtype("bool"));
}

/// A row a vector.
template <class Number, int Size>
py::array view_of(const std::vector<Eigen::Matrix<Number, Size, 1>>& rows, const py::object& owner) {
  static_assert(sizeof(Eigen::Matrix<Number, Size, 1>) == Size * sizeof(Number));
  return view_of(reinterpret_cast<const Number*>(rows.data()), {static_cast<py::ssize_t>(rows.size()), Size},
                 owner);
}

/// A property that shows `member` of an object without copying it.
template <class Owner, class Values>
auto shown(Values Owner::*member) {
  return [member](const py::object& self) { return view_of(self.cast<const Owner&>().*member, self); };
}

}  // namespace diefill::python
