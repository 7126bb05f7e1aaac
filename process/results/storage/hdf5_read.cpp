#include "process/results/storage/hdf5_read.h"

namespace diefill::results {
namespace {

hid_t open(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error))
    throw ResultError(file.string() +
                      ": no such results file; run the scene first or give another directory");
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_file_locking(access.id(), false, true);
  const hid_t id = H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id());
  if (id < 0)
    throw ResultError(file.string() + ": not an HDF5 file, damaged or truncated; run the scene again");
  return id;
}

hid_t open_image(const std::filesystem::path& file, const std::string& bytes) {
  constexpr std::size_t kGrowth = 4096;  // bytes; nothing is written
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  // HDF5 copies the bytes and does not change ours.
  void* const image = const_cast<char*>(bytes.data());
  const bool set = H5Pset_fapl_core(access.id(), kGrowth, false) >= 0 &&
                   H5Pset_file_image(access.id(), image, bytes.size()) >= 0;
  // HDF5 asks for a name of which there is no file.
  const std::string name = (file / "bytes").string();
  const hid_t id = set ? H5Fopen(name.c_str(), H5F_ACC_RDONLY, access.id()) : -1;
  if (id < 0) throw ResultError(file.string() + ": HDF5 cannot open it; run the scene again");
  return id;
}

bool is_text(hid_t type) {
  return H5Tget_class(type) == H5T_STRING && H5Tis_variable_str(type) > 0;
}

}  // namespace

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file)
    : file_name_(file.string()), file_(open(file), H5Fclose) {}

Hdf5Reader::Hdf5Reader(const std::filesystem::path& file, const std::string& bytes)
    : file_name_(file.string()), file_(open_image(file, bytes), H5Fclose) {}

void Hdf5Reader::fail(const std::string& name, const std::string& what) const {
  throw ResultError(file_name_ + ": " + path_ + "/" + name + " " + what +
                    "; the file is damaged or was not written by this program");
}

std::vector<hsize_t> Hdf5Reader::shape_of(const std::string& name, std::size_t dimensions) const {
  Hdf5Handle dataset(H5Dopen2(file_.id(), (path_ + "/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  if (!dataset.valid()) fail(name, "is missing");
  Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  const int found = H5Sget_simple_extent_ndims(space.id());
  if (found < 0 || static_cast<std::size_t>(found) != dimensions)
    fail(name, "has " + std::to_string(found) + " dimensions instead of " + std::to_string(dimensions));
  std::vector<hsize_t> shape(dimensions);
  H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
  return shape;
}

void Hdf5Reader::read(const std::string& name, NumberType type, void* data) const {
  Hdf5Handle dataset(H5Dopen2(file_.id(), (path_ + "/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  Hdf5Handle stored(H5Dget_type(dataset.id()), H5Tclose);
  if (H5Tequal(stored.id(), type.file) <= 0) fail(name, "contains another type of value");
  if (H5Dread(dataset.id(), type.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
    fail(name, "cannot be read");
}

std::vector<std::string> Hdf5Reader::read_texts(const std::string& name, std::size_t dimensions) const {
  const std::vector<hsize_t> shape = shape_of(name, dimensions);
  Hdf5Handle dataset(H5Dopen2(file_.id(), (path_ + "/" + name).c_str(), H5P_DEFAULT), H5Dclose);
  Hdf5Handle stored(H5Dget_type(dataset.id()), H5Tclose), type(text_type(), H5Tclose);
  if (!is_text(stored.id())) fail(name, "is not a text");
  std::vector<char*> raw(shape.empty() ? 1 : shape[0], nullptr);
  std::vector<std::string> texts(raw.size());
  if (raw.empty()) return texts;
  if (H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, raw.data()) < 0)
    fail(name, "cannot be read");
  for (std::size_t n = 0; n < raw.size(); ++n)
    if (raw[n] != nullptr) texts[n] = raw[n];
  Hdf5Handle space(H5Dget_space(dataset.id()), H5Sclose);
  H5Dvlen_reclaim(type.id(), space.id(), H5P_DEFAULT, raw.data());
  return texts;
}

void Hdf5Reader::field(const std::string& name, std::string& text, const char*, const char*) {
  text = read_texts(name, 0).front();
}

void Hdf5Reader::field(const std::string& name, std::vector<std::string>& texts, const char*, const char*) {
  texts = read_texts(name, 1);
}

bool Hdf5Reader::has_group(const std::string& name) const {
  return H5Lexists(file_.id(), (path_ + "/" + name).c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::members() const {
  Hdf5Handle group(H5Gopen2(file_.id(), path_.c_str(), H5P_DEFAULT), H5Gclose);
  H5G_info_t info;
  if (!group.valid() || H5Gget_info(group.id(), &info) < 0)
    throw ResultError(file_name_ + ": group " + path_ + " is missing; the file is damaged");
  std::vector<std::string> names;
  for (hsize_t n = 0; n < info.nlinks; ++n) {
    const auto name_into = [&](char* buffer, std::size_t size) {
      return H5Lget_name_by_idx(group.id(), ".", H5_INDEX_CRT_ORDER, H5_ITER_INC, n, buffer, size,
                                H5P_DEFAULT);
    };
    const ssize_t length = name_into(nullptr, 0);
    if (length < 0) fail("", "cannot be listed");
    std::string name(static_cast<std::size_t>(length) + 1, '\0');
    name_into(name.data(), name.size());
    name.pop_back();
    names.push_back(name);
  }
  return names;
}

std::string Hdf5Reader::file_text(const char* name) const {
  if (H5Aexists(file_.id(), name) <= 0) return {};
  Hdf5Handle attribute(H5Aopen(file_.id(), name, H5P_DEFAULT), H5Aclose);
  Hdf5Handle stored(H5Aget_type(attribute.id()), H5Tclose), type(text_type(), H5Tclose);
  char* raw = nullptr;
  if (!is_text(stored.id()) || H5Aread(attribute.id(), type.id(), &raw) < 0 || raw == nullptr) return {};
  const std::string text = raw;
  H5free_memory(raw);
  return text;
}

int Hdf5Reader::file_number(const char* name) const {
  int value = -1;
  if (H5Aexists(file_.id(), name) <= 0) return value;
  Hdf5Handle attribute(H5Aopen(file_.id(), name, H5P_DEFAULT), H5Aclose);
  Hdf5Handle stored(H5Aget_type(attribute.id()), H5Tclose);
  if (H5Tget_class(stored.id()) != H5T_INTEGER || H5Aread(attribute.id(), H5T_NATIVE_INT, &value) < 0)
    return -1;
  return value;
}

}  // namespace diefill::results
