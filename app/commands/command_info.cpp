#include <cmath>
#include <cstdio>

#include "app/commands/commands.h"
#include "app/exit_code.h"
#include "process/results/cavity_rows.h"
#include "process/results/figure_table.h"
#include "process/results/formatted.h"
#include "process/results/no_value.h"
#include "process/results/storage/result_file.h"

namespace diefill::app {

namespace {

std::string exact(double value) {
  return results::formatted("%.10g", value);
}

void print_solid_fraction(const results::FillResult& result) {
  const auto& summary = result.summary;
  if (!std::isfinite(summary.mean)) {
    std::printf("solid_fraction: no value: %s\n", results::reason_for(result, "solid_fraction").c_str());
    return;
  }
  std::printf(
      "solid_fraction: mean %.6g, arithmetic_mean %.6g, std %.6g, min %.6g, max %.6g, cv %.6g over %llu "
      "grains\n",
      summary.mean, summary.arithmetic_mean, summary.std, summary.min, summary.max, summary.cv,
      static_cast<unsigned long long>(summary.grains));
}

int info(const std::string& directory) {
  const auto result = results::read_results(directory);
  std::printf("title: %s\nstrategy: %s\npowder: %s\nprogram_version: %s\nseed: %llu\nstate_hash: %s\n",
              result.title.c_str(), result.strategy.c_str(), result.powder_name.c_str(),
              result.program_version.c_str(), static_cast<unsigned long long>(result.seed),
              result.state_hash.c_str());
  for (const auto& row : results::cavity_rows(result))
    if (!row.verdict.empty()) std::printf("cavity %d: %s\n", row.number, row.verdict.c_str());
  for (const auto& [name, value] : result.figures) {
    const std::string reason = results::reason_for(result, name);
    if (std::isfinite(value) || reason.empty())
      std::printf("%s: %s  (%s)\n", name.c_str(), std::isfinite(value) ? exact(value).c_str() : "no value",
                  results::figure_meaning(name).second);
    else
      std::printf("%s: no value: %s\n", name.c_str(), reason.c_str());
  }
  print_solid_fraction(result);
  for (const auto& [phase, seconds] : result.phase_seconds)
    std::printf("seconds in %s: %.3f\n", phase.c_str(), seconds);
  for (const auto& tool : result.tools)
    std::printf("tool: %s (%s), %zu wall spheres, CAD %s\n", tool.name.c_str(), tool.role.c_str(),
                tool.wall_sphere_centres.size(), tool.mesh_hash.c_str());
  for (const auto& warning : result.warnings) std::printf("note: %s\n", warning.c_str());
  return kDone;
}

}  // namespace

void add_info(CLI::App& program, Action& chosen) {
  auto* command = program.add_subcommand("info", "Print the contents of a results directory");
  auto directory = std::make_shared<std::string>();
  command->add_option("DIR", *directory, "results directory of a run")->required();
  command->footer("Example:\n  diefill info out/narrow_ring");
  command->callback([directory, &chosen] { chosen = [directory] { return info(*directory); }; });
}

}  // namespace diefill::app
