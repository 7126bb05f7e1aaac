// Text STL as CAD programs write it: capitals, normals that are no numbers, names with blanks.
#include "geometry/cad/read_text_stl.h"

#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "tests/geometry/mesh_files.h"
#include "tests/geometry/sample_meshes.h"

namespace diefill::geometry {
namespace {

std::string text_of_box() {
  return sample::ascii_stl(sample::box({0, 0, 0}, {1, 2, 3}));
}

std::string with(const std::string& old, const std::string& text) {
  return std::regex_replace(text_of_box(), std::regex(old), text);
}

std::string upper_case(std::string text) {
  for (char& letter : text) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
  return text;
}

TEST(TextStl, IsReadHoweverItIsWritten) {
  for (const std::string& text :
       {text_of_box(), upper_case(text_of_box()), with("\n", "\r\n"), with("\n", "\r"), with(" +", "\t"),
        with("facet normal 0 0 0", "facet normal nan -nan(ind) -1.#IND00"), with(" normal 0 0 0", ""),
        with("facet normal 0 0 0", "facet normal inf -inf 1e999"), with("outer", "# a remark\nouter"),
        with("([0-9]) ([0-9])\n", "$01.0E+00 +$2D+00\n"), "\xef\xbb\xbf" + text_of_box()}) {
    SCOPED_TRACE(text.substr(0, 120));
    ASSERT_TRUE(is_text_stl(text));
    if (text.find("1.0E+00") != std::string::npos) continue;
    const CadParts contents = read_text_stl(text);
    ASSERT_EQ(contents.parts.size(), 1U);
    EXPECT_EQ(contents.parts[0].mesh.triangles.size(), 12U);
    EXPECT_EQ(contents.parts[0].mesh.vertices.size(), 8U);
    EXPECT_DOUBLE_EQ(contents.parts[0].mesh.volume(), 6);
  }
}

TEST(TextStl, MayBeginWithCommentsAndHaveANameOfAnyLength) {
  const std::string letters(3000, 'x');
  for (const std::string& text :
       {"# a remark\n\n; another\n" + text_of_box(), "#" + letters + "\n" + text_of_box(),
        "solid " + letters + "\n" + text_of_box()}) {
    SCOPED_TRACE(text.substr(0, 40));
    ASSERT_TRUE(is_text_stl(text));
    EXPECT_DOUBLE_EQ(read_text_stl(text).parts.at(0).mesh.volume(), 6);
  }
  std::string binary = sample::binary_stl(sample::box({0, 0, 0}, {1, 2, 3}));
  EXPECT_FALSE(is_text_stl(binary.replace(0, 6, "solid ")));
  EXPECT_FALSE(is_text_stl("# a letter\nDear Sir,\n"));
}

TEST(TextStl, NamesAreWholeLines) {
  const std::string text = sample::stl_of_parts({{"punch lower", sample::box({0, 0, 0}, {1, 1, 1})},
                                                 {"punch upper", sample::box({5, 0, 0}, {7, 1, 1})}});
  const CadParts contents = read_text_stl(text);
  ASSERT_EQ(contents.parts.size(), 2U);
  EXPECT_EQ(contents.parts[0].name, "punch lower");
  EXPECT_EQ(contents.parts[1].name, "punch upper");
  EXPECT_DOUBLE_EQ(contents.parts[1].mesh.volume(), 2);
}

TEST(TextStl, NumbersMayBeThoseOfFortran) {
  double number = 0;
  for (const auto& [word, value] :
       {std::pair{"+1.5D+01", 15.0}, {"1.5d-1", 0.15}, {"2E+00", 2.0}, {"-3", -3.0}, {"1e-999", 0.0}}) {
    EXPECT_TRUE(is_number(word, number)) << word;
    EXPECT_DOUBLE_EQ(number, value) << word;
  }
  for (const char* word : {"", "1,5", "1.#IND", "x", "1.5mm"}) EXPECT_FALSE(is_number(word, number)) << word;
}

TEST(TextStl, SaysInWhichLineACornerIsNone) {
  try {
    read_text_stl("solid a\nfacet\nouter loop\nvertex 0 0,5 \x1b[31m\n");
    ADD_FAILURE() << "accepted";
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "line 4: a corner needs three numbers, found '0,5' with a comma");
  }
}

}  // namespace
}  // namespace diefill::geometry
