// What results.h5 is not read from and not written to, and what is said of it.
#include <gtest/gtest.h>

#include <cstring>
#include <fstream>

#include "process/results/storage/result_file.h"
#include "process/results/storage/schema.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;
using support::contents;

void put(const fs::path& file, const std::string& text) {
  std::ofstream(file, std::ios::binary | std::ios::trunc) << text;
}

std::string message_of_reading(const fs::path& directory) {
  try {
    read_results(directory);
  } catch (const ResultError& error) {
    return error.what();
  }
  return {};
}

TEST(ResultFile, MissingFileIsNamed) {
  const support::TemporaryFolder scratch;
  EXPECT_NE(message_of_reading(scratch.path()).find((scratch.path() / "results.h5").string()),
            std::string::npos);
  EXPECT_NE(message_of_reading(scratch.path()).find("no such results file"), std::string::npos);
}

TEST(ResultFile, OfARunThatHasNotEndedIsAwaited) {
  const support::TemporaryFolder scratch;
  put(scratch.path() / "checkpoint.bin", "state");
  EXPECT_NE(message_of_reading(scratch.path()).find("has not reached its end"), std::string::npos);
  EXPECT_NE(message_of_reading(scratch.path()).find("diefill run --resume"), std::string::npos);
}

/// A file of an earlier version has no hash of its contents at its end; nothing says that there was one.
std::string without_hash(std::string text) {
  const std::string mark = "hash_at_end";
  text.resize(text.rfind("\ndiefill: FNV-1a"));
  return text.replace(text.find(mark), mark.size(), "other_thing");
}

TEST(ResultFile, ForeignFilesAreRefused) {
  const support::TemporaryFolder scratch;
  const fs::path file = scratch.path() / "results.h5";
  put(file, "time,mass\n0,1\n");
  EXPECT_NE(message_of_reading(scratch.path()).find("not an HDF5 file"), std::string::npos);
  write_results(scratch.path(), sample_result());
  std::string text = without_hash(contents(file));
  text.replace(text.find(kFormat), std::strlen(kFormat), "another format!");
  put(file, text);
  EXPECT_NE(message_of_reading(scratch.path()).find("not diefill results"), std::string::npos);
}

TEST(ResultFile, OtherSchemaVersionsAreRefused) {
  const support::TemporaryFolder scratch;
  const fs::path file = scratch.path() / "results.h5";
  write_results(scratch.path(), sample_result());
  std::string text = without_hash(contents(file));
  // An attribute message: name, type and dataspace, 16 + 16 + 8 bytes here, then the number itself.
  const std::size_t number = text.find("schema_version") + 40;
  ASSERT_EQ(text.substr(number, 4), std::string("\6\0\0\0", 4));
  text[number] = 99;
  put(file, text);
  EXPECT_NE(message_of_reading(scratch.path()).find("schema version 99"), std::string::npos);
  text[number] = 0;
  put(file, text);
  EXPECT_NE(message_of_reading(scratch.path()).find("schema version 0"), std::string::npos);
}

TEST(ResultFile, TruncatedFilesAreRefused) {
  const support::TemporaryFolder scratch;
  const fs::path file = scratch.path() / "results.h5";
  write_results(scratch.path(), sample_result());
  const std::string whole = contents(file);
  for (const double share : {0.0, 0.1, 0.5, 0.9, 0.9999}) {
    put(file, whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size()))));
    EXPECT_NE(message_of_reading(scratch.path()), "") << share;
  }
}

TEST(ResultFile, DamagedBytesAreNoticed) {
  const support::TemporaryFolder scratch;
  const fs::path file = scratch.path() / "results.h5";
  write_results(scratch.path(), sample_result(40000));
  std::string text = contents(file);
  for (std::size_t n = text.size() / 2; n < text.size() / 2 + 64; ++n)
    text[n] = static_cast<char>(text[n] ^ 0x55);
  put(file, text);
  EXPECT_NE(message_of_reading(scratch.path()), "");
}

TEST(ResultFile, ArraysThatDoNotBelongTogetherAreRefused) {
  const support::TemporaryFolder scratch;
  FillResult result = sample_result();
  result.powder.velocity.pop_back();
  EXPECT_THROW(write_results(scratch.path(), result), ResultError);
  result = sample_result();
  result.maps[0].value.pop_back();
  EXPECT_THROW(write_results(scratch.path(), result), ResultError);
  result = sample_result();
  result.tools[0].triangles[0][1] = 4;
  EXPECT_THROW(write_results(scratch.path(), result), ResultError);
  EXPECT_FALSE(fs::exists(scratch.path() / "results.h5"));
}

TEST(ResultFile, FiguresNeedNamesThatFitAPath) {
  const support::TemporaryFolder scratch;
  FillResult result = sample_result();
  result.figures["mass/volume"] = 1;
  EXPECT_THROW(write_results(scratch.path(), result), ResultError);
}

}  // namespace
}  // namespace diefill::results
