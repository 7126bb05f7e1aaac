#include <algorithm>

#include "process/scene/sections.h"

namespace diefill::process {
namespace {

constexpr QuantityRule kHeight = {Dimension::length, "0 mm", "-10 m", "10 m"};
constexpr QuantityRule kAveragingWidth = {Dimension::length, "0.5 mm", "0 mm", "100 mm", true};
constexpr QuantityRule kSnapshotInterval = {Dimension::time, "50 ms", "0.1 ms", "1000 s"};

SectionSpec read_section(TableReader& table) {
  SectionSpec section;
  section.name = table.required_name("name", "through the axis");
  section.origin = table.point("origin", kHeight).value_or(section.origin);
  section.normal = table.direction("normal").value_or(section.normal);
  table.finish();
  return section;
}

}  // namespace

MeasureSpec read_measure(TableReader table) {
  MeasureSpec measure;
  measure.fill_plane = table.quantity("fill_plane", kHeight).value_or(measure.fill_plane);
  measure.averaging_width =
      table.quantity("averaging_width", kAveragingWidth).value_or(measure.averaging_width);
  measure.azimuth_bins =
      static_cast<int>(table.integer("azimuth_bins", 4, 360).value_or(measure.azimuth_bins));
  measure.snapshot_interval =
      table.quantity("snapshot_interval", kSnapshotInterval).value_or(measure.snapshot_interval);
  for (TableReader& section_table : table.tables("section")) {
    SectionSpec section = read_section(section_table);
    const auto same = [&section](const SectionSpec& other) { return other.name == section.name; };
    if (std::any_of(measure.sections.begin(), measure.sections.end(), same)) {
      section_table.reject("name", "an earlier section has that name already; give each section its own");
    }
    measure.sections.push_back(std::move(section));
  }
  table.finish();
  return measure;
}

}  // namespace diefill::process
