// The interactive view: which grains it shows, what the page's data say, and what the page allows.
#include <gtest/gtest.h>

#include <QJsonArray>
#include <QJsonDocument>
#include <QtEndian>
#include <algorithm>
#include <cmath>

#include "render/report/html.h"
#include "render/report/report.h"
#include "render/report/viewer/packed_run.h"
#include "render/report/viewer/shown_grains.h"
#include "render/report/viewer/view_block.h"
#include "tests/render/fields/drawing_test.h"
#include "tests/render/synthetic_ring.h"

namespace diefill::render::report {
namespace {

/// The synthetic ring with one earlier instant, in which all grains stood 5 mm higher and one was not there.
results::FillResult ring_with_an_instant() {
  auto ring = test::make_ring();
  results::Instant instant;
  instant.time = 0.5 * ring.powder.time;
  for (std::size_t k = 1; k < ring.powder.id.size(); ++k) {
    instant.id.push_back(ring.powder.id[k]);
    instant.position.push_back(ring.powder.position[k] + Eigen::Vector3d(0, 0, 5e-3));
    instant.orientation.push_back(ring.powder.orientation[k]);
    instant.velocity.push_back(Eigen::Vector3d(0.1, 0, 0));
  }
  instant.tool_orientation.assign(ring.tools.size(), Eigen::Vector4d(1, 0, 0, 0));
  instant.tool_displacement.assign(ring.tools.size(), Eigen::Vector3d(1e-3, 0, 0));
  ring.instants = {instant};
  return ring;
}

/// The packed data as a browser unpacks them.
class Unpacked {
 public:
  explicit Unpacked(const PackedRun& packed) : description_(packed.description) {
    const QByteArray stream = QByteArray::fromBase64(packed.data);
    QByteArray with_length(4, '\0');  // qUncompress wants one; too short a guess is enlarged
    bytes_ = qUncompress(with_length + stream);
  }
  std::vector<std::uint16_t> words(const char* name) const {
    const auto entry = description_["arrays"].toObject()[name].toObject();
    const auto offset = entry["offset"].toInteger(), count = entry["count"].toInteger();
    std::vector<std::uint16_t> words;
    for (qint64 k = 0; k < count; ++k)
      words.push_back(
          static_cast<std::uint16_t>(static_cast<unsigned char>(bytes_[offset + k]) |
                                     static_cast<unsigned char>(bytes_[offset + count + k]) << 8));
    return words;
  }
  double step() const { return description_["box"].toObject()["step"].toDouble(); }
  double lower(int axis) const { return description_["box"].toObject()["lower"].toArray()[axis].toDouble(); }

 private:
  QJsonObject description_;
  QByteArray bytes_;
};

TEST(ShownGrains, AreAllUpToTheLimitAndThoseOfTheCavityFirstBeyond) {
  auto ring = test::make_ring();
  const std::size_t grains = ring.powder.id.size();
  const auto all = shown_grains(ring, {}, ring.powder.sphere_count());
  EXPECT_EQ(all.id.size(), grains);
  EXPECT_TRUE(all.remark.empty());
  EXPECT_TRUE(std::is_sorted(all.id.begin(), all.id.end()));
  const auto inside = static_cast<std::size_t>(
      std::count(ring.solid_fraction.in_cavity.begin(), ring.solid_fraction.in_cavity.end(), 1));
  ASSERT_GT(inside, 10U);
  ASSERT_LT(inside, grains);
  const auto spheres = ring.powder.sphere_offsets.size();
  const auto part = shown_grains(ring, {}, (inside + 1) * spheres);
  EXPECT_EQ(part.id.size(), inside + 1);
  EXPECT_EQ(std::count(part.in_cavity.begin(), part.in_cavity.end(), 1), static_cast<long>(inside));
  EXPECT_NE(part.remark.find("all those in the cavity"), std::string::npos) << part.remark;
  const auto few = shown_grains(ring, {}, inside / 2 * spheres);
  EXPECT_EQ(few.id.size(), inside / 2);
  EXPECT_NE(few.remark.find("an even part"), std::string::npos) << few.remark;
}

TEST(PackedRun, HoldsEveryPositionWithinAStepAndMarksWhoIsNotThere) {
  const auto ring = ring_with_an_instant();
  const PackedRun packed = packed_run({"ring", &ring, nullptr}, {});
  const Unpacked data(packed);
  auto words = data.words("position0");
  const auto change = data.words("position1");
  const std::size_t n = ring.powder.id.size();
  const auto shown = shown_grains(ring, {0}, 1'000'000);
  const auto place = [&](std::size_t k) {
    return static_cast<std::size_t>(std::lower_bound(shown.id.begin(), shown.id.end(), ring.powder.id[k]) -
                                    shown.id.begin());
  };
  EXPECT_EQ(words[place(0)], 65535);
  for (std::size_t k = 0; k < words.size(); ++k) words[k] = static_cast<std::uint16_t>(words[k] + change[k]);
  for (std::size_t k = 0; k < n; ++k)
    for (int axis = 0; axis < 3; ++axis) {
      const double found =
          data.lower(axis) + data.step() * words[static_cast<std::size_t>(axis) * n + place(k)];
      ASSERT_NEAR(found, 1e3 * ring.powder.position[k][axis], 0.51 * data.step()) << k;
    }
  EXPECT_LT(data.step(), 0.01);  // mm
  const auto frames = packed.description["frames"].toArray();
  ASSERT_EQ(frames.size(), 2);
  EXPECT_NEAR(frames[0].toObject()["poses"].toArray()[0].toArray()[4].toDouble(), 1, 1e-12);
}

TEST(PackedRun, TellsSpeedsAndSolidFractionsWithinAPerCent) {
  const auto ring = ring_with_an_instant();
  const Unpacked data(packed_run({"ring", &ring, nullptr}, {}));
  const auto speeds = data.words("speed0");
  EXPECT_NEAR(1e-5 * std::exp(1e-2 * (speeds.back() - 1)), 0.1, 1e-3);
  std::size_t closed = 0;
  for (const auto word : data.words("fraction1")) closed += word > 0 ? 1 : 0;
  EXPECT_EQ(closed, static_cast<std::size_t>(
                        std::count(ring.solid_fraction.open.begin(), ring.solid_fraction.open.end(), 0)));
}

class ViewDrawing : public test::Drawing {};

TEST_F(ViewDrawing, LeavesOutInstantsWhereTheDataWouldBeTooLarge) {
  auto ring = ring_with_an_instant();
  ring.instants.resize(8, ring.instants.front());
  const ViewedRun run{"ring", &ring, nullptr};
  const auto whole = view_of({run}, {0.3, 0.4});
  const auto small = view_of({run}, {0.3, 0.4}, static_cast<std::size_t>(whole.data[0].size()) - 1);
  EXPECT_LT(small.data[0].size(), whole.data[0].size());
  EXPECT_NE(small.description.indexOf("4 of 8 kept instants"), -1);
  EXPECT_EQ(whole.description.indexOf("kept instants"), -1);
  const auto five = view_of({run, run, run, run, run}, {0.3, 0.4}, 4'000'000);
  EXPECT_EQ(five.data.size(), kMaxViewedRuns);
  EXPECT_NE(five.remark.find("4 of 5"), std::string::npos);
}

TEST_F(ViewDrawing, PagesRunTheirOwnScriptsOnlyAndHoldStillPictures) {
  report::Run run;
  run.name = "</script><b>";
  run.result = test::make_ring();
  const std::string page = html_page(report_of({run}));
  EXPECT_EQ(page.find("<b>"), std::string::npos);
  EXPECT_NE(page.find("script-src 'sha256-"), std::string::npos);
  EXPECT_EQ(page.find("'unsafe-eval'"), std::string::npos);
  EXPECT_NE(page.find("class=\"pictures still\""), std::string::npos);
  EXPECT_EQ(page.find("<script src"), std::string::npos);
  const std::string plain = html_page({"title", "", {{"One", 1, {Paragraph{"text"}}}}});
  EXPECT_EQ(plain.find("<script"), std::string::npos);
  EXPECT_EQ(plain.find("script-src"), std::string::npos);
}

}  // namespace
}  // namespace diefill::render::report
