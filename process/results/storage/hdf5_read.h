// Reads described values back from an HDF5 file, naming what is missing or of another kind.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "process/results/storage/hdf5_layout.h"
#include "process/results/storage/result_file.h"

namespace diefill::results {

/// Half of the pair that walks through the schema (schema.h); the other is Hdf5Writer. Throws ResultError.
class Hdf5Reader {
 public:
  /// Throws where the file is missing, damaged, or not one that HDF5 can open. Takes no lock and heeds none.
  explicit Hdf5Reader(const std::filesystem::path& file);
  /// The same of a file's bytes; `file` stands in messages.
  Hdf5Reader(const std::filesystem::path& file, const std::string& bytes);

  void field(const std::string& name, double& value, const char*, const char*) { number(name, value); }
  void field(const std::string& name, std::uint64_t& value, const char*, const char*) { number(name, value); }
  void field(const std::string& name, bool& value, const char*, const char*) {
    std::uint8_t stored = 0;
    number(name, stored);
    value = stored != 0;
  }
  void field(const std::string& name, Eigen::Vector3d& value, const char*, const char*) {
    if (shape_of(name, 1) != std::vector<hsize_t>{3}) fail(name, "is not a vector of three numbers");
    read(name, number_type(0.0), value.data());
  }
  template <class T>
  void field(const std::string& name, std::vector<T>& values, const char*, const char*) {
    using Layout = Row<T>;
    const std::vector<hsize_t> shape = shape_of(name, Layout::length > 0 ? 2 : 1);
    if (Layout::length > 0 && shape[1] != Layout::length) fail(name, "has rows of the wrong length");
    values.resize(shape[0]);
    if (!values.empty()) read(name, number_type(typename Layout::Number{}), values.data());
  }
  void field(const std::string& name, std::string& text, const char*, const char*);
  void field(const std::string& name, std::vector<std::string>& texts, const char*, const char*);

  template <class Body>
  void group(const std::string& name, const char*, Body&& body) {
    const std::string outer = path_;
    path_ += "/" + name;
    body();
    path_ = outer;
  }

  /// A group that may be missing.
  template <class Body>
  void optional_group(const std::string& name, const char* description, bool, Body&& body) {
    if (has_group(name)) group(name, description, body);
  }

  template <class Item, class NameOf, class Body>
  void list(const std::string& name, const char* description, std::vector<Item>& items, NameOf, Body body) {
    items.clear();
    if (older_ && !has_group(name)) return;  // came with a later version
    group(name, description, [&] {
      const std::vector<std::string> names = members();
      items.resize(names.size());
      for (std::size_t n = 0; n < items.size(); ++n) group(names[n], "", [&] { body(items[n]); });
    });
  }

  /// A list whose group may be missing: no items.
  template <class Item, class NameOf, class Body>
  void optional_list(const std::string& name, const char* description, std::vector<Item>& items,
                     NameOf name_of, Body body) {
    if (has_group(name)) list(name, description, items, name_of, body);
  }

  template <class MeaningOf>
  void numbers(const std::string& name, const char* description, std::map<std::string, double>& values,
               MeaningOf) {
    group(name, description, [&] {
      for (const std::string& key : members()) number(key, values[key]);
    });
  }

  /// From here on lists that the file does not have are empty: it is of an older version.
  void allow_missing_lists() { older_ = true; }

  /// Attributes of the file itself; empty or -1 where there is none of that name and kind.
  std::string file_text(const char* name) const;
  int file_number(const char* name) const;

 private:
  template <class T>
  void number(const std::string& name, T& value) {
    shape_of(name, 0);
    read(name, number_type(value), &value);
  }
  std::vector<hsize_t> shape_of(const std::string& name, std::size_t dimensions) const;
  void read(const std::string& name, NumberType type, void* data) const;
  std::vector<std::string> read_texts(const std::string& name, std::size_t dimensions) const;
  std::vector<std::string> members() const;
  bool has_group(const std::string& name) const;
  [[noreturn]] void fail(const std::string& name, const std::string& what) const;

  QuietHdf5 quiet_;
  std::string file_name_;
  Hdf5Handle file_;
  std::string path_;
  bool older_ = false;
};

}  // namespace diefill::results
