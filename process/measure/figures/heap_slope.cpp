#include "process/measure/figures/heap_slope.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "process/measure/figures/line_fit.h"

namespace diefill::process {
namespace {

constexpr double kColumn = 2;    // d
constexpr double kMiddle = 0.6;  // of the columns, the rest are toe and top
constexpr std::size_t kMin = 3;  // columns that make a slope

/// One column's middle and the highest grain centre in it, m.
struct Top {
  double x = 0, z = 0;
};

std::vector<Top> surface(const results::PowderState& powder, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  const double width = kColumn * powder.grain_diameter;
  const auto columns = static_cast<std::size_t>(std::max(1.0, std::ceil((to[0] - from[0]) / width)));
  std::vector<double> highest(columns, from[2]);
  for (const Eigen::Vector3d& place : powder.position) {
    if ((place.array() < from.array()).any() || (place.array() > to.array()).any()) continue;
    const auto column = std::min(static_cast<std::size_t>((place[0] - from[0]) / width), columns - 1);
    highest[column] = std::max(highest[column], place[2]);
  }
  std::vector<Top> tops;
  for (std::size_t k = 0; k < columns; ++k)
    if (highest[k] - from[2] >= kColumn * powder.grain_diameter)
      tops.push_back({from[0] + (static_cast<double>(k) + 0.5) * width, highest[k]});
  return tops;
}

/// dz/dx of the line of least squares.
double gradient(const std::vector<Top>& tops) {
  std::vector<double> x, z;
  for (const Top& top : tops) {
    x.push_back(top.x);
    z.push_back(top.z);
  }
  return fit_line(x, z).slope;
}

}  // namespace

double heap_slope(const results::PowderState& powder, const Eigen::Vector3d& from,
                  const Eigen::Vector3d& to) {
  std::vector<Top> tops = surface(powder, from, to);
  const auto cut = static_cast<std::ptrdiff_t>(0.5 * (1 - kMiddle) * static_cast<double>(tops.size()));
  tops = {tops.begin() + cut, tops.end() - cut};
  if (tops.size() < kMin) return std::numeric_limits<double>::quiet_NaN();
  return std::atan(std::abs(gradient(tops))) * 180 / std::numbers::pi;
}

std::string heap_figure(const std::string& name) {
  std::string key = "slope_of_";
  for (const char letter : name) key += std::isalnum(static_cast<unsigned char>(letter)) != 0 ? letter : '_';
  return key + "_deg";
}

}  // namespace diefill::process
