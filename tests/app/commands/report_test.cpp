// `diefill report`: pages about real results of the small die, as a user gets them.
#include <gtest/gtest.h>

#include <cmath>
#include <regex>

#include "process/results/figure_table.h"
#include "process/results/storage/result_file.h"
#include "tests/app/shared_report.h"

namespace diefill::app {
namespace {

/// The value beside `name` in a table of the page.
std::string cell(const std::string& page, const std::string& name) {
  const std::string head = std::string("<th scope=\"row\">").append(name).append("</th><td>");
  const std::size_t start = page.find(head);
  if (start == std::string::npos) return "no such row";
  const std::size_t value = start + head.size();
  return page.substr(value, page.find("</td>", value) - value);
}

/// The page without its scripts, which libraries fill with addresses that nobody asks.
std::string without_scripts(std::string page) {
  for (std::size_t start = 0; (start = page.find("<script", start)) != std::string::npos;)
    page.erase(start, page.find("</script>", start) - start);
  return page;
}

void expect_self_contained(const std::string& whole) {
  EXPECT_EQ(whole.find("<script src"), std::string::npos);
  const std::string page = without_scripts(whole);
  const std::regex reference("(src|href)=\"(data:|#|[^\"]{0,40})");
  for (auto found = std::sregex_iterator(page.begin(), page.end(), reference);
       found != std::sregex_iterator(); ++found)
    EXPECT_TRUE((*found)[2] == "data:" || (*found)[2] == "#") << found->str();
  for (const char* word : {"http:", "https:", "file:", "url(", "@import", "javascript:"})
    EXPECT_EQ(page.find(word), std::string::npos) << word;
}

TEST(Report, TellsAllAboutARunInOnePageThatNeedsNothingElse) {
  const SmallDie die;
  die.exchange("title = \"Small die, one passage\"",
               "title = \"<script>alert('x')</script> & \\\"die\\\" <img src=x>\"");
  ASSERT_EQ(die.run({"--quiet", "--no-pictures"}).exit_code, 0);
  const Outcome outcome = run_program({"report", die.out().string(), "--pdf"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            (die.out() / "report.html").string() + "\n" + (die.out() / "report.pdf").string() + "\n");
  const std::string page = contents(die.out() / "report.html");
  expect_self_contained(page);
  EXPECT_NE(page.find("<h1>&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &amp; &quot;die&quot; "
                      "&lt;img src=x&gt;</h1>"),
            std::string::npos);
  for (const char* title : {"Results", "Warnings", "Maps and pictures", "Strategy", "Tooling",
                            "Powder and model", "Approximations", "Stability margins", "In three dimensions",
                            "Size and speed of the computation", "Versions", "Scene"})
    EXPECT_NE(page.find(std::string(">").append(title).append("</h2>")), std::string::npos) << title;
  EXPECT_EQ(page.find("without this information"), std::string::npos);

  for (const auto& [name, value] : results::read_results(die.out()).figures)
    EXPECT_NE(results::find_figure(name), nullptr) << name;

  const auto report = die.report();
  const auto expect_number = [&](const std::string& name, double value, double digits) {
    EXPECT_NEAR(std::stod(cell(page, name)), value, std::abs(value) * digits) << name;
  };
  expect_number("Filled mass of model powder", 1e3 * report.at("filled_mass_kg").get<double>(), 1e-3);
  EXPECT_TRUE(cell(page, "Mean solid fraction").starts_with("no value: "))
      << cell(page, "Mean solid fraction");
  expect_number("Solid fraction of the cavity: all powder in it over its volume",
                report.at("cavity_solid_fraction").get<double>(), 1e-2);
  EXPECT_NE(page.find(report.at("verdict").get<std::string>().substr(0, 12)), std::string::npos);
  expect_number("Steps", report.at("steps").get<double>(), 0);
  expect_number("Fill density of model powder", report.at("filled_mass_kg").get<double>() / 64e-9, 2e-2);
  EXPECT_EQ(cell(page, "Hash of the final state"), report.at("state_hash").get<std::string>());
  EXPECT_EQ(cell(page, "Apparent density of the real powder"), "3 g/cm³");  // ASC100.29
  const std::string pdf = contents(die.out() / "report.pdf");
  EXPECT_TRUE(pdf.starts_with("%PDF-"));
  EXPECT_GT(pdf.size(), 50000U);
}

TEST(Report, HoldsRunsAgainstTheFirstAndTakesSeedsTogether) {
  const SmallDie die;
  const auto run = [&](const std::string& name) {
    return run_program({"run", die.scene().string(), "--out", (die.folder() / name).string(), "--threads",
                        "1", "--quiet", "--no-pictures"})
        .exit_code;
  };
  ASSERT_EQ(run("slow"), 0);
  die.exchange("seed = 1", "seed = 2");
  ASSERT_EQ(run("slow 2"), 0);
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.3 m/s\"");
  ASSERT_EQ(run("fast"), 0);
  const auto page_file = die.folder() / "pages" / "comparison.html";
  const Outcome outcome =
      run_program({"report", (die.folder() / "slow").string(), (die.folder() / "slow 2").string(),
                   (die.folder() / "fast").string(), "--out", page_file.string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string page = contents(page_file);
  expect_self_contained(page);
  EXPECT_NE(page.find("<h1>2 filling strategies, 3 runs</h1>"), std::string::npos);
  EXPECT_EQ(cell(page, "1 passage at 0.1 m/s"), "2");
  for (const char* title : {"Ranking", "Maps on one scale", "Critical shoe speed", "Single runs",
                            "Differences from &quot;1 passage at 0.1 m/s&quot;"})
    EXPECT_NE(page.find(std::string(">").append(title).append("</h2>")), std::string::npos) << title;
  EXPECT_NE(page.find("velocity = &quot;0.3 m/s&quot;"), std::string::npos);
  EXPECT_NE(page.find(" ± "), std::string::npos);
}

TEST(Report, TakesTheRunsOfAComparisonByTheirVariants) {
  const SmallDie die;
  take_shared_results(die);
  die.write("comparison.json", R"({"runs": [{"variant": "as <it> is", "seed": 1, "folder": "out"},
    {"variant": "again", "seed": 1, "folder": "out"}, {"variant": "again", "seed": 2, "folder": "lost"}]})");
  const Outcome outcome = run_program({"report", die.folder().string()});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.err.find("1 runs of"), std::string::npos) << outcome.err;
  const std::string page = contents(die.folder() / "report.html");
  EXPECT_NE(page.find("<h1>2 filling strategies, 2 runs</h1>"), std::string::npos);
  EXPECT_EQ(cell(page, "as &lt;it&gt; is"), "1");
  EXPECT_EQ(cell(page, "again"), "1");
}

TEST(Report, ACopyOfResultsIsNoSecondSeed) {
  const SmallDie die;
  take_shared_results(die);
  const auto copy = die.folder() / "copy of out";
  std::filesystem::copy(die.out(), copy, std::filesystem::copy_options::recursive);
  for (const char* command : {"report", "map"}) {
    std::vector<std::string> arguments = {command, die.out().string(), copy.string()};
    if (arguments[0] == "map") arguments.insert(arguments.end(), {"--picture", "difference"});
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << command;
    EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
    for (const auto& directory : {die.out(), copy})
      EXPECT_NE(outcome.err.find('"' + directory.string() + '"'), std::string::npos) << outcome.err;
    EXPECT_NE(outcome.err.find("give each run once"), std::string::npos) << outcome.err;
  }
}

void expect_refused(const std::vector<std::string>& arguments, const std::string& words) {
  const Outcome outcome = run_program(arguments);
  EXPECT_EQ(outcome.exit_code, 2) << words;
  EXPECT_EQ(outcome.complaints(), 1U) << outcome.err;
  EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
}

TEST(Report, SaysInOneLineWhatIsWrongWithADirectory) {
  const SmallDie die;
  expect_refused({"report", (die.folder() / "nowhere").string()}, "no such results file");
  expect_refused({"report", die.folder().string()}, "no such results file");
  die.write("results.h5", "no results at all");
  expect_refused({"report", die.folder().string()}, "not an HDF5 file");
  std::filesystem::remove(die.folder() / "results.h5");
  die.write("comparison.json", "{}");
  expect_refused({"report", die.folder().string()}, "not a comparison written by diefill");
  die.write("comparison.json", "{\"runs\": []}");
  expect_refused({"report", die.folder().string()}, "the comparison has no results");
}

}  // namespace
}  // namespace diefill::app
