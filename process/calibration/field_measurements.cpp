// Profiles and maps of a scene's result against measured ones.
#include "process/calibration/measurement.h"
#include "process/measured_data/simulated_values.h"

namespace diefill::process::calibration {
namespace {

using OfResult = std::vector<double> (*)(const results::FillResult&, const std::string&, const MeasuredTable&,
                                         const std::string&);

Measurement read_field(TableReader& table, const MeasurementContext& context, const std::string& key,
                       const std::string& example, std::size_t places, OfResult of_result) {
  Measurement measurement;
  const std::string quantity = table.required_text(key, example);
  measurement.quantity = quantity;
  measurement.runs = {run_of_scene(table, context)};
  measurement.data = read_measured(table, places);
  const std::string where = table.where(key);
  measurement.simulated = [=, data = measurement.data](const std::vector<FinishedRun>& runs) {
    return of_result(*runs.front().result, quantity, data, where);
  };
  return measurement;
}

}  // namespace

Measurement read_profile_measurement(TableReader& table, const MeasurementContext& context) {
  return read_field(table, context, "profile", "fill level", 1, profile_values);
}

Measurement read_map_measurement(TableReader& table, const MeasurementContext& context) {
  return read_field(table, context, "map", "solid fraction", 2, map_values);
}

}  // namespace diefill::process::calibration
