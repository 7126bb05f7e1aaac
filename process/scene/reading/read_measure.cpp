#include <algorithm>

#include "process/measure/figures/heap_slope.h"
#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/sections.h"
#include "process/scene/zones.h"

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

HeapSpec read_heap(TableReader& table) {
  static const char* const kAxes[] = {"x", "y", "z"};
  HeapSpec heap;
  heap.name = table.required_name("name", "heap on the floor");
  heap.from = table.required_point("from", kHeight);
  heap.to = table.required_point("to", kHeight);
  for (Eigen::Index axis = 0; axis < 3; ++axis)
    if (!(heap.from[axis] < heap.to[axis]))
      table.reject("to",
                   std::string("the box is empty along ") + kAxes[axis] + ": to must be greater than from");
  table.finish();
  return heap;
}

template <class Spec>
void refuse_same_name(TableReader& table, const std::vector<Spec>& earlier, const Spec& spec,
                      const char* what) {
  const auto same = [&spec](const Spec& other) { return other.name == spec.name; };
  if (std::any_of(earlier.begin(), earlier.end(), same))
    table.reject("name", std::string("an earlier ") + what + " already has this name; give each " + what +
                             " a unique name");
}

/// Figures keep letters and digits of a name alone: those of two heaps must not be one.
void refuse_same_figure(TableReader& table, const std::vector<HeapSpec>& earlier, const HeapSpec& heap) {
  for (const HeapSpec& other : earlier)
    if (heap_figure(other.name) == heap_figure(heap.name))
      table.reject("name", "an earlier heap, \"" + other.name + "\", has the same figure, " +
                               heap_figure(heap.name) +
                               "; give names that differ in a letter from a to z or a digit");
}

}  // namespace

MeasureSpec read_measure(TableReader table, const PowderSpec& powder) {
  MeasureSpec measure;
  measure.fill_plane = table.quantity("fill_plane", kHeight);
  if (const auto width = table.quantity("averaging_width", kAveragingWidth)) {
    check_averaging_width(table, *width, powder);
    measure.averaging_width = *width;
    measure.width_place = table.where("averaging_width");
  }
  measure.azimuth_bins =
      static_cast<int>(table.integer("azimuth_bins", 4, 360).value_or(measure.azimuth_bins));
  measure.snapshot_interval =
      table.quantity("snapshot_interval", kSnapshotInterval).value_or(measure.snapshot_interval);
  for (TableReader& section_table : table.tables("section")) {
    SectionSpec section = read_section(section_table);
    refuse_same_name(section_table, measure.sections, section, "section");
    measure.sections.push_back(std::move(section));
  }
  for (TableReader& heap_table : table.tables("heap")) {
    HeapSpec heap = read_heap(heap_table);
    refuse_same_name(heap_table, measure.heaps, heap, "heap");
    refuse_same_figure(heap_table, measure.heaps, heap);
    measure.heaps.push_back(std::move(heap));
  }
  read_zones(table);
  table.finish();
  return measure;
}

}  // namespace diefill::process
