#include "process/results/storage/result_file.h"

#include <new>

#include "process/results/storage/atomic_file.h"
#include "process/results/storage/group_names.h"
#include "process/results/storage/hashed_file.h"
#include "process/results/storage/hdf5_read.h"
#include "process/results/storage/hdf5_write.h"
#include "process/results/storage/result_check.h"
#include "process/results/storage/schema.h"
#include "process/results/storage/shown_instants.h"
#include "process/results/storage/sphere_view.h"
#include "process/results/storage/unhashed_file.h"
#include "process/results/storage/xdmf.h"

namespace diefill::results {
namespace {

constexpr const char* kFileName = "results.h5";
constexpr const char* kSealed = "hash_at_end";  // attribute: the file ends in a hash of its contents

void make_directory(const std::filesystem::path& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error)
    throw ResultError("cannot create the directory " + directory.string() + ": " + error.message() +
                      "; choose a writable directory");
}

/// Derived from the rest and not read back.
void write_spheres(Hdf5Writer& file, const FillResult& result) {
  const SphereView view = view_spheres(result);
  file.group("spheres", "basic spheres one by one, derived from /powder for results.xdmf", [&] {
    file.field("centre", view.centre, "m", "sphere centres, laboratory frame");
    file.field("radius", view.radius, "m", "sphere radii");
    file.field("solid_fraction", view.solid_fraction, "1",
               "solid fraction of the sphere's grain; NaN: open cell");
    file.field("grain", view.grain, "1", "id of the sphere's grain");
  });
}

/// The same over time.
void write_shown(Hdf5Writer& file, const FillResult& result, const std::vector<ShownInstant>& instants) {
  const auto names = shown_names(result);
  std::vector<std::string> tools;
  for (const ToolState& tool : result.tools) tools.push_back(tool.name);
  tools = group_names(tools);
  file.group("shown", "every instant, and the end, derived for results.xdmf", [&] {
    for (std::size_t n = 0; n < instants.size(); ++n)
      file.group(names[n], "", [&] {
        file.field("diameter", instants[n].diameter, "m", "diameter of each grain");
        if (!instants[n].solid_share.empty())
          file.field("solid_share", instants[n].solid_share, "1",
                     "solid volume over volume of each cell of the grid in results.xdmf, x fastest");
        file.group("tools", "vertices of the tools that stand elsewhere than in /tools", [&] {
          for (std::size_t t = 0; t < tools.size(); ++t)
            if (!instants[n].vertices[t].empty())
              file.field(tools[t], instants[n].vertices[t], "m", "mesh vertices, laboratory frame");
        });
      });
  });
}

std::string file_image(const FillResult& result, const std::vector<ShownInstant>& instants) {
  Hdf5Writer file;
  file.file_attribute("format", kFormat);
  file.file_attribute("schema_version", kSchemaVersion);
  file.file_attribute(kSealed, 1);
  file.file_attribute("program_version", result.program_version);
  file.file_attribute(
      "description",
      "Result of a simulated die filling in SI units unless a dataset's attribute `unit` says "
      "otherwise; every dataset is described by its attribute `description`.");
  describe(file, result);
  write_spheres(file, result);
  write_shown(file, result, instants);
  return file.finish();
}

/// Throws unless the file holds results of a version that can be read.
void check_format(Hdf5Reader& file, const std::filesystem::path& path) {
  if (file.file_text("format") != kFormat)
    throw ResultError(path.string() + ": an HDF5 file, but not diefill results; give another directory");
  const int version = file.file_number("schema_version");
  if (version < kOldestSchemaVersion || version > kSchemaVersion)
    throw ResultError(path.string() + ": results of schema version " + std::to_string(version) +
                      ", but this program reads versions " + std::to_string(kOldestSchemaVersion) + " to " +
                      std::to_string(kSchemaVersion) + "; run the scene again with this program");
  if (version < kSchemaVersion) file.allow_missing_lists();
}

FillResult described_in(Hdf5Reader& file, const std::filesystem::path& path) {
  check_format(file, path);
  FillResult result;
  describe(file, result);
  try {
    check_lengths(result);
  } catch (const ResultError& error) {
    throw ResultError(path.string() + ": damaged: " + error.what() + "; run the scene again");
  }
  return result;
}

/// Results of an earlier version, which had no hash of their contents, as the image of a file that this
/// version writes.
std::string earlier_image(const std::filesystem::path& path) {
  Hdf5Reader file(path);
  check_format(file, path);
  if (file.file_number(kSealed) == 1)
    throw ResultError(path.string() +
                      ": damaged or truncated: the hash at its end is missing; run the scene again");
  return file_image(described_in(file, path), {});
}

/// Why there is no results file.
std::string absence(const std::filesystem::path& path) {
  std::error_code error;
  if (std::filesystem::exists(path.parent_path() / "checkpoint.bin", error))
    return path.string() +
           ": no results yet: the run in this directory has not reached its end; wait if it is running, else "
           "continue it with diefill run --resume";
  return path.string() + ": no such results file; run the scene first or give another directory";
}

FillResult read_checked(const std::filesystem::path& path) {
  std::error_code error;
  if (const auto directory = path.parent_path(); std::filesystem::is_regular_file(directory, error))
    throw ResultError(directory.string() + ": is a file; give the directory that holds results.h5");
  if (!std::filesystem::is_regular_file(path, error)) throw ResultError(absence(path));
  if (ends_in_hash(path)) {
    const auto contents = read_hashed(path);
    if (!contents)
      throw ResultError(path.string() +
                        ": damaged: its contents do not match their hash; run the scene again");
    Hdf5Reader file(path, *contents);
    return described_in(file, path);
  }
  const std::string image = read_in_child(path, [&] { return earlier_image(path); });
  Hdf5Reader file(path, image);
  FillResult result = described_in(file, path);
  result.warnings.emplace_back(
      "these results were written by an earlier version without a hash: damaged numbers would go unnoticed");
  return result;
}

}  // namespace

void write_results(const std::filesystem::path& directory, const FillResult& result) {
  check_lengths(result);
  make_directory(directory);
  const ShownGrid grid = shown_grid(result);
  const auto instants = shown_instants(result, grid);
  write_text_atomically(directory / kFileName, with_hash(file_image(result, instants)));
  write_text_atomically(directory / "results.xdmf", xdmf_text(result, instants, grid, kFileName));
}

FillResult read_results(const std::filesystem::path& directory) {
  const std::filesystem::path path = directory / kFileName;
  try {
    return read_checked(path);
  } catch (const std::bad_alloc&) {
    throw ResultError(path.string() + ": does not fit into memory or is damaged");
  } catch (const std::length_error&) {
    throw ResultError(path.string() + ": an array has an impossible length; the file is damaged");
  }
}

}  // namespace diefill::results
