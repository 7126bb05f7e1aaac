// Writes described values into an HDF5 file image in memory. Only whole images reach the disk, so that HDF5
// never meets a full one.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "process/results/storage/group_names.h"
#include "process/results/storage/hdf5_layout.h"
#include "process/results/storage/result_file.h"

namespace diefill::results {

/// Half of the pair that walks through the schema (schema.h); the other is Hdf5Reader. Throws ResultError.
class Hdf5Writer {
 public:
  Hdf5Writer();

  /// Every `field` becomes a dataset of this name in the current group, with its unit and description.
  void field(const std::string& name, double value, const char* unit, const char* description) {
    number(name, value, unit, description);
  }
  void field(const std::string& name, std::uint64_t value, const char* unit, const char* description) {
    number(name, value, unit, description);
  }
  void field(const std::string& name, bool value, const char* unit, const char* description) {
    number(name, static_cast<std::uint8_t>(value), unit, description);
  }
  void field(const std::string& name, const Eigen::Vector3d& value, const char* unit,
             const char* description) {
    array(name, number_type(0.0), {3}, value.data(), unit, description);
  }
  template <class T>
  void field(const std::string& name, const std::vector<T>& values, const char* unit,
             const char* description) {
    using Layout = Row<T>;
    std::vector<hsize_t> shape = {values.size()};
    if constexpr (Layout::length > 0) shape.push_back(Layout::length);
    array(name, number_type(typename Layout::Number{}), shape, values.data(), unit, description);
  }
  void field(const std::string& name, const std::string& text, const char* unit, const char* description);
  void field(const std::string& name, const std::vector<std::string>& texts, const char* unit,
             const char* description);

  /// What `body` writes lies in this group.
  template <class Body>
  void group(const std::string& name, const char* description, Body&& body) {
    const std::string outer = path_;
    path_ += "/" + name;
    create_group(description);
    body();
    path_ = outer;
  }

  /// The same, where there is something to write.
  template <class Body>
  void optional_group(const std::string& name, const char* description, bool there, Body&& body) {
    if (there) group(name, description, body);
  }

  /// One group an item, named after `name_of(item)`, in the order of the items.
  template <class Item, class NameOf, class Body>
  void list(const std::string& name, const char* description, const std::vector<Item>& items, NameOf name_of,
            Body body) {
    group(name, description, [&] {
      std::vector<std::string> names;
      for (const Item& item : items) names.push_back(name_of(item));
      names = group_names(names);
      for (std::size_t n = 0; n < items.size(); ++n) group(names[n], "", [&] { body(items[n]); });
    });
  }

  /// A list whose group is left out where there are no items.
  template <class Item, class NameOf, class Body>
  void optional_list(const std::string& name, const char* description, const std::vector<Item>& items,
                     NameOf name_of, Body body) {
    if (!items.empty()) list(name, description, items, name_of, body);
  }

  /// Named numbers; `meaning_of(key)` gives a pair of unit and description.
  template <class MeaningOf>
  void numbers(const std::string& name, const char* description, const std::map<std::string, double>& values,
               MeaningOf meaning_of) {
    group(name, description, [&] {
      for (const auto& [key, value] : values) {
        check_key(name, key);
        const auto [unit, meaning] = meaning_of(key);
        field(key, value, unit, meaning);
      }
    });
  }

  /// An attribute of the file itself.
  void file_attribute(const char* name, const std::string& text);
  void file_attribute(const char* name, int value);

  /// The finished file, byte by byte.
  std::string finish();

 private:
  template <class T>
  void number(const std::string& name, T value, const char* unit, const char* description) {
    array(name, number_type(value), {}, &value, unit, description);
  }
  void array(const std::string& name, NumberType type, const std::vector<hsize_t>& shape, const void* data,
             const char* unit, const char* description);
  void texts(const std::string& name, hid_t space, const std::vector<const char*>& texts, const char* unit,
             const char* description);
  void create_group(const char* description);
  static void check_key(const std::string& group, const std::string& key);

  QuietHdf5 quiet_;
  Hdf5Handle file_;
  std::string path_;
};

}  // namespace diefill::results
