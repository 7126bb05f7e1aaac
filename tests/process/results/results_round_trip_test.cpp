// results.h5 gives back every bit of what was stored.
#include <gtest/gtest.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>

#include "process/results/storage/result_file.h"
#include "process/results/storage/schema.h"
#include "process/results/storage/shown_instants.h"
#include "tests/process/results_sample.h"
#include "tests/support/temporary_folder.h"

namespace diefill::results {
namespace {

namespace fs = std::filesystem;
using support::contents;

/// Writes every value, in the order of the schema, into one string of bytes: equal strings are equal results,
/// NaNs and signs of zero included.
class ByteArchive {
 public:
  template <class T>
  void field(const std::string& name, const T& value, const char*, const char*) {
    bytes += name;
    add(value);
  }
  template <class Body>
  void group(const std::string& name, const char*, Body body) {
    bytes += name;
    body();
  }
  template <class Body>
  void optional_group(const std::string& name, const char* description, bool, Body body) {
    group(name, description, body);
  }
  template <class Item, class NameOf, class Body>
  void list(const std::string&, const char*, const std::vector<Item>& items, NameOf, Body body) {
    add(items.size());
    for (const Item& item : items) body(item);
  }
  template <class Item, class NameOf, class Body>
  void optional_list(const std::string& name, const char* description, const std::vector<Item>& items,
                     NameOf name_of, Body body) {
    list(name, description, items, name_of, body);
  }
  template <class MeaningOf>
  void numbers(const std::string&, const char*, const std::map<std::string, double>& values, MeaningOf) {
    for (const auto& [name, value] : values) {
      bytes += name;
      add(value);
    }
  }
  std::string bytes;

 private:
  template <class T>
  void add(const T& value) {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
  }
  void add(const std::string& text) {
    add(text.size());
    bytes += text;
  }
  template <class T>
  void add(const std::vector<T>& values) {
    add(values.size());
    for (const T& value : values) add(value);
  }
};

std::string bytes_of(const FillResult& result) {
  ByteArchive archive;
  describe(archive, result);
  return archive.bytes;
}

TEST(ResultFile, GivesBackEveryBit) {
  const support::TemporaryFolder scratch;
  const FillResult result = sample_result();
  write_results(scratch.path(), result);
  const FillResult back = read_results(scratch.path());
  EXPECT_TRUE(bytes_of(back) == bytes_of(result));
  EXPECT_EQ(back.tools[1].name, "a/b c");
  EXPECT_EQ(back.tools[2].name, "a_b c");  // both make the same group name
  EXPECT_EQ(back.figures.at("steps"), 123456789);
  EXPECT_TRUE(std::signbit(back.powder.velocity[0].z()));
}

TEST(ResultFile, GivesBackKindsOfGrains) {
  const support::TemporaryFolder scratch;
  FillResult result = sample_result();
  result.powder.kinds = {{1e-3, 2e-3},
                         {5e-4, 1e-3},
                         {1e-6, 8e-6},
                         {5e-10, 4e-9},
                         {"fine", "coarse"},
                         {1, 2},
                         {Eigen::Vector3d::Zero(), {0, 0, 5e-4}, {0, 0, -5e-4}},
                         {5e-4, 1e-3, 9e-4}};
  result.powder.kind = {0, 1, 1, 0, 1};
  for (auto& instant : result.instants) instant.kind.assign(instant.id.size(), 1);
  write_results(scratch.path(), result);
  const FillResult back = read_results(scratch.path());
  EXPECT_TRUE(bytes_of(back) == bytes_of(result));
  EXPECT_EQ(back.powder.diameter_of(2), 2e-3);
  EXPECT_EQ(back.powder.kinds.material[1], "coarse");
  EXPECT_EQ(back.powder.sizes_text(), "1 to 2 mm");
  result.powder.kind[3] = 2;
  EXPECT_THROW(write_results(scratch.path(), result), ResultError);
}

TEST(ResultFile, KindsOfInstantsStayWhereAllGrainsHaveGoneInTheEnd) {
  const support::TemporaryFolder scratch;
  FillResult result;
  result.powder.kinds = {{1e-3, 2e-3}, {5e-4, 1e-3}, {1e-6, 8e-6}, {5e-10, 4e-9}, {"a", "b"}, {}, {}, {}};
  Instant instant;
  instant.id = {7};
  instant.position = {{0, 0, 1e-3}};
  instant.orientation = {{1, 0, 0, 0}};
  instant.velocity = {{0, 0, 0}};
  instant.kind = {1};
  result.instants = {instant};
  write_results(scratch.path(), result);
  const FillResult back = read_results(scratch.path());
  EXPECT_FALSE(back.powder.monodisperse());
  EXPECT_EQ(back.powder.kinds.material, (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ(back.instants.at(0).kind, std::vector<std::uint8_t>{1});
}

TEST(ResultFile, GivesBackSeveralCavitiesInTheirOrder) {
  const support::TemporaryFolder scratch;
  FillResult result = sample_result();
  ASSERT_TRUE(result.other_cavities.empty());
  for (int n = 0; n < 12; ++n) {
    result.other_cavities.push_back(result.cavity);
    result.other_cavities.back().volume = 1e-6 / (n + 1);
  }
  write_results(scratch.path(), result);
  const FillResult back = read_results(scratch.path());
  ASSERT_EQ(back.other_cavities.size(), 12U);
  for (std::size_t n = 0; n < 12; ++n)
    EXPECT_EQ(back.other_cavities[n].volume, result.other_cavities[n].volume);
  EXPECT_TRUE(bytes_of(back) == bytes_of(result));
}

TEST(ResultFile, NeedsNoInstants) {
  const support::TemporaryFolder scratch;
  FillResult result = sample_result();
  result.instants.clear();
  write_results(scratch.path(), result);
  EXPECT_TRUE(read_results(scratch.path()).instants.empty());
}

TEST(ResultFile, InstantsNeedAPoseForEveryTool) {
  const support::TemporaryFolder scratch;
  FillResult result = sample_result();
  result.instants.front().tool_displacement.pop_back();
  EXPECT_THROW(write_results(scratch.path(), result), ResultError);
}

TEST(ResultFile, GivesBackManyGrains) {
  const support::TemporaryFolder scratch;
  const FillResult result = sample_result(40000);  // several chunks
  write_results(scratch.path(), result);
  EXPECT_TRUE(bytes_of(read_results(scratch.path())) == bytes_of(result));
}

TEST(ResultFile, GivesBackAnEmptyResult) {
  const support::TemporaryFolder scratch;
  write_results(scratch.path(), FillResult{});
  EXPECT_TRUE(bytes_of(read_results(scratch.path())) == bytes_of(FillResult{}));
}

TEST(ResultFile, IsTheSameFileForTheSameResult) {
  const support::TemporaryFolder scratch;
  write_results(scratch.path() / "a", sample_result());
  std::this_thread::sleep_for(std::chrono::milliseconds(1100));  // HDF5 keeps times in whole seconds
  write_results(scratch.path() / "b", sample_result());
  EXPECT_TRUE(contents(scratch.path() / "a" / "results.h5") == contents(scratch.path() / "b" / "results.h5"));
}

/// Looks at units and descriptions only.
class MeaningArchive {
 public:
  template <class T>
  void field(const std::string& name, const T&, const char* unit, const char* description) {
    EXPECT_STRNE(unit, "") << name;
    EXPECT_GT(std::strlen(description), 4u) << name;
    ++fields;
  }
  template <class Body>
  void group(const std::string&, const char*, Body body) {
    body();
  }
  template <class Body>
  void optional_group(const std::string&, const char*, bool, Body body) {
    body();
  }
  template <class Item, class NameOf, class Body>
  void list(const std::string&, const char*, const std::vector<Item>& items, NameOf, Body body) {
    for (const Item& item : items) body(item);
  }
  template <class Item, class NameOf, class Body>
  void optional_list(const std::string& name, const char* description, const std::vector<Item>& items,
                     NameOf name_of, Body body) {
    list(name, description, items, name_of, body);
  }
  template <class MeaningOf>
  void numbers(const std::string&, const char*, const std::map<std::string, double>& values,
               MeaningOf meaning_of) {
    for (const auto& [name, value] : values)
      field(name, value, meaning_of(name).first, meaning_of(name).second);
  }
  int fields = 0;
};

TEST(ResultFile, SaysUnitAndMeaningOfEveryDataset) {
  MeaningArchive archive;
  const FillResult result = sample_result();
  describe(archive, result);
  EXPECT_GT(archive.fields, 100);
}

TEST(FigureMeaning, TakesTheUnitFromTheName) {
  EXPECT_STREQ(figure_meaning("filled_mass_kg").first, "kg");
  EXPECT_STREQ(figure_meaning("sphere_steps_per_second").first, "1/s");
  EXPECT_STREQ(figure_meaning("settling_seconds").first, "s");
  EXPECT_STREQ(figure_meaning("shoe_speed_m_s").first, "m/s");
  EXPECT_STREQ(figure_meaning("level_mm").first, "mm");
  EXPECT_STREQ(figure_meaning("coordination").first, "1");
}

/// Lets no file of this process grow beyond a size while it lives, as a full disk would.
class SmallFilesOnly {
 public:
  explicit SmallFilesOnly(rlim_t bytes) : signal_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit small{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &small);
  }
  ~SmallFilesOnly() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, signal_);
  }
  SmallFilesOnly(const SmallFilesOnly&) = delete;
  SmallFilesOnly& operator=(const SmallFilesOnly&) = delete;

 private:
  void (*signal_)(int);
  rlimit before_{};
};

TEST(ResultFile, OutlivesAFullDisk) {
  const support::TemporaryFolder scratch;
  write_results(scratch.path(), sample_result());
  FillResult larger = sample_result(2000);
  {
    const SmallFilesOnly full(20000);
    EXPECT_THROW(write_results(scratch.path(), larger), ResultError);
  }
  EXPECT_TRUE(bytes_of(read_results(scratch.path())) == bytes_of(sample_result()));
  EXPECT_EQ(std::distance(fs::directory_iterator(scratch.path()), {}), 2);  // results.h5 and results.xdmf
}

TEST(ResultXdmf, PointsAtSpheresAndTriangles) {
  const support::TemporaryFolder scratch;
  write_results(scratch.path(), sample_result(5));
  const std::string text = contents(scratch.path() / "results.xdmf");
  const auto has = [&](const std::string& part) { return text.find(part) != std::string::npos; };
  EXPECT_TRUE(has(
      "Dimensions=\"15 3\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">results.h5:/spheres/centre<"));
  EXPECT_TRUE(has(
      "Dimensions=\"15\" NumberType=\"Float\" Precision=\"8\" Format=\"HDF\">results.h5:/spheres/radius<"));
  EXPECT_TRUE(has("results.h5:/spheres/solid_fraction<"));
  EXPECT_TRUE(
      has("Dimensions=\"4 3\" NumberType=\"Int\" Precision=\"4\" "
          "Format=\"HDF\">results.h5:/tools/die/triangles<"));
  EXPECT_TRUE(has("results.h5:/tools/a_b_c/vertices<"));
  EXPECT_FALSE(has("a_b_c_2"));  // that tool has no triangles
}

TEST(ResultXdmf, HoldsAllInstantsWithMovingToolsAndTheSolidShare) {
  const support::TemporaryFolder scratch;
  write_results(scratch.path(), sample_result(5));
  const std::string text = contents(scratch.path() / "results.xdmf");
  const auto count = [&](const std::string& part) {
    int found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
  };
  EXPECT_EQ(count("<Time Value="), 3);
  EXPECT_EQ(count("Name=\"powder\""), 3);
  EXPECT_EQ(count("Name=\"solid share\""), 3);
  EXPECT_EQ(count("Name=\"spheres\""), 1);
  EXPECT_EQ(count("results.h5:/instants/instant_2/position<"), 1);
  EXPECT_EQ(count("results.h5:/shown/instant/tools/die<"), 1);  // it moved
  EXPECT_EQ(count("results.h5:/tools/die/vertices<"), 1);       // at the end
  EXPECT_LT(text.find("<Time Value=\"0.10000000000000001\""),
            text.find("<Time Value=\"0.20000000000000001\""));
}

TEST(ResultXdmf, SolidShareHasTheVolumeOfTheGrainsInside) {
  FillResult result = sample_result(5);
  result.cavity.lower_corner = {-5e-3, -5e-3, -5e-3};
  result.cavity.upper_corner = {5e-3, 5e-3, 5e-3};
  const ShownGrid grid = shown_grid(result);
  const auto instants = shown_instants(result, grid);
  ASSERT_EQ(instants.size(), 3U);
  double solid = 0;
  for (const double share : instants.back().solid_share) solid += share * std::pow(grid.spacing, 3);
  EXPECT_NEAR(solid / (5 * result.powder.grain_solid_volume), 1, 1e-12);
}

}  // namespace
}  // namespace diefill::results
