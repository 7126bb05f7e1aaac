// Reports of calibrations: what must be read is in them.
#include "render/report/calibration_report.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/report/html.h"
#include "render/report/sections/calibration_data_section.h"
#include "tests/render/fields/drawing_test.h"

namespace diefill::render::report {
namespace {

class CalibrationReport : public test::Drawing {};

results::Calibration account() {
  results::Calibration account;
  account.title = "Plant powder";
  account.fitted = account.agrees = true;
  account.chi_square = 3.1;
  account.data = 4;
  account.parameters = {
      {"powder.friction", "1", 0.1, 1, false, 0.4, 0.35, 0.45, {0.1, 0.4, 1}, {90, 3.1, 200}},
      {"powder.work_of_adhesion",
       "J/m^2",
       0.001,
       0.1,
       true,
       0.01,
       0.005,
       0.02,
       {0.001, 0.01, 0.1},
       {30, 3.1, 40}}};
  account.correlation = {{1, -0.9}, {-0.9, 1}};
  account.insights = {"slit alone fixes powder.friction and powder.work_of_adhesion only along a line"};
  account.worth = {{"heap, once more", 0.4, {0.5, 0.6}}};
  account.stopped = "more runs would change little";
  results::CalibratedMeasurement slit;
  slit.name = "slit";
  slit.quantity = "mass";
  slit.unit = "g";
  slit.x_name = "speed";
  slit.x_unit = "m/s";
  slit.residual = 1e-4;
  for (const double speed : {0.1, 0.2, 0.4})
    slit.data.push_back({speed, NAN, 1 / speed, 0.3, 1.02 / speed, 0.1, 0.2, 0.95 / speed, 1.05 / speed});
  account.measurements = {slit};
  results::CalibratedMeasurement heap;
  heap.name = "heap";
  heap.quantity = "slope";
  heap.unit = "deg";
  heap.fitted = false;
  heap.data = {{NAN, NAN, 37, 1, 36.5, 0.4, 0.8, 35, 38}};
  account.measurements.push_back(heap);
  account.points = {{"start", {0.2, 0.01}, "finished", "", 12, 30},
                    {"search", {0.4, 0.01}, "failed", "too soft", NAN, 3}};
  return account;
}

TEST_F(CalibrationReport, TellsThePowderTheDataAndWhatTheyCannotTell) {
  const std::string page = html_page(calibration_document(account()));
  for (const char* part : {"Plant powder", "0.35 to 0.45", "only along a line", "heap, once more", "40 %",
                           "too soft", "Check on what was not fitted", "measured curve 0.0001 (Bierwisch",
                           "36.5", "more runs would change little"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_EQ(page.find("<script"), std::string::npos);
}

TEST_F(CalibrationReport, MarksTheBestPowderAndTheEdgeOfThoseThatAgreeOnMaps) {
  results::Calibration marked = account();
  results::Field2D map{"misfit", "powder.friction", "1",          "log10 of work_of_adhesion",
                       "J/m^2",  {0.1, 0.4, 1},     {-3, -2, -1}, {3, 2, 3, 2, 0.9, 2, 3, 2, 3}};
  marked.maps = {map};
  const std::string without = html_page(calibration_document(marked));
  marked.map_edge = 1.4;
  const std::string with = html_page(calibration_document(marked));
  EXPECT_NE(with, without);
  EXPECT_NE(with.find("powder.friction and log10 of work_of_adhesion"), std::string::npos);
}

TEST_F(CalibrationReport, ShowsAMapWithMoreValuesThanATableAsSimulatedOverMeasured) {
  results::Calibration mapped = account();
  results::CalibratedMeasurement map;
  map.name = "CT";
  map.quantity = "solid fraction";
  map.unit = "1";
  map.x_name = "x";
  map.second_name = "y";
  map.x_unit = map.second_unit = "mm";
  for (int k = 0; k < 13; ++k)
    map.data.push_back({1.0 * k, 2, 0.3 + 0.01 * k, 0.01, 0.31 + 0.009 * k, 0.01, 0.01, 0.3, 0.4});
  map.data[4].simulated = NAN;  // a place that runs have no value at
  const std::string without = html_page(calibration_document(mapped));
  mapped.measurements.push_back(map);
  const std::string with = html_page(calibration_document(mapped));
  EXPECT_NE(with.find("CT: simulated over measured"), std::string::npos);
  EXPECT_EQ(without.find("simulated over measured"), std::string::npos);
  EXPECT_FALSE(agreement_picture(map).png.isEmpty());
  for (auto& datum : map.data) datum.simulated = NAN;
  EXPECT_FALSE(agreement_picture(map).png.isEmpty());
}

TEST_F(CalibrationReport, SaysWhereNoPowderWasFound) {
  results::Calibration nothing;
  nothing.title = "Plant powder";
  nothing.stopped = "the budget is used";
  nothing.remarks = {"2 of 4 sets of parameters failed"};
  const std::string page = html_page(calibration_document(nothing));
  EXPECT_NE(page.find("No powder was fitted: the budget is used"), std::string::npos);
  EXPECT_NE(page.find("2 of 4 sets of parameters failed"), std::string::npos);
}

TEST_F(CalibrationReport, OfAScreeningHasItsEffects) {
  results::Calibration screened = account();
  screened.screening.runs = 4;
  screened.screening.resolution = 0;
  screened.screening.letters = {"A = powder.friction", "B = powder.work_of_adhesion"};
  screened.screening.error_source = "runs with other seeds";
  screened.screening.quantities = {{"slit at 0.1 m/s", "g", 10, 0.1, 0.3, 5, 1}};
  screened.screening.effects = {{"A", "powder.friction", true, {-1.5}},
                                {"B", "powder.work_of_adhesion", true, {0.1}},
                                {"AB", "powder.friction with powder.work_of_adhesion", false, {0.05}}};
  screened.remarks = {"no effects on heap, which has no value in run 3 (too soft)"};
  const std::string page = html_page(calibration_document(screened));
  for (const char* part : {"-1.5 *", "a full factorial", "runs with other seeds", "A = powder.friction",
                           "no effects on heap, which has no value in run 3 (too soft)"})
    EXPECT_NE(page.find(part), std::string::npos) << part;
  EXPECT_FALSE(effects_picture(screened.screening, 0).png.isEmpty());
}

}  // namespace
}  // namespace diefill::render::report
