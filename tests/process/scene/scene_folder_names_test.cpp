// Folders of names that people give: safe everywhere, one each, never a name that the program needs itself.
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "process/scene/folder_names.h"

namespace diefill::process {
namespace {

std::string lower(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return text;
}

void expect_safe(const std::string& folder) {
  EXPECT_EQ(folder.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-._"),
            std::string::npos)
      << folder;
  EXPECT_NE(folder.front(), '-');
  EXPECT_NE(folder.front(), '.');
  EXPECT_NE(folder.back(), '.');
  EXPECT_LE(folder.size(), 80U);
}

TEST(FolderNames, KeepWhatIsSafeAsItIs) {
  const std::vector<std::string> plain = {"quick", "Slow shoe", "0.1 m/s", "grain_diameter=0.94 mm", "v1.2"};
  const std::vector<std::string> folders = {"quick", "Slow_shoe", "0.1_m_s", "grain_diameter_0.94_mm",
                                            "v1.2"};
  EXPECT_EQ(folder_names(plain), folders);
}

TEST(FolderNames, AreSafeAndDifferByMoreThanCapitals) {
  const std::vector<std::string> names = {"a b",
                                          "a_b",
                                          "A b",
                                          "a/b",
                                          "a\\b",
                                          "a:b",
                                          "..",
                                          ".",
                                          "...",
                                          "-",
                                          "--out",
                                          "-x",
                                          "x",
                                          ".x",
                                          "x.",
                                          "x..",
                                          "\"quoted\"",
                                          "it's",
                                          "$(reboot)",
                                          "`reboot`",
                                          "a;b",
                                          "a&b",
                                          "*",
                                          "?",
                                          "größer",
                                          "gröβer",
                                          "日本",
                                          "東京",
                                          "é",
                                          "e\u0301",
                                          " a b",
                                          "a b ",
                                          "a  b",
                                          "CON",
                                          "nul",
                                          std::string(300, 'n'),
                                          std::string(301, 'n'),
                                          std::string(300, 'n') + "m",
                                          "quick-0123abcd",
                                          "quick",
                                          "Quick",
                                          "QUICK",
                                          "%2e%2e",
                                          "~",
                                          "#",
                                          "<b>",
                                          "a\tb"};
  const auto folders = folder_names(names);
  std::set<std::string> taken;
  for (std::size_t k = 0; k < names.size(); ++k) {
    SCOPED_TRACE(names[k] + " -> " + folders[k]);
    expect_safe(folders[k]);
    EXPECT_TRUE(taken.insert(lower(folders[k])).second);
  }
  const auto quick = std::find(names.begin(), names.end(), "quick") - names.begin();
  EXPECT_EQ(folders[static_cast<std::size_t>(quick)], "quick") << "small letters alone keep their folder";
}

TEST(FolderNames, AreNeverThoseThatTheProgramWrites) {
  for (const std::string name :
       {"beginnings", "Beginnings", "tools", "comparison.json", "comparison.csv", "comparison.png",
        "jobs.json", "jobs.txt", "run_here.sh", "slurm.sh", "tradeoff.json", "tradeoff.png",
        "parameter_time_step.png", "report.html", "report.pdf", "previous-1", ".diefill-lock",
        "comparison.json.diefill-12-0.tmp", "results.h5"}) {
    const std::string folder = folder_of_name(name);
    expect_safe(folder);
    EXPECT_NE(lower(folder), lower(name));
    EXPECT_NE(folder_of_name(folder), folder) << "a variant called so has another folder";
  }
}

TEST(FolderNames, DependOnOthersOnlyWhereTheseComeClose) {
  EXPECT_EQ(folder_names({"-x", "fast"})[0], folder_of_name("-x"));
  EXPECT_EQ(folder_names({"fast", "slow"})[0], folder_names({"slow", "fast", "größer"})[1]);
  EXPECT_NE(folder_names({"a b", "a_b"})[0], folder_of_name("a b"));
  EXPECT_EQ(folder_names({"a b", "a_b"})[1], folder_of_name("a_b"));
}

}  // namespace
}  // namespace diefill::process
