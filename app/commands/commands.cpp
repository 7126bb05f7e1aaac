#include "app/commands/commands.h"

namespace diefill::app {

void add_commands(CLI::App& program, Action& chosen) {
  add_new(program, chosen);
  add_run(program, chosen);
  add_check(program, chosen);
  add_estimate(program, chosen);
  add_plan(program, chosen);
  add_powders(program, chosen);
  add_fit_discharge(program, chosen);
  add_compare(program, chosen);
  add_tradeoff(program, chosen);
  add_calibrate(program, chosen);
  add_map(program, chosen);
  add_film(program, chosen);
  add_report(program, chosen);
  add_export(program, chosen);
  add_info(program, chosen);
  add_bench(program, chosen);
  add_lab(program, chosen);
}

}  // namespace diefill::app
