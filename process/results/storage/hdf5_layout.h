// How C++ values lie in HDF5 datasets: which number type, and which shape.
#pragma once

#include <hdf5.h>

#include <Eigen/Core>
#include <cstdint>
#include <utility>
#include <vector>

namespace diefill::results {

/// Closes an HDF5 identifier at the end of its scope. Identifiers that could not be opened are negative.
class Hdf5Handle {
 public:
  using Close = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Close closer) : id_(id), close_(closer) {}
  ~Hdf5Handle() {
    if (id_ >= 0) close_(id_);
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  hid_t id() const { return id_; }
  bool valid() const { return id_ >= 0; }
  /// Closes now; false where HDF5 reports a failure.
  bool close() { return close_(std::exchange(id_, -1)) >= 0; }

 private:
  hid_t id_;
  Close close_;
};

/// Keeps HDF5 from printing its error stack while it lives: every failure ends in one exception with one
/// line.
class QuietHdf5 {
 public:
  QuietHdf5() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietHdf5(const QuietHdf5&) = delete;
  QuietHdf5& operator=(const QuietHdf5&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// Texts of any length in UTF-8; to be closed by H5Tclose.
inline hid_t text_type() {
  const hid_t type = H5Tcopy(H5T_C_S1);
  H5Tset_size(type, H5T_VARIABLE);
  H5Tset_cset(type, H5T_CSET_UTF8);
  return type;
}

/// Number types of the schema: their type in memory and in the file.
struct NumberType {
  hid_t memory, file;
};
inline NumberType number_type(double) {
  return {H5T_NATIVE_DOUBLE, H5T_IEEE_F64LE};
}
inline NumberType number_type(int) {
  return {H5T_NATIVE_INT, H5T_STD_I32LE};
}
inline NumberType number_type(std::uint64_t) {
  return {H5T_NATIVE_UINT64, H5T_STD_U64LE};
}
inline NumberType number_type(std::uint32_t) {
  return {H5T_NATIVE_UINT32, H5T_STD_U32LE};
}
inline NumberType number_type(std::uint8_t) {
  return {H5T_NATIVE_UINT8, H5T_STD_U8LE};
}

/// Rows of a dataset: plain numbers, or fixed vectors that take a second dimension.
template <class T>
struct Row {
  using Number = T;
  static constexpr hsize_t length = 0;
};
template <class T, int N>
struct Row<Eigen::Matrix<T, N, 1>> {
  using Number = T;
  static constexpr hsize_t length = N;
};

}  // namespace diefill::results
