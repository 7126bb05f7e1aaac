// Discharge of the moving shoe against what the transient discharge of the hopper predicts (Bierwisch 2009,
// section 5.2.2, Eq. 5.17 with Table 5.2): model D, friction 0.5, no cohesion, a shoe of 32 mm, and one
// of 45 mm over a slit of 15 mm. Eq. 5.17 is of a hopper that stays full; how deep the source's powder is, is
// not published. Coarse grains have wider slits as in shoe_discharge.cpp.
#include <map>

#include "process/laboratory/published/bierwisch/slit_scene.h"
#include "process/laboratory/published/experiments.h"
#include "process/laboratory/published/lab_folder.h"
#include "process/laboratory/published/published_figure.h"
#include "process/laboratory/published/run_series.h"

namespace diefill::process::laboratory {
namespace {

struct Point {
  const char* id;
  SlitPassage passage;
};

/// As deep as the deepest fill of section 4.1.6, where discharge does not depend on depth: of 24 mm the slow
/// passages would take 41 % (slit of 10 mm) and most (15 mm).
constexpr double kDeep = 0.041;  // m
constexpr double kLong = 0.045;  // m, of the shoe over the slit of 15 mm

std::string run_name(const Point& point) {
  return "slit " + plain(1e3 * point.passage.width) + " mm, " + plain(point.passage.speed) + " m/s";
}

/// mm^2, as published, by the name of the run.
std::map<std::string, double> published_areas(const LabSetting& setting, const std::vector<Point>& points) {
  const auto figures = read_published_figures(setting.scenes / kPublishedFigures);
  std::map<std::string, double> areas;
  for (const Point& point : points)
    areas[run_name(point)] = std::stod(figure_called(figures, point.id).published);
  return areas;
}

results::ExperimentChart moving_shoe_chart(const std::vector<Point>& points,
                                           const std::map<std::string, double>& published,
                                           const SeedResults& seed) {
  results::ExperimentChart chart;
  chart.name = "moving_shoe";
  chart.title = "Discharge of the moving shoe";
  chart.subtitle = "Published: Eq. 5.17, from the transient discharge of the hopper";
  chart.x = {.label = "Speed of the shoe [m/s]", .lower = 0};
  chart.y = {.label = "Discharged area [mm2]", .lower = 0};
  std::map<double, std::vector<PointOfRun>> slits;
  for (const Point& point : points)
    slits[point.passage.width].push_back({point.passage.speed, run_name(point)});
  for (const auto& [width, runs] : slits) {
    const std::string slit = "slit of " + plain(1e3 * width) + " mm";
    add_run_series(chart, seed, slit, runs,
                   [&](const std::string& run) { return 1e6 * discharged_area(seed, run); });
    results::ExperimentSeries source{
        .name = slit + ", published", .role = results::ExperimentSeries::Role::published, .x = {}, .y = {}};
    for (const PointOfRun& point : runs) {
      source.x.push_back(point.x);
      source.y.push_back(published.at(point.run));
    }
    chart.series.push_back(source);
  }
  return chart;
}

LabPlan plan_of(const LabSetting& setting, const std::vector<Point>& points) {
  LabPowder powder = lab_powder(setting, "ASC100.29 initial D", setting.scale());
  if (!has_own_powder(setting))
    powder.changes.set += "powder.friction = 0.5\npowder.work_of_adhesion = \"0 J/m^2\"\n";
  LabPlan plan;
  for (const Point& point : points) {
    SlitPassage passage = point.passage;
    passage.width = adjusted_slit(passage.width, powder);
    const std::string run = run_name(point);
    plan.runs.push_back({run, "slit.toml", slit_changes(setting, powder, passage)});
    plan.quantities.push_back(
        {.id = point.id, .quantity = "", .unit = "", .runs = {run}, .value = [run](const SeedResults& seed) {
           return 1e6 * discharged_area(seed, run);
         }});
  }
  plan.charts = [points, published = published_areas(setting, points)](const SeedResults& seed) {
    return std::vector{moving_shoe_chart(points, published, seed)};
  };
  return plan;
}

}  // namespace

LabPlan plan_moving_shoe(const LabSetting& setting) {
  return plan_of(setting, {{"E06", {.width = 0.006, .speed = 0.2, .fill = kDeep}},
                           {"E07", {.width = 0.006, .speed = 0.4, .fill = kDeep}},
                           {"E08", {.width = 0.010, .speed = 0.2, .fill = kDeep}},
                           {"E09", {.width = 0.010, .speed = 0.4, .fill = kDeep}}});
}

LabPlan plan_long_shoe(const LabSetting& setting) {
  return plan_of(setting, {{"E10", {.width = 0.015, .speed = 0.2, .fill = kDeep, .inside = kLong}},
                           {"E11", {.width = 0.015, .speed = 0.4, .fill = kDeep, .inside = kLong}}});
}

}  // namespace diefill::process::laboratory
