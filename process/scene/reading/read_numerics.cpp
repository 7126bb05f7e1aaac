#include "process/scene/reading/plausibility.h"
#include "process/scene/reading/sections.h"

namespace diefill::process {
namespace {

constexpr NumberRule kTimeStepFraction = {0, 1, true, "0.1"};
constexpr QuantityRule kTimeStep = {Dimension::time, "2 us", "0 us", "1 ms", true};
constexpr NumberRule kMaxSheared = {0, 0.1, false, "0.01"};
constexpr QuantityRule kPeriod = {Dimension::length, "2.16 mm", "0 mm", "1 m", true};
constexpr QuantityRule kSkin = {Dimension::length, "0.1 mm", "0 mm", "10 mm", true};
constexpr QuantityRule kMaxTime = {Dimension::time, "5 s", "0 s", "10000 s", true};
constexpr QuantityRule kCheckpoint = {Dimension::time, "60 s", "1 s", "86400 s"};

void read_time_step(TableReader& table, NumericsSpec& numerics) {
  numerics.time_step_fraction = table.number("time_step_fraction", kTimeStepFraction).value_or(0);
  numerics.time_step = table.quantity("time_step", kTimeStep);
  if (numerics.time_step && table.has("time_step_fraction")) {
    table.reject("time_step", "time_step_fraction is given as well; remove one of the two");
  }
}

void read_pinched_grains(TableReader& table, NumericsSpec& numerics) {
  static const Choices<PinchedGrains> choices = {{"shear off", PinchedGrains::shear_off},
                                                 {"stop", PinchedGrains::stop}};
  numerics.pinched_grains = table.choice("pinched_grains", choices).value_or(numerics.pinched_grains);
  numerics.most_sheared = table.number("most_sheared", kMaxSheared).value_or(numerics.most_sheared);
  if (numerics.pinched_grains == PinchedGrains::stop && table.has("most_sheared"))
    table.reject("most_sheared", "pinched_grains = \"stop\" shears no grains off; remove one of the two");
}

void read_periods(TableReader& numerics_table, NumericsSpec& numerics, const PowderSpec& powder) {
  auto table = numerics_table.table("periodic");
  if (!table) return;
  numerics.period = {table->quantity("x", kPeriod), table->quantity("y", kPeriod),
                     table->quantity("z", kPeriod)};
  table->finish();
  if (numerics.period[0]) check_period(*table, "x", *numerics.period[0], powder);
  if (numerics.period[1]) check_period(*table, "y", *numerics.period[1], powder);
  if (numerics.period[2]) check_period(*table, "z", *numerics.period[2], powder);
}

}  // namespace

NumericsSpec read_numerics(TableReader table, const PowderSpec& powder) {
  static const Choices<LeverArm> lever_arms = {{"center", LeverArm::center}, {"contact", LeverArm::contact}};
  static const Choices<TangentialSpring> springs = {{"cut back", TangentialSpring::cut_back},
                                                    {"free", TangentialSpring::free}};
  static const Choices<OpeningMeasure> openings = {{"surfaces", OpeningMeasure::surfaces},
                                                   {"centres", OpeningMeasure::centres}};
  NumericsSpec numerics;
  read_time_step(table, numerics);
  numerics.lever_arm = table.choice("lever_arm", lever_arms).value_or(numerics.lever_arm);
  numerics.tangential_spring =
      table.choice("tangential_spring", springs).value_or(numerics.tangential_spring);
  numerics.opening = table.choice("opening", openings).value_or(numerics.opening);
  read_pinched_grains(table, numerics);
  numerics.skin = table.quantity("skin", kSkin).value_or(numerics.skin);
  numerics.max_time = table.quantity("max_time", kMaxTime).value_or(numerics.max_time);
  numerics.checkpoint_interval =
      table.quantity("checkpoint_interval", kCheckpoint).value_or(numerics.checkpoint_interval);
  read_periods(table, numerics, powder);
  table.finish();
  return numerics;
}

}  // namespace diefill::process
