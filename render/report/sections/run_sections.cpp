#include "render/report/sections/run_sections.h"

#include <algorithm>
#include <cmath>

#include "process/results/margins.h"
#include "render/report/figure_text.h"
#include "render/report/numbers.h"
#include "render/report/pictures_of.h"
#include "render/report/sections/filling_section.h"
#include "render/report/sections/over_time.h"
#include "render/report/sections/versions.h"

namespace diefill::render::report {
namespace {

using Row = std::vector<std::string>;
using results::FillResult;

constexpr const char* kNotStored = "An earlier version wrote these results without this information.";

void add_row(Table& table, const std::string& name, double value, const std::string& unit, int digits = 4) {
  if (std::isfinite(value)) table.rows.push_back({name, with_unit(value, unit, digits)});
}

/// The first picture, which is the map that decides, in full width; the others side by side.
Section pictures_section(const FillResult& result, const SharedPictures& shared) {
  std::vector<Figure> figures = pictures_of(result, shared);
  Section section{"Maps and pictures", 1, {}};
  if (figures.empty()) return section;
  section.blocks.emplace_back(Figures{{figures.front()}});
  figures.erase(figures.begin());
  section.blocks.emplace_back(Figures{figures, true});
  return section;
}

Section warnings_section(const FillResult& result) {
  Section section{"Warnings", 1, {}};
  for (const auto& warning : result.warnings)
    if (!warning.empty()) section.blocks.emplace_back(Paragraph{warning, true});
  for (const auto& line : results::exceeded_text(result))
    if (std::find(result.warnings.begin(), result.warnings.end(), line) == result.warnings.end())
      section.blocks.emplace_back(Paragraph{line, true});
  if (section.blocks.empty()) section.blocks.emplace_back(Paragraph{"The run reported no warnings."});
  return section;
}

Section strategy_section(const FillResult& result) {
  Section section{"Strategy", 1, {Paragraph{result.strategy}}};
  if (result.stages.empty()) {
    section.blocks.emplace_back(Paragraph{kNotStored});
    return section;
  }
  section.blocks.emplace_back(Figures{timeline_of(result)});
  Table table{"", {"Stage", "Tool", "Start [s]", "End [s]"}, {}};
  using results::Stage;
  const auto start = column_of(result.stages, &Stage::start), end = column_of(result.stages, &Stage::end);
  for (std::size_t k = 0; k < result.stages.size(); ++k) {
    const Stage& stage = result.stages[k];
    table.rows.push_back({stage.words, stage.tool.empty() ? "–" : stage.tool, start[k], end[k]});
  }
  section.blocks.emplace_back(table);
  return section;
}

std::string size_of(const results::ToolState& tool) {
  if (tool.vertices.empty()) return "–";
  Eigen::Vector3d lower = tool.vertices.front(), upper = lower;
  for (const auto& vertex : tool.vertices) {
    lower = lower.cwiseMin(vertex);
    upper = upper.cwiseMax(vertex);
  }
  const Eigen::Vector3d size = 1e3 * (upper - lower);
  return in_digits(size[0]) + " × " + in_digits(size[1]) + " × " + in_digits(size[2]);
}

Table tool_table(const FillResult& result) {
  Table table{
      "", {"Tool", "Role", "Size [mm]", "Triangles", row_title("wall_spheres"), "Hash of the CAD file"}, {}};
  for (const auto& tool : result.tools)
    table.rows.push_back({tool.name, tool.role, size_of(tool),
                          in_digits(static_cast<double>(tool.triangles.size())),
                          in_digits(static_cast<double>(tool.wall_sphere_centres.size())), tool.mesh_hash});
  return table;
}

Table check_table(const FillResult& result) {
  Table table{
      "Mesh findings and deviation of the wall spheres from the CAD surface",
      {"Tool", "CAD file", "Volume [cm³]", "Deviation, mean / largest [mm]", "Largest gap [mm]", "Mesh"},
      {}};
  using results::ToolCheck;
  const auto& checks = result.tool_checks;
  const auto volume = column_of(checks, [](const ToolCheck&check) { return 1e6 * check.volume; }),
             gap = column_of(
                 checks, [](const ToolCheck&check) { return 1e3 * check.largest_gap; }, 2);
  for (std::size_t k = 0; k < checks.size(); ++k) {
    const ToolCheck& check = checks[k];
    std::string findings;
    for (const auto& finding : check.findings) findings += (findings.empty() ? "" : "; ") + finding;
    if (findings.empty()) findings = "closed, oriented, free of self-intersections";
    table.rows.push_back(
        {check.tool, check.file, volume[k],
         in_digits(1e3 * check.mean_deviation, 2) + " / " + in_digits(1e3 * check.largest_deviation, 2),
         gap[k], findings});
  }
  return table;
}

Section tooling_section(const FillResult& result) {
  Section section{"Tooling", 1, {}};
  section.blocks.emplace_back(Figures{tool_views(result)});
  const auto& cavity = result.cavity;
  if (cavity.volume > 0) {
    Table table{"Cavity", {}, {}};
    table.rows.push_back({short_title("cavity_volume_m3"), shown("cavity_volume_m3", cavity.volume)});
    add_row(table, "Depth", 1e3 * (cavity.upper_corner[2] - cavity.lower_corner[2]), "mm");
    const char* const width = "cavity_narrowest_width_m";
    if (cavity.narrowest_width > 0)
      table.rows.push_back({short_title(width), shown(width, cavity.narrowest_width)});
    if (cavity.is_ring) {
      add_row(table, "Ring, inner diameter", 2e3 * cavity.inner_radius, "mm");
      add_row(table, "Ring, outer diameter", 2e3 * cavity.outer_radius, "mm");
    }
    add_figure(table, result, "grain_diameter_over_cavity_width");
    section.blocks.emplace_back(table);
  } else {
    section.blocks.emplace_back(Paragraph{"The tools enclose no cavity below the fill plane."});
  }
  section.blocks.emplace_back(tool_table(result));
  if (result.tool_checks.empty())
    section.blocks.emplace_back(Paragraph{std::string("Mesh findings: ") + kNotStored});
  else
    section.blocks.emplace_back(check_table(result));
  return section;
}

/// The statements of the topics named, as one section.
Section topics_section(const FillResult& result, const std::string& title,
                       const std::vector<std::string>& wanted) {
  Section section{title, 1, {}};
  Table table;
  for (const auto& name : wanted)
    for (const auto& topic : result.topics)
      if (topic.topic == name)
        for (std::size_t n = 0; n < topic.name.size(); ++n)
          table.rows.push_back({topic.name[n], topic.text[n]});
  if (table.rows.empty())
    section.blocks.emplace_back(Paragraph{kNotStored});
  else
    section.blocks.emplace_back(table);
  return section;
}

Section stability_section(const FillResult& result) {
  Section section{"Stability margins", 1, {}};
  Table table{"", {"Quantity", "Found", "Limit", "Share of the limit"}, {}, true};
  for (const auto& margin : results::margins(result)) {
    const std::string limit = std::isfinite(margin.limit)
                                  ? (margin.either_side ? "±" : "at most ") + in_digits(margin.limit, 3)
                                  : "–";
    table.rows.push_back({margin.name, in_digits(margin.found, 3), limit,
                          std::isfinite(margin.limit) ? in_digits(100 * margin.share(), 2) + " %" : "–"});
    if (margin.exceeded()) table.rows.back().back() += ", exceeded";
  }
  section.blocks.emplace_back(table);
  for (const auto& line : results::exceeded_text(result)) section.blocks.emplace_back(Paragraph{line, true});
  section.blocks.emplace_back(
      Paragraph{"A run that exceeds one of these limits stops without results. For energy, unexplained loss "
                "counts as much as gain; the run completes with a warning."});
  return section;
}

Section speed_section(const FillResult& result) {
  Section section{"Size and speed of the computation", 1, {}};
  Table table;
  for (const char* name : {"grains", "spheres", "wall_spheres", "steps", "time_step_s", "simulated_s"})
    add_figure(table, result, name);
  table.rows.push_back({row_title("wall_seconds"), as_duration(figure(result, "wall_seconds"))});
  add_figure(table, result, "threads");
  add_figure(table, result, "sphere_steps_per_second", short_title("sphere_steps_per_second"));
  section.blocks.emplace_back(table);
  Table phases{"Computing time by phase of the step, since the last restart", {"Phase", "Time"}, {}, true};
  for (const auto& [phase, seconds] : result.phase_seconds)
    phases.rows.push_back({phase, as_duration(seconds)});
  if (!phases.rows.empty()) section.blocks.emplace_back(phases);
  return section;
}

Section versions_section(const FillResult& result) {
  Section section = topics_section(result, "Versions", {"versions"});
  Table table;
  if (result.topics.empty()) table.rows.push_back({"diefill", result.program_version});
  table.rows.push_back({"Seed", std::to_string(result.seed)});
  table.rows.push_back({"Hash of the final state", result.state_hash});
  table.rows.push_back({"Report drawn with", drawing_versions()});
  section.blocks.emplace_back(table);
  return section;
}

}  // namespace

std::vector<Section> run_sections(const FillResult& result, int level, const SharedPictures& shared) {
  std::vector<Section> sections = {
      filling_section(result),
      warnings_section(result),
      pictures_section(result, shared),
      over_time_section(result),
      strategy_section(result),
      tooling_section(result),
      topics_section(result, "Powder and model", {"powder", "model", "walls", "numerics", "setting"}),
      topics_section(result, "Approximations", {"assumptions"}),
      stability_section(result),
      speed_section(result),
      versions_section(result),
      {"Scene", 1, {Listing{result.scene_text}}}};
  std::erase_if(sections, [](const Section& section) { return section.blocks.empty(); });
  for (Section& section : sections) section.level = level;
  return sections;
}

}  // namespace diefill::render::report
