#include "process/laboratory/published/bierwisch/repose_scene.h"

#include "process/measure/figures/heap_slope.h"
#include "process/results/figure_table.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kSlider = 0.030, kFloor = -0.042;  // m, length of the slider; of the floor below it

std::string heap_lines(const char* heap, const Eigen::AlignedBox3d& box, double half) {
  const std::string key = std::string("measure.heap.\"") + heap + "\".";
  return line(key + "from", point_in_millimetres(box.min().x(), -half, box.min().z())) +
         line(key + "to", point_in_millimetres(box.max().x(), half, box.max().z()));
}

/// Where a heap creeps: two snapshots, 2 and 4 s after the draw, then it is cleared away, as it never comes
/// to rest.
std::string creep_steps() {
  return "step.\"heaps form\".duration = \"4.1 s\"\n"
         "step.end.kind = \"clear\"\n"
         "numerics.max_time = \"15 s\"\n"
         "[[snapshot]]\nname = \"first\"\nwhen = { after = \"draw\", delay = \"2 s\" }\n"
         "[[snapshot]]\nname = \"second\"\nwhen = { after = \"draw\", delay = \"4 s\" }\n";
}

}  // namespace

double slider_draw(const LabPowder& powder) {
  return powder.size >= 0.9e-3 ? 0.010 : 0.005;
}

HeapBoxes heap_boxes(double draw) {
  using Box = Eigen::AlignedBox3d;
  using Place = Eigen::Vector3d;
  constexpr double kWide = 1;                       // m, the slice is all there is
  constexpr double kRoom = 0.002;                   // m, that the heap on the floor ends below the slider
  constexpr double kRunOut = 0.078, kHigh = 0.060;  // m
  return {Box(Place(-kRunOut, -kWide, kFloor), Place(kSlider, kWide, -kRoom)),
          Box(Place(-draw, -kWide, 0), Place(kSlider - draw, kWide, kHigh))};
}

SceneChanges repose_changes(const LabSetting& setting, const LabPowder& powder, bool creeps) {
  constexpr double kClear = 1e-4;  // m, of the pour box from slider and side wall
  const double half = 2.5 * powder.size, draw = slider_draw(powder);
  const HeapBoxes heaps = heap_boxes(draw);
  SceneChanges changes = powder.changes;
  changes.set += line("pour.from", point_in_millimetres(kClear, -half, 0));
  changes.set += line("pour.to", point_in_millimetres(kSlider - kClear, half, 0.060));
  changes.set += line("step.draw.distance", millimetres(draw));
  changes.set += line("numerics.periodic", "{ y = " + millimetres(2 * half) + " }");
  changes.set += heap_lines(kHeapOnFloor, heaps.on_floor, half);
  changes.set += heap_lines(kHeapOnSlider, heaps.on_slider, half);
  if (!has_own_powder(setting))
    changes.set += line("numerics.time_step", with_unit(2 * powder.size / powder.own_size, "us"));
  if (creeps) changes.set += creep_steps();
  return changes;
}

SceneChanges repose_changes(const LabSetting& setting, const std::string& preset, bool creeps) {
  return repose_changes(setting, lab_powder(setting, preset, setting.scale()), creeps);
}

LabQuantity heap_angle(const std::string& run, const char* heap, const std::string& snapshot) {
  const std::string name = "angle of repose, " + std::string(heap) + ", " + run;
  return {.id = name, .quantity = name, .unit = "deg", .runs = {run}, .value = [=](const SeedResults& seed) {
            const results::FillResult& result = snapshot.empty() ? seed.of(run) : seed.at(run, snapshot);
            return results::figure_of(result, heap_figure(heap));
          }};
}

}  // namespace diefill::process::laboratory
