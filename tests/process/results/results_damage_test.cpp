// Whatever happens to the bytes of results.h5, reading it gives what was written or one line that says that
// it is damaged.
#include <gtest/gtest.h>

#include <fstream>
#include <random>

#include "process/results/storage/hashed_file.h"
#include "process/results/storage/result_file.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;
using support::contents;

class DamagedResults : public testing::Test {
 protected:
  DamagedResults() {
    write_results(folder_.path(), sample_result());
    whole_ = contents(file());
    seal_ = whole_.rfind("\ndiefill: FNV-1a");
  }
  fs::path file() const { return folder_.path() / "results.h5"; }
  /// What is said of the file when it holds these bytes; empty: it was read.
  std::string complaint_about(const std::string& bytes) const {
    std::ofstream(file(), std::ios::binary | std::ios::trunc) << bytes;
    try {
      read_results(folder_.path());
      return {};
    } catch (const ResultError& error) {
      return error.what();
    }
  }
  void expect_refused(const std::string& bytes, const std::string& what) const {
    const std::string complaint = complaint_about(bytes);
    EXPECT_NE(complaint.find(file().string()), std::string::npos) << what << ": " << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << what << ": " << complaint;
  }
  std::string flipped(std::size_t place, int bit) const {
    std::string bytes = whole_;
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << bit));
    return bytes;
  }

  support::TemporaryFolder folder_;
  std::string whole_;
  std::size_t seal_ = 0;
};

TEST_F(DamagedResults, AnyFlippedBitIsNoticed) {
  std::mt19937 random(12);
  std::uniform_int_distribution<int> bit(0, 7);
  for (std::size_t place = 0; place < seal_; place += 1 + seal_ / 400)
    expect_refused(flipped(place, bit(random)), "byte " + std::to_string(place));
  for (std::size_t place = seal_; place < whole_.size(); place += 2)
    expect_refused(flipped(place, bit(random)), "byte " + std::to_string(place));
}

TEST_F(DamagedResults, AFlippedBitOfASingleNumberIsNoticed) {
  const double mass = sample_result().figures.at("filled_mass_kg");
  const std::size_t place = whole_.find(std::string(reinterpret_cast<const char*>(&mass), sizeof mass));
  ASSERT_NE(place, std::string::npos) << "a scalar is not compressed";
  EXPECT_NE(complaint_about(flipped(place + 6, 3)).find("damaged"), std::string::npos);
}

TEST_F(DamagedResults, FilesCutShortOrContinuedAreNoticed) {
  for (const std::size_t length :
       {std::size_t{0}, std::size_t{7}, whole_.size() / 2, seal_ - 1, seal_, whole_.size() - 1})
    expect_refused(whole_.substr(0, length), std::to_string(length) + " bytes");
  expect_refused(whole_ + '\n', "a byte more");
  expect_refused(whole_ + whole_, "twice");
}

/// Earlier versions wrote no hash: their files are read, and told apart from damaged ones of this version.
TEST_F(DamagedResults, FilesOfEarlierVersionsAreReadWithANote) {
  const std::string mark = "hash_at_end";
  std::string earlier = whole_.substr(0, seal_);
  earlier.replace(earlier.find(mark), mark.size(), "other_thing");
  ASSERT_EQ(complaint_about(earlier), "");
  const FillResult result = read_results(folder_.path());
  EXPECT_EQ(result.figures.at("steps"), 123456789);
  EXPECT_NE(result.warnings.back().find("earlier version"), std::string::npos) << result.warnings.back();
  // Damage there may go unnoticed, but takes nobody down.
  std::mt19937 random(13);
  std::uniform_int_distribution<std::size_t> anywhere(0, earlier.size() - 1);
  for (int n = 0; n < 40; ++n) {
    std::string bytes = earlier;
    const std::size_t place = anywhere(random);
    bytes[place] = static_cast<char>(bytes[place] ^ (1 << (n % 8)));
    EXPECT_EQ(complaint_about(bytes).find('\n'), std::string::npos);
  }
}

TEST(SealedFile, GivesBackWhatWasWrittenAndNothingElse) {
  const support::TemporaryFolder folder;
  const std::string text("\0 any bytes \n", 13);
  folder.write("file", with_hash(text));
  EXPECT_TRUE(ends_in_hash(folder.path() / "file"));
  EXPECT_EQ(read_hashed(folder.path() / "file"), text);
  folder.write("file", text);
  EXPECT_FALSE(ends_in_hash(folder.path() / "file"));
}

}  // namespace
}  // namespace diefill::results
