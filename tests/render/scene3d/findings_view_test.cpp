// The picture of findings: marks lie where the findings are, in the colour of their kind.
#include "render/scene3d/findings_view.h"

#include "tests/render/fields/drawing_test.h"

namespace diefill::render::test {
namespace {

using FindingsView = Drawing;

MarkedPart box(const Eigen::Vector3d& lower, const Eigen::Vector3d& upper) {
  MarkedPart part;
  for (int i = 0; i < 8; ++i)
    part.vertices.emplace_back(i & 1 ? upper.x() : lower.x(), i & 2 ? upper.y() : lower.y(),
                               i & 4 ? upper.z() : lower.z());
  part.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  return part;
}

TEST_F(FindingsView, MarksLieWhereTheFindingsAre) {
  const std::vector<FindingMark> findings = {
      {MarkKind::kFault, "die: 3 open edges: the surface has a hole", {{0.01, 0, 0}, {0, 0.02, 0.03}}},
      {MarkKind::kCare, "die and punch: gap of 0.4 mm", {{0.005, 0.01, 0.03}}},
      {MarkKind::kFact, "narrowest width of the cavity, 3.146 mm", {{0.002, 0.01, 0.015}}}};
  const auto picture =
      compose_findings({box({0, 0, 0}, {0.01, 0.02, 0.03})}, findings, "A block with a hole");
  keep(picture.image, "findings.png");
  ASSERT_EQ(picture.marks.size(), 3U);
  ASSERT_EQ(picture.marks[0].size(), 2U);
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.marks[0][0]), {200, 30, 30}, 12));
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.marks[1][0]), {222, 120, 0}, 12));
  EXPECT_TRUE(close_to(pixel_at(picture.image, picture.marks[2][0]), {20, 95, 170}, 12));
  // z up is up on the picture.
  EXPECT_LT(picture.marks[1][0].y(), picture.marks[2][0].y());
  EXPECT_TRUE(has_white_border(picture.image, 10));
  EXPECT_GT(ink(picture.image, QRect(1080, 150, 480, 300)), 1000);  // the legend
}

TEST_F(FindingsView, ManyFindingsStayOnThePage) {
  std::vector<FindingMark> findings;
  for (int k = 0; k < 40; ++k)
    findings.push_back(
        {MarkKind::kFault, std::string(200, 'w') + " and more words than fit", {{0, 0, 1e-3 * k}}});
  const auto picture = compose_findings({box({0, 0, 0}, {0.01, 0.02, 0.04})}, findings, "Everything at once");
  EXPECT_TRUE(has_white_border(picture.image, 8));
  EXPECT_EQ(picture.marks.size(), 40U);
}

void expect_apart_within(const std::vector<QRectF>& rooms, const QRectF& area) {
  for (std::size_t a = 0; a < rooms.size(); ++a) {
    EXPECT_TRUE(area.contains(rooms[a])) << a;
    for (std::size_t b = 0; b < a; ++b) EXPECT_FALSE(rooms[a].intersects(rooms[b])) << a << ' ' << b;
  }
}

TEST_F(FindingsView, NumbersAndLegendKeepApartAndOnThePicture) {
  // All in one corner, and in the outermost places of the part.
  std::vector<FindingMark> findings;
  for (int k = 0; k < 8; ++k)
    findings.push_back({MarkKind::kCare,
                        "die: triangle " + std::to_string(k) + " has no area, and more words",
                        {{1e-5 * k, 0, 0.03}}});
  findings.push_back({MarkKind::kFault, "at the right", {{0.01, 0.02, 0}}});
  findings.push_back({MarkKind::kFault, std::string(80, 'w'), {{0.01, 0.02, 0.03}}});
  const auto picture = compose_findings({box({0, 0, 0}, {0.01, 0.02, 0.03})}, findings, "Close together");
  keep(picture.image, "findings_close.png");
  ASSERT_EQ(picture.numbers.size(), 10U);
  ASSERT_EQ(picture.legend.size(), 10U);
  expect_apart_within(picture.numbers, QRectF(picture.image.rect()));
  expect_apart_within(picture.legend, QRectF(picture.image.rect()));
  for (const QRectF& number : picture.numbers)
    for (const QRectF& line : picture.legend) EXPECT_FALSE(number.intersects(line));
}

TEST_F(FindingsView, FileIsWrittenWhole) {
  draw_findings(file("findings.png"), {box({0, 0, 0}, {1, 1, 1})}, {}, "Nothing found");
  EXPECT_EQ(contents(file("findings.png")).substr(1, 3), "PNG");
}

}  // namespace
}  // namespace diefill::render::test
