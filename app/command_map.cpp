#include <cstdio>

#include "app/commands.h"
#include "app/drawing.h"
#include "app/exit_code.h"
#include "app/output.h"
#include "process/results/result_file.h"
#include "process/run/assemble.h"
#include "process/scene/units.h"

namespace diefill::app {

namespace {

struct MapArguments {
  std::string directory, out, averaging_width, normal;
  std::vector<std::string> origin;
};

double length(const char* option, const std::string& text) {
  try {
    return process::parse_quantity(text, process::Dimension::length);
  } catch (const process::UnitError& error) {
    throw process::SceneError(std::string(option) + ": found \"" + text + "\": " + error.what());
  }
}

Eigen::Vector3d normal_of(const std::string& name) {
  if (name == "x") return Eigen::Vector3d::UnitX();
  if (name == "z") return Eigen::Vector3d::UnitZ();
  return Eigen::Vector3d::UnitY();
}

int map(const MapArguments& arguments) {
  auto result = results::read_results(arguments.directory);
  process::FieldRequest request;
  if (!arguments.averaging_width.empty()) {
    request.averaging_width = length("--averaging-width", arguments.averaging_width);
    if (!(request.averaging_width > 0))
      throw process::SceneError("--averaging-width: found \"" + arguments.averaging_width +
                                "\"; it must be positive");
  }
  if (!arguments.origin.empty() || !arguments.normal.empty()) {
    Eigen::Vector3d origin = result.cavity.axis_origin;
    for (std::size_t axis = 0; axis < arguments.origin.size(); ++axis)
      origin[static_cast<Eigen::Index>(axis)] = length("--origin", arguments.origin[axis]);
    request.sections.push_back(process::section_plane("section", origin, normal_of(arguments.normal)));
  }
  const int bins = result.profiles.empty() ? 36 : static_cast<int>(result.profiles.front().x.size());
  process::measure_fields(result, request, bins);
  const std::filesystem::path out = arguments.out.empty() ? arguments.directory : arguments.out;
  make_output_directory(out);
  write_output([&] {
    for (const auto& picture : draw(out, result)) std::printf("%s\n", picture.string().c_str());
  });
  return kDone;
}

}  // namespace

void add_map(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand(
      "map", "Draw the pictures of a results directory again, with other sections or averaging");
  auto arguments = std::make_shared<MapArguments>();
  command->add_option("DIR", arguments->directory, "results directory of a run")->required();
  command->add_option("--out", arguments->out, "directory for the pictures (default: DIR)");
  command->add_option("--averaging-width", arguments->averaging_width,
                      "Gaussian width sigma of the averaging, such as '1 mm'");
  command
      ->add_option("--origin", arguments->origin, "point of the section plane, such as '0 mm' '0 mm' '-5 mm'")
      ->expected(3);
  command->add_option("--normal", arguments->normal, "normal of the section plane: x, y or z")
      ->check(CLI::IsMember({"x", "y", "z"}));
  command->footer(
      "Examples:\n"
      "  diefill map out/narrow_ring --averaging-width '1 mm'\n"
      "  diefill map out/narrow_ring --normal z --origin '0 mm' '0 mm' '-10 mm' --out out/at_half_height");
  command->callback([arguments, &chosen] { chosen = [arguments] { return map(*arguments); }; });
}

}  // namespace diefill::app
