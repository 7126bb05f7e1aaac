#include "process/laboratory/published/lactose/shear_cell.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "process/laboratory/published/dosta/bulk_curves.h"
#include "process/laboratory/published/lab_powder.h"

namespace diefill::process::laboratory {
namespace {

constexpr double kLattice = 1.12, kOffset = 0.06;  // d
constexpr double kLoose = 0.5;                     // solid fraction that `fill_height` is computed with
constexpr double kClear = 3;                       // d, least height of the tool over the floor, about
/// Share of the lattice's places over the cell's box that lie clear of its wall.
constexpr double kInside = 0.6;

/// d, of the lattice of powder.
double lattice_height(const ShearCell& cell) {
  const double layer = kInside * cell.bore * cell.bore / (kLattice * kLattice);
  return (std::ceil(cell.grains / layer) + 2) * kLattice;
}

}  // namespace

ShearCell shear_cell(LabSize size) {
  if (size == LabSize::coarse) return {};
  if (size == LabSize::medium) return {16, 4000, 0.02};
  return {16, 6000, 0.005};
}

double FilledCell::radius() const {
  return 0.5 * cell.bore * powder.diameter();
}

double FilledCell::area() const {
  return std::numbers::pi * radius() * radius();
}

double FilledCell::shear_stress(double torque) const {
  return 3 * torque / (2 * std::numbers::pi * radius() * radius() * radius());
}

double FilledCell::turn_speed() const {
  return cell.rim_speed / radius();
}

double FilledCell::angle(double rim_travel) const {
  return rim_travel * powder.diameter() / radius();
}

double FilledCell::seconds(double rim_travel) const {
  return rim_travel * powder.diameter() / cell.rim_speed;
}

std::string degrees(double radians) {
  return with_unit(radians * 180 / std::numbers::pi, "deg");
}

std::string turns_a_minute(double speed) {
  return with_unit(speed * 30 / std::numbers::pi, "rpm");
}

std::string filled_cell_lines(const FilledCell& filled, const std::string& tool, const std::string& drawing,
                              double below) {
  const double d = filled.powder.diameter(), half = filled.radius(), height = lattice_height(filled.cell);
  const std::string ending = '_' + std::to_string(filled.cell.bore) + ".stl\"", unit = with_unit(d, "m");
  const double box = filled.cell.bore * filled.cell.bore;
  std::string set =
      powder_lines(filled.powder, Packing::clusters) + fine_wall_lines(filled.powder, filled.cell.bore * d);
  set += line("tool.cell.file", "\"shear_cell" + ending) + line("tool.cell.length_unit", unit);
  set += line("tool." + tool + ".file", '"' + drawing + ending);
  set += line("tool." + tool + ".length_unit", unit);
  set += line("tool." + tool + ".position", point_in_millimetres(0, 0, (height + below + 1) * d));
  set += line("step.press.travel", millimetres((height - kClear) * d));
  set += line("pour.from", point_in_millimetres(-half, -half, 0));
  set += line("pour.to", point_in_millimetres(half, half, height * d));
  set +=
      line("pour.fill_height", millimetres(filled.cell.grains * std::numbers::pi / 6 / (kLoose * box) * d));
  set += line("pour.solid_fraction", plain(kLoose));
  set += line("pour.lattice_constant", plain(kLattice));
  set += line("pour.random_offset", plain(kOffset));
  set += line("measure.averaging_width", millimetres(d));
  return set;
}

ShearCurve shear_curve(const SeedResults& seed, const std::string& run, const std::string& tool,
                       const FilledCell& filled) {
  const TimeCurve force = probe_curve(seed, run, tool, "force z"),
                  torque = probe_curve(seed, run, tool, "torque z");
  ShearCurve curve;
  curve.time = force.time;
  for (const double value : force.value) curve.normal.push_back(value / filled.area());
  for (const double value : torque.value) curve.shear.push_back(filled.shear_stress(-value));
  return curve;
}

MeanStress mean_stress(const ShearCurve& curve, double from, double to) {
  MeanStress sum{0, 0};
  double count = 0;
  for (std::size_t k = 0; k < curve.time.size(); ++k) {
    if (curve.time[k] < from || curve.time[k] > to) continue;
    sum.normal += curve.normal[k], sum.shear += curve.shear[k], ++count;
  }
  if (count == 0) return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::quiet_NaN()};
  return {sum.normal / count, sum.shear / count};
}

MeanStress highest_stress(const ShearCurve& curve, double from, double to, double length) {
  MeanStress highest = mean_stress(curve, from, from + length);
  for (const double time : curve.time) {
    if (time < from || time + length > to) continue;
    const MeanStress here = mean_stress(curve, time, time + length);
    if (!(here.shear <= highest.shear)) highest = here;
  }
  return highest;
}

std::vector<Span> spans_of(const SeedResults& seed, const std::string& run, const std::string& tool) {
  std::vector<Span> spans;
  for (const auto& stage : seed.of(run).stages)
    if (stage.tool == tool) spans.push_back({stage.start, stage.end});
  return spans;
}

}  // namespace diefill::process::laboratory
