#include <cstdlib>

#include "render/pictures.h"
#include "tests/render/drawing_test.h"
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

TEST_F(DrawAll, DieThatIsNoRingShowsItsSectionAsMap) {
  const auto folder = file("slit");
  std::filesystem::create_directory(folder);
  auto result = make_ring();
  result.maps.clear();
  result.profiles.clear();
  const auto written = draw_all(folder, result);
  EXPECT_EQ(names_of(written), (std::vector<std::string>{"density_map.png", "section.png", "snapshot.png"}));
  EXPECT_EQ(contents(folder / "density_map.png"), contents(folder / "section.png"));
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
