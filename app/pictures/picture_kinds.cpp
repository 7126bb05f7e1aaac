#include "app/pictures/picture_kinds.h"

#include "app/options/choices.h"
#include "process/input/scene_error.h"

namespace diefill::app {
namespace {

constexpr UsedOptions kChart, kField = {.range = true}, kSection = {.plane = true, .range = true},
                              kChange = {.from = true, .to = true, .range = true},
                              kView = {.to = true, .range = true, .look = true},
                              kFrames = {.range = true, .look = true};

}  // namespace

const std::vector<PictureKind>& picture_kinds() {
  static const std::vector<PictureKind> kinds = {
      {"map", "solid fraction over azimuth and height of a ring, Gaussian average", OverTime::average, kField,
       make_map},
      {"plan-map", "solid fraction over x and y of any cavity, mean over the powder's height",
       OverTime::average, kField, make_plan_map},
      {"fill-level-map", "powder surface over x and y of any cavity", OverTime::one_instant, kField,
       make_fill_level_map},
      {"partial-volumes", "solid fraction around a ring by exact volumes of cells, without averaging width",
       OverTime::one_instant, kField, make_partial_volume_map},
      {"section", "solid fraction in a plane (--origin, --normal)", OverTime::average, kSection,
       make_section},
      {"difference", "change around a ring from the first DIR to each other one, or between --from and --to",
       OverTime::one_instant, kChange, make_difference},
      {"displacement", "displacement of grains between --from and --to around the ring",
       OverTime::one_instant, kChange, make_displacement},
      {"velocity", "velocities around the ring", OverTime::average, kField, make_velocity_map},
      {"velocity-section", "velocities in a plane (--origin, --normal)", OverTime::average, kSection,
       make_velocity_section},
      {"pressure", "pressure in the powder around the ring", OverTime::one_instant, kField,
       make_pressure_map},
      {"pressure-section", "pressure in a plane (--origin, --normal)", OverTime::one_instant, kSection,
       make_pressure_section},
      {"size-map", "mean grain diameter around the ring, for powder of several sizes", OverTime::average,
       kField, make_size_map},
      {"size-section", "mean grain diameter in a plane (--origin, --normal)", OverTime::average, kSection,
       make_size_section},
      {"height-profile", "solid fraction over height with its scatter, of any cavity", OverTime::average,
       kChart, make_height_profile},
      {"azimuth-profile", "solid fraction over azimuth with its scatter over height", OverTime::average,
       kChart, make_azimuth_profile},
      {"histogram", "histogram of the solid fraction of grains", OverTime::average, kChart, make_histogram},
      {"fill-level", "powder surface over azimuth, or along the travel if the cavity is not a ring",
       OverTime::one_instant, kChart, make_fill_level},
      {"coordination", "histogram of the coordination number", OverTime::one_instant, kChart,
       make_coordination},
      {"probe", "what probes and zones recorded over time, or any of it against any other (--x, --y)",
       OverTime::one_instant, kChart, make_probe_chart},
      {"view", "shaded view (--colour-by, --tools, --camera, --ambient-occlusion)", OverTime::one_instant,
       kView, make_view},
      {"frames", "the filling as numbered views, and as film.mp4 where ffmpeg is installed",
       OverTime::one_instant, kFrames, make_frames},
  };
  return kinds;
}

std::vector<std::string> picture_kind_names() {
  std::vector<std::string> names;
  for (const auto& kind : picture_kinds()) names.emplace_back(kind.name);
  return names;
}

const PictureKind& picture_kind(const std::string& name) {
  for (const auto& kind : picture_kinds())
    if (kind.name == name) return kind;
  throw process::SceneError("--picture: " + unknown_name(name, picture_kind_names()));
}

}  // namespace diefill::app
