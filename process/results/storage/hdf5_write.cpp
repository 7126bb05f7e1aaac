#include "process/results/storage/hdf5_write.h"

#include <algorithm>

namespace diefill::results {
namespace {

constexpr std::size_t kImageGrowth = std::size_t{1} << 20;  // bytes the image grows by
constexpr hsize_t kChunkNumbers = 65536;                    // numbers in a compressed chunk
constexpr unsigned kDeflateLevel = 4;

void require(bool worked, const std::string& what) {
  if (!worked) throw ResultError("HDF5 failed to " + what);
}

hid_t create_image() {
  Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  require(access.valid() && H5Pset_fapl_core(access.id(), kImageGrowth, false) >= 0,
          "prepare a file in memory");
  Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE), H5Pclose);
  require(creation.valid(), "prepare a file in memory");
  return H5Fcreate("results.h5", H5F_ACC_TRUNC, creation.id(), access.id());
}

void attach_text(hid_t object, const char* name, const char* text) {
  Hdf5Handle type(text_type(), H5Tclose), space(H5Screate(H5S_SCALAR), H5Sclose);
  Hdf5Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
  require(attribute.valid() && H5Awrite(attribute.id(), type.id(), &text) >= 0,
          std::string("attach ") + name);
}

/// Without the time of writing: the same result makes the same file.
hid_t dataset_creation() {
  const hid_t creation = H5Pcreate(H5P_DATASET_CREATE);
  require(creation >= 0 && H5Pset_obj_track_times(creation, false) >= 0, "prepare a dataset");
  return creation;
}

/// Compression, and a checksum that tells a damaged chunk from data. Scalars and empty arrays have no chunks.
void set_chunks(hid_t creation, const std::vector<hsize_t>& shape) {
  if (shape.empty() || std::find(shape.begin(), shape.end(), hsize_t{0}) != shape.end()) return;
  std::vector<hsize_t> chunk = shape;
  chunk[0] = std::min(shape[0], std::max<hsize_t>(1, kChunkNumbers / (shape.size() > 1 ? shape[1] : 1)));
  require(H5Pset_chunk(creation, static_cast<int>(chunk.size()), chunk.data()) >= 0 &&
              H5Pset_shuffle(creation) >= 0 && H5Pset_deflate(creation, kDeflateLevel) >= 0 &&
              H5Pset_fletcher32(creation) >= 0,
          "set up compression");
}

}  // namespace

Hdf5Writer::Hdf5Writer() : file_(create_image(), H5Fclose) {
  require(file_.valid(), "create a file in memory");
}

void Hdf5Writer::create_group(const char* description) {
  Hdf5Handle creation(H5Pcreate(H5P_GROUP_CREATE), H5Pclose);
  H5Pset_link_creation_order(creation.id(), H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED);
  H5Pset_obj_track_times(creation.id(), false);
  Hdf5Handle group(H5Gcreate2(file_.id(), path_.c_str(), H5P_DEFAULT, creation.id(), H5P_DEFAULT), H5Gclose);
  require(group.valid(), "create group " + path_);
  if (*description != '\0') attach_text(group.id(), "description", description);
}

void Hdf5Writer::check_key(const std::string& group, const std::string& key) {
  if (key.empty() || key == "." || key.find('/') != std::string::npos)
    throw ResultError("\"" + key + "\" cannot name a number in " + group +
                      ": it is empty, a dot or has a slash");
}

void Hdf5Writer::array(const std::string& name, NumberType type, const std::vector<hsize_t>& shape,
                       const void* data, const char* unit, const char* description) {
  const std::string path = path_ + "/" + name;
  Hdf5Handle space(shape.empty() ? H5Screate(H5S_SCALAR)
                                 : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                   H5Sclose);
  Hdf5Handle creation(dataset_creation(), H5Pclose);
  set_chunks(creation.id(), shape);
  Hdf5Handle dataset(
      H5Dcreate2(file_.id(), path.c_str(), type.file, space.id(), H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose);
  require(dataset.valid(), "create " + path);
  if (H5Sget_simple_extent_npoints(space.id()) > 0)
    require(H5Dwrite(dataset.id(), type.memory, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0, "write " + path);
  attach_text(dataset.id(), "unit", unit);
  attach_text(dataset.id(), "description", description);
  require(dataset.close(), "finish " + path);
}

void Hdf5Writer::texts(const std::string& name, hid_t space, const std::vector<const char*>& texts,
                       const char* unit, const char* description) {
  const std::string path = path_ + "/" + name;
  Hdf5Handle type(text_type(), H5Tclose), creation(dataset_creation(), H5Pclose);
  Hdf5Handle dataset(
      H5Dcreate2(file_.id(), path.c_str(), type.id(), space, H5P_DEFAULT, creation.id(), H5P_DEFAULT),
      H5Dclose);
  require(dataset.valid(), "create " + path);
  if (!texts.empty())
    require(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, texts.data()) >= 0,
            "write " + path);
  attach_text(dataset.id(), "unit", unit);
  attach_text(dataset.id(), "description", description);
  require(dataset.close(), "finish " + path);
}

void Hdf5Writer::field(const std::string& name, const std::string& text, const char* unit,
                       const char* description) {
  Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  texts(name, space.id(), {text.c_str()}, unit, description);
}

void Hdf5Writer::field(const std::string& name, const std::vector<std::string>& lines, const char* unit,
                       const char* description) {
  const hsize_t length = lines.size();
  Hdf5Handle space(H5Screate_simple(1, &length, nullptr), H5Sclose);
  std::vector<const char*> pointers;
  for (const auto& line : lines) pointers.push_back(line.c_str());
  texts(name, space.id(), pointers, unit, description);
}

void Hdf5Writer::file_attribute(const char* name, const std::string& text) {
  attach_text(file_.id(), name, text.c_str());
}

void Hdf5Writer::file_attribute(const char* name, int value) {
  Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  Hdf5Handle attribute(H5Acreate2(file_.id(), name, H5T_STD_I32LE, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                       H5Aclose);
  require(attribute.valid() && H5Awrite(attribute.id(), H5T_NATIVE_INT, &value) >= 0,
          std::string("attach ") + name);
}

std::string Hdf5Writer::finish() {
  require(H5Fflush(file_.id(), H5F_SCOPE_LOCAL) >= 0, "finish the file");
  const ssize_t size = H5Fget_file_image(file_.id(), nullptr, 0);
  require(size > 0, "measure the file");
  std::string image(static_cast<std::size_t>(size), '\0');
  require(H5Fget_file_image(file_.id(), image.data(), image.size()) == size, "copy the file");
  require(file_.close(), "close the file");
  return image;
}

}  // namespace diefill::results
