// VTK's own readers find in the files what was put into them.
#include "render/scene3d/paraview_files.h"

#include <gtest/gtest.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>

#include "tests/support/temporary_folder.h"

namespace diefill::render {
namespace {

TEST(ParaviewFiles, GivePointsBackBitForBit) {
  const support::TemporaryFolder folder;
  const std::vector<Eigen::Vector3d> points = {{0.1, 0.2, 1.0 / 3}, {-1e-9, 5e3, 0}};
  write_points(folder.path() / "a.vtp", points,
               {{"mass [kg]", 1, {1e-300, 0.7}}, {"velocity [m/s]", 3, {1, 2, 3, 4, 5, 6}}});
  const auto reader = vtkSmartPointer<vtkXMLPolyDataReader>::New();
  reader->SetFileName((folder.path() / "a.vtp").c_str());
  reader->Update();
  vtkPolyData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 2);
  EXPECT_EQ(data->GetNumberOfVerts(), 2);
  for (vtkIdType k = 0; k < 2; ++k)
    EXPECT_EQ(Eigen::Vector3d(data->GetPoint(k)), points[static_cast<std::size_t>(k)]);
  EXPECT_EQ(data->GetPointData()->GetArray("mass [kg]")->GetComponent(0, 0), 1e-300);
  EXPECT_EQ(data->GetPointData()->GetArray("velocity [m/s]")->GetComponent(1, 1), 5);
}

TEST(ParaviewFiles, GiveGridsBackWithTheFirstAxisRunningFastest) {
  const support::TemporaryFolder folder;
  PointGrid grid;
  grid.origin = {1, 2, 3};
  grid.spacing = 0.25;
  grid.counts = {2, 3, 1};
  write_grid(folder.path() / "a.vti", grid, {{"f", 1, {0, 1, 2, 3, 4, 5}}});
  const auto reader = vtkSmartPointer<vtkXMLImageDataReader>::New();
  reader->SetFileName((folder.path() / "a.vti").c_str());
  reader->Update();
  vtkImageData* data = reader->GetOutput();
  ASSERT_EQ(data->GetNumberOfPoints(), 6);
  EXPECT_EQ(Eigen::Vector3d(data->GetPoint(3)), grid.point(1, 1, 0));
  EXPECT_EQ(data->GetPointData()->GetArray("f")->GetComponent(3, 0), 3);
}

TEST(ParaviewFiles, RefuseValuesThatDoNotFitAndLeaveNothing) {
  const support::TemporaryFolder folder;
  EXPECT_THROW(write_points(folder.path() / "a.vtp", {{0, 0, 0}}, {{"f", 3, {1, 2}}}), std::invalid_argument);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "a.vtp"));
}

}  // namespace
}  // namespace diefill::render
