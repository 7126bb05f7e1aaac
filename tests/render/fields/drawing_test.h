// What every test that draws needs: a started renderer, a folder for files, and looks at pixels.
#pragma once

#include <gtest/gtest.h>

#include <QImage>
#include <filesystem>

#include "render/style/colour_map.h"
#include "tests/support/temporary_folder.h"

namespace diefill::render::test {

using support::contents;

/// Starts drawing without a screen once for the program, and gives each test its own folder. With
/// DIEFILL_PICTURES set to a folder, pictures are kept there for people to look at.
class Drawing : public ::testing::Test {
 protected:
  static void SetUpTestSuite();

  /// A path in this test's folder.
  std::filesystem::path file(const std::string& name) const { return folder_.path() / name; }

  /// Keeps a copy of a picture made in memory, where the user asked for that.
  static void keep(const QImage& image, const std::string& name);

  /// Compares a picture with the stored one of that name in references/, which small differences of fonts and
  /// edges may tell apart. DIEFILL_NEW_REFERENCES=1 stores it again: look at every one before it is kept.
  static void expect_like_reference(const QImage& image, const std::string& name);

 private:
  support::TemporaryFolder folder_;
};

/// Colour of the pixel that holds `place`.
Rgb pixel_at(const QImage& image, const QPointF& place);

/// Whether two colours differ by at most `tolerance` in every channel.
bool close_to(const Rgb& one, const Rgb& other, int tolerance);

/// Number of pixels in `area` that are not white.
int ink(const QImage& image, const QRect& area);

/// Whether the outermost `border` pixels all round are white: nothing is clipped by the canvas.
bool has_white_border(const QImage& image, int border);

}  // namespace diefill::render::test
