#include "render/report/report.h"

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "render/report/comparison.h"
#include "render/report/sections/measured_section.h"
#include "render/report/sections/run_sections.h"
#include "render/report/viewer/view_block.h"

namespace diefill::render::report {
namespace {

/// One scale of the solid fraction for all pictures of the report.
ColourRange range_of(const std::vector<const Run*>& runs) {
  std::vector<const results::FillResult*> results;
  for (const Run* run : runs) {
    results.push_back(&run->result);
    for (const auto& cavity : run->other_cavities) results.push_back(&cavity);
  }
  return solid_fraction_range(results);
}

/// Behind the results, where it has been measured.
void add_measured(std::vector<Section>& sections, const Run& run, int level) {
  if (!run.measured.empty())
    sections.insert(sections.begin() + std::min<std::ptrdiff_t>(1, std::ssize(sections)),
                    measured_section(run.measured, level));
}

bool has_something_to_show(const Run& run) {
  return !run.result.powder.position.empty() || !run.result.tools.empty();
}

/// The runs in three dimensions, and their films.
Section view_section(const std::vector<const Run*>& runs, const ColourRange& range,
                     const MeasureForView& measure) {
  Section section{"In three dimensions", 1, {}};
  std::vector<ViewExtras> extras(runs.size());
  std::vector<ViewedRun> viewed;
  for (std::size_t n = 0; n < runs.size(); ++n) {
    if (!has_something_to_show(*runs[n])) continue;
    if (measure && viewed.size() < kMaxViewedRuns) extras[n] = measure(runs[n]->result);
    const std::string name = runs[n]->strategy.empty() ? runs[n]->name : runs[n]->strategy;
    viewed.push_back({runs.size() > 1 ? name : "", &runs[n]->result, &extras[n]});
  }
  if (!viewed.empty()) section.blocks.emplace_back(view_of(viewed, range));
  for (const Run* run : runs)
    for (const Film& film : run->films) section.blocks.emplace_back(film);
  return section;
}

/// Behind the first section, unless there is nothing to show.
void add_view(std::vector<Section>& sections, Section view) {
  if (!view.blocks.empty())
    sections.insert(sections.begin() + std::min<std::ptrdiff_t>(1, std::ssize(sections)), std::move(view));
}

Document single(const Run& run, const MeasureForView& measure) {
  const auto& result = run.result;
  Document document;
  document.title = result.title.empty() ? run.name : result.title;
  document.subtitle = "Die filling: " + result.powder_name + ", " + result.strategy + ". diefill " +
                      result.program_version + ", results in " + run.name;
  const ColourRange range = range_of({&run});
  document.sections = run_sections(result, 1, {range, &run.other_cavities});
  add_measured(document.sections, run, 1);
  add_view(document.sections, view_section({&run}, range, measure));
  return document;
}

Document several(const std::vector<Run>& runs, const MeasureForView& measure) {
  const auto strategies = strategies_of(runs);
  Document document;
  document.title = std::to_string(strategies.size()) +
                   (strategies.size() == 1 ? " filling strategy, " : " filling strategies, ") +
                   std::to_string(runs.size()) + " runs";
  document.subtitle =
      "Die filling: " + runs.front().result.powder_name + ". diefill " + runs.front().result.program_version;
  std::vector<const Run*> shown;
  for (const auto& strategy : strategies) shown.push_back(strategy.runs.front());
  const ColourRange range = range_of(shown);
  document.sections = comparison_sections(strategies, range);
  add_view(document.sections, view_section(shown, range, measure));
  for (const auto& strategy : strategies) {
    Section chapter{"Strategy: " + strategy.name, 1, {}};
    std::string names;
    for (const Run* run : strategy.runs) names += (names.empty() ? "" : ", ") + run->name;
    chapter.blocks.emplace_back(Paragraph{"Results in " + names + "."});
    if (strategy.runs.size() > 1)
      chapter.blocks.emplace_back(Paragraph{"The following sections show the first of these runs."});
    document.sections.push_back(chapter);
    const SharedPictures shared{range, &strategy.runs.front()->other_cavities};
    auto sections = run_sections(strategy.first(), 2, shared);
    add_measured(sections, *strategy.runs.front(), 2);
    for (auto& section : sections) document.sections.push_back(section);
  }
  return document;
}

}  // namespace

Document report_of(const std::vector<Run>& runs, const MeasureForView& measure) {
  if (runs.empty()) throw std::invalid_argument("a report needs a run");
  return runs.size() == 1 ? single(runs.front(), measure) : several(runs, measure);
}

}  // namespace diefill::render::report
