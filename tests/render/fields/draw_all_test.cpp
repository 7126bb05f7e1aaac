#include <cstdlib>
#include <set>

#include "render/fields/pictures.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::test {
namespace {

using DrawAll = Drawing;

std::vector<std::string> names_of(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> names;
  for (const auto& path : paths) names.push_back(path.filename().string());
  return names;
}

TEST_F(DrawAll, RingGivesFourPicturesAndNothingElse) {
  const auto folder = file("ring");
  std::filesystem::create_directory(folder);
  const auto written = draw_all(folder, make_ring());
  EXPECT_EQ(names_of(written),
            (std::vector<std::string>{"density_map.png", "section.png", "snapshot.png", "fill_level.png"}));
  int files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    ++files;
    EXPECT_FALSE(QImage(QString::fromStdString(entry.path().string())).isNull()) << entry.path();
  }
  EXPECT_EQ(files, 4);
}

TEST_F(DrawAll, DieThatIsNoRingIsSeenFromAboveAndNoPictureComesTwice) {
  const auto folder = file("slit");
  std::filesystem::create_directory(folder);
  auto result = make_ring();
  result.cavity.is_ring = false;
  const auto section = result.sections.front().field;
  results::Field2D plan{"solid fraction", "x",           "mm", "y", "mm", section.first,
                        section.second,   section.value, 1e-3};
  results::Field2D level = plan;
  level.quantity = "fill level";
  for (double& value : level.value) value *= 40;
  result.maps = {plan, level};
  result.profiles = {{"solid fraction", "", "height", "mm", {0, 10, 20}, {0.3, 0.34, 0.36}},
                     {"solid fraction, cavity 2", "", "height", "mm", {0, 10, 20}, {0.4, 0.44, 0.46}},
                     {"fill level, cavity 2", "mm", "way", "mm", {0, 8, 16}, {10, 12, 14}}};
  result.other_cavities = {result.cavity};
  result.sections.push_back(result.sections.front());  // asked for twice
  const auto written = draw_all(folder, result);
  EXPECT_EQ(names_of(written),
            (std::vector<std::string>{"plan_map.png", "fill_level_map.png", "section.png", "snapshot.png",
                                      "height_profile.png", "height_profile_cavity_2.png",
                                      "fill_level_cavity_2.png"}));
  EXPECT_EQ(drawn_profiles(result).size(), result.profiles.size());
  std::set<std::string> pictures;
  for (const auto& picture : written) EXPECT_TRUE(pictures.insert(contents(picture)).second) << picture;
}

TEST_F(DrawAll, EverySectionHasAPictureOfItsOwn) {
  const auto folder = file("sections");
  std::filesystem::create_directory(folder);
  auto result = make_ring();
  result.sections.push_back(result.sections.front());
  result.sections.back().plane.origin += 3e-3 * result.sections.back().plane.normal;
  result.sections.push_back(result.sections.front());
  result.sections.back().field = {};  // no powder near it
  draw_all(folder, result);
  EXPECT_TRUE(std::filesystem::exists(folder / "section_2.png"));
  EXPECT_FALSE(std::filesystem::exists(folder / "section_3.png"));
  EXPECT_NE(contents(folder / "section.png"), contents(folder / "section_2.png"));
}

TEST_F(DrawAll, PicturesThereBeforeAreReplaced) {
  const auto folder = file("again");
  std::filesystem::create_directory(folder);
  auto result = make_ring();
  draw_all(folder, result);
  const auto before = contents(folder / "density_map.png");
  result.strategy = "6 passages at 0.1 m/s";
  draw_all(folder, result);
  EXPECT_NE(contents(folder / "density_map.png"), before);
}

TEST_F(DrawAll, NothingNeedsADisplay) {
  EXPECT_EQ(std::getenv("DISPLAY"), nullptr);
}

}  // namespace
}  // namespace diefill::render::test
