#include "app/commands/shared_options/view_options.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "app/commands/shared_options/renderer_choice.h"
#include "app/options/choices.h"
#include "app/options/numbers.h"
#include "app/pictures/grain_colours.h"
#include "process/input/nearest_key.h"
#include "process/input/scene_error.h"
#include "process/input/units.h"

namespace diefill::app {

std::vector<double> numbers_in(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t at = 0; at <= text.size();) {
    const std::size_t comma = std::min(text.find(',', at), text.size());
    const std::string part = text.substr(at, comma - at);
    std::size_t used = 0;
    try {
      numbers.push_back(std::stod(part, &used));
    } catch (const std::exception&) {
      return {};
    }
    if (used != part.size() || !std::isfinite(numbers.back())) return {};
    at = comma + 1;
  }
  return numbers;
}

std::pair<double, double> range_of(const ViewArguments& arguments) {
  constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
  if (arguments.range.empty()) return {kNone, kNone};
  const double lower = arguments.range[0], upper = arguments.range[1];
  if (!(lower < upper))
    throw process::SceneError("--range: the first number must be less than the second, found " +
                              process::number_text(lower) + " and " + process::number_text(upper));
  return {lower, upper};
}

/// A preset, or azimuth and elevation in degrees.
render::Camera camera_of(const std::string& text) {
  constexpr double kDegree = std::numbers::pi / 180;
  if (text == "front") return {};
  if (text == "side") return {90 * kDegree, 20 * kDegree};
  if (text == "corner") return {35 * kDegree, 30 * kDegree};
  if (text == "above") return {0, 60 * kDegree};
  if (text == "top") return {0, 90 * kDegree};
  const auto numbers = numbers_in(text);
  if (numbers.size() == 2 && std::abs(numbers[1]) <= 90) return {numbers[0] * kDegree, numbers[1] * kDegree};
  const auto meant = process::nearest_key(text, {"front", "side", "corner", "above", "top"});
  throw process::SceneError("--camera: found \"" + text + "\"" +
                            (meant ? "; did you mean \"" + *meant + "\"?" : "") +
                            " (allowed: front, side, corner, above, top, or azimuth and elevation in "
                            "degrees, such as 30,20)");
}

render::SceneLook look_of(const ViewArguments& arguments) {
  render::SceneLook look;
  look.ambient_occlusion = arguments.ambient_occlusion;
  if (arguments.tools == "translucent") look.tools = render::ToolLook::kTranslucent;
  if (arguments.tools == "hidden") look.tools = render::ToolLook::kHidden;
  look.cut_powder = arguments.tools == "cut";
  return look;
}

void add_view_options(CLI::App& command, ViewArguments& arguments) {
  constexpr double kLargest = 1e9;  // in any unit of a colour scale
  command
      .add_option("--range", arguments.range,
                  "limits of the colour scale, such as 0.3 0.42; for a difference, minus and plus the second")
      ->expected(2)
      ->check(number_within(-kLargest, kLargest));
  command.add_option("--colour-by", arguments.colour_by, "colour of grains in views and frames")
      ->check(one_of(grain_colours()))
      ->capture_default_str();
  command.add_option("--tools", arguments.tools, "tools in views and frames")
      ->check(one_of({"cut", "translucent", "hidden"}))
      ->capture_default_str();
  command
      .add_option("--camera", arguments.camera,
                  "front, side, corner, above, top, or azimuth and elevation in degrees, such as 30,20")
      ->capture_default_str();
  add_renderer(command);
  command.add_flag("--ambient-occlusion", arguments.ambient_occlusion,
                   "shade gaps between grains with --renderer opengl; embree always does");
  command.add_option("--width", arguments.width, "width of PNG files in pixels")
      ->check(whole_number(400, 6400))
      ->capture_default_str();
}

}  // namespace diefill::app
