// A run that keeps instants leaves one file in which powder and tools move, for ParaView; VTK's readers read
// it.
#include <gtest/gtest.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLPolyDataReader.h>

#include <map>
#include <regex>

#include "tests/app/small_die.h"

namespace diefill::app {
namespace {

namespace fs = std::filesystem;

struct Shown {
  double x = 0, z = 0;  ///< m, middle of the points' box
  long points = 0;
};

/// What is shown at each time by each part.
using Series = std::map<std::string, std::map<double, Shown>>;

Shown read_part(const fs::path& file) {
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  EXPECT_TRUE(reader->CanReadFile(file.c_str())) << file;
  reader->SetFileName(file.c_str());
  reader->Update();
  double box[6];
  reader->GetOutput()->GetBounds(box);
  return {0.5 * (box[0] + box[1]), 0.5 * (box[4] + box[5]), reader->GetOutput()->GetNumberOfPoints()};
}

/// Parts whose name matches `names`.
Series read_series(const fs::path& pvd, const std::string& names = "[^\"]*") {
  const std::string text = contents(pvd);
  const std::regex entry("timestep=\"([^\"]*)\" group=\"\" part=\"[0-9]+\" name=\"(" + names +
                         ")\" file=\"([^\"]*)\"");
  Series series;
  for (std::sregex_iterator at(text.begin(), text.end(), entry), end; at != end; ++at)
    series[(*at)[2]][std::stod((*at)[1])] = read_part(pvd.parent_path() / (*at)[3].str());
  return series;
}

/// How many files of this part there are.
std::size_t times_of(const fs::path& pvd, const std::string& name) {
  const std::string text = contents(pvd);
  const std::regex entry("name=\"" + name + "\"");
  return static_cast<std::size_t>(
      std::distance(std::sregex_iterator(text.begin(), text.end(), entry), std::sregex_iterator()));
}

void expect_moving(const Series& series, std::size_t least) {
  ASSERT_EQ(series.size(), 3U);  // powder, die, shoe
  const auto& shoe = series.at("shoe");
  EXPECT_GE(shoe.size(), least);
  EXPECT_NEAR(shoe.begin()->second.x, 3e-3, 1e-3);
  EXPECT_LT(shoe.rbegin()->second.x, -5e-3);  // it has gone over the pocket
  for (auto at = shoe.begin(); std::next(at) != shoe.end(); ++at)
    EXPECT_LT(std::next(at)->second.x, at->second.x + 1e-9);
  const auto& powder = series.at("powder");
  EXPECT_EQ(powder.size(), shoe.size());
  EXPECT_GT(powder.begin()->second.points, 10);
  EXPECT_LT(powder.rbegin()->second.z, powder.begin()->second.z);
  const auto& die = series.at("die");
  EXPECT_EQ(die.size(), shoe.size());
  EXPECT_NEAR(die.begin()->second.x, die.rbegin()->second.x, 1e-9);
}

TEST(ParaviewSeries, PlaysPowderAndToolsOfARunFromOneFile) {
  const SmallDie die;
  die.exchange("velocity = \"0.1 m/s\"", "velocity = \"0.2 m/s\"");
  die.exchange("[measure]\n", "[measure]\nsnapshot_interval = \"20 ms\"\n");
  const Outcome outcome = die.run({"--quiet", "--no-pictures"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_NE(outcome.out.find("filling.pvd"), std::string::npos) << outcome.out;
  expect_moving(read_series(die.out() / "filling.pvd"), 4);
  // The die stands still: one file of it serves all times.
  EXPECT_TRUE(fs::exists(die.out() / "paraview" / "tool_0_0000.vtp"));
  EXPECT_FALSE(fs::exists(die.out() / "paraview" / "tool_0_0001.vtp"));

  const auto exported = die.folder() / "exported";
  ASSERT_EQ(run_program({"export", die.out().string(), "--out", exported.string()}).exit_code, 0);
  const Series whole = read_series(exported / "filling.pvd", "powder|die|shoe");
  expect_moving(whole, 4);
  // One grid of the fields for every time.
  EXPECT_EQ(times_of(exported / "filling.pvd", "fields"), whole.at("powder").size());
  EXPECT_TRUE(fs::exists(exported / "fields_0000.vti"));
  EXPECT_TRUE(fs::exists(exported / "fields.vti"));
}

}  // namespace
}  // namespace diefill::app
