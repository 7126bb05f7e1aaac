#include "process/results/studies/measured_comparison.h"

#include "process/results/csv_field.h"
#include "process/results/storage/atomic_file.h"

namespace diefill::results {
namespace {

std::string column(const std::string& name, const std::string& unit) {
  return csv_text(name + " [" + unit + "]");
}

std::string points_csv(const MeasuredComparison& comparison) {
  std::string text = column(comparison.first_name, comparison.first_unit);
  if (comparison.is_map()) text += ',' + column(comparison.second_name, comparison.second_unit);
  for (const char* what : {"measured ", "deviation of ", "simulated ", "difference of "})
    text += ',' + column(what + comparison.quantity, comparison.unit);
  text += '\n';
  for (std::size_t k = 0; k < comparison.measured.size(); ++k) {
    text += csv_number(comparison.first[k]);
    if (comparison.is_map()) text += ',' + csv_number(comparison.second[k]);
    for (const double value : {comparison.measured[k], comparison.deviation[k], comparison.simulated[k],
                               comparison.simulated[k] - comparison.measured[k]})
      text += ',' + csv_number(value, 6);
    text += '\n';
  }
  return text;
}

std::string zones_csv(const MeasuredComparison& comparison) {
  std::string text = "zone,points";
  for (const char* what : {"mean measured ", "mean simulated ", "mean difference of ", "rms difference of "})
    text += ',' + column(what + comparison.quantity, comparison.unit);
  text += ",correlation\n";
  for (const MeasuredZone& zone : comparison.zones) {
    text += csv_text(zone.name) + ',' + std::to_string(zone.points);
    for (const double value :
         {zone.measured, zone.simulated, zone.simulated - zone.measured, zone.rms, zone.correlation})
      text += ',' + csv_number(value, 6);
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<std::filesystem::path> write_measured_comparison(const std::filesystem::path& directory,
                                                             const MeasuredComparison& comparison) {
  const std::string start = "measured_" + comparison.name;
  write_text_atomically(directory / (start + ".csv"), points_csv(comparison));
  write_text_atomically(directory / (start + "_zones.csv"), zones_csv(comparison));
  return {start + ".csv", start + "_zones.csv"};
}

}  // namespace diefill::results
