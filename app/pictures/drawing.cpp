#include "app/pictures/drawing.h"

#include "process/measure/choose_cavity.h"
#include "process/measure/fields/averaging_width.h"
#include "process/measure/fields/measured_fields.h"
#include "process/run/assemble.h"
#include "render/fields/comparison_picture.h"
#include "render/fields/pictures.h"
#include "render/offscreen/start_offscreen.h"

namespace diefill::app {

void set_up_drawing() {
  // Qt keeps both for the life of the program.
  static char name[] = "diefill";
  static char* arguments[] = {name, nullptr};
  static int count = 1;
  render::start_offscreen(count, arguments);
}

std::vector<results::FillResult> of_other_cavities(const results::FillResult& result) {
  constexpr int kAzimuthBins = 36;  // of profiles, which are not drawn
  std::vector<results::FillResult> others;
  results::FillResult whole = result;
  whole.instants.clear();
  whole.probes.clear();
  for (std::size_t n = 0; n < result.other_cavities.size(); ++n) {
    others.push_back(whole);
    process::choose_cavity(others.back(), static_cast<int>(n) + 2);
    process::measure_fields(others.back(), {process::measured_averaging_width(result), {}}, kAzimuthBins);
    others.back().sections.clear();
  }
  return others;
}

render::ColourRange range_of_all_cavities(const std::vector<const results::FillResult*>& results) {
  std::vector<results::FillResult> others;
  for (const auto* result : results)
    for (auto& other : of_other_cavities(*result)) others.push_back(std::move(other));
  std::vector<const results::FillResult*> all = results;
  for (const auto& other : others) all.push_back(&other);
  return render::solid_fraction_range(all);
}

std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::FillResult& result) {
  set_up_drawing();
  const auto others = of_other_cavities(result);
  std::vector<const results::FillResult*> all = {&result};
  for (const auto& other : others) all.push_back(&other);
  const render::ColourRange range = render::solid_fraction_range(all);
  auto written = render::draw_all(directory, result, range);
  for (std::size_t n = 0; n < others.size(); ++n)
    for (const auto& map : render::draw_maps(directory, others[n], range, "_cavity_" + std::to_string(n + 2)))
      written.push_back(map);
  return written;
}

std::vector<std::filesystem::path> draw(const std::filesystem::path& directory,
                                        const results::Comparison& comparison) {
  std::vector<render::ComparedField> fields;
  for (std::size_t k = 0; k < comparison.variants.size(); ++k)
    if (!comparison.fields[k].value.empty())
      fields.push_back({comparison.variants[k], comparison.fields[k], comparison.field_seeds[k]});
  if (fields.empty()) return {};
  set_up_drawing();
  const auto png = directory / "comparison.png";
  render::draw_comparison(png, fields, comparison.title);
  return {png};
}

}  // namespace diefill::app
