#include "process/estimate/openings/outline.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace diefill::process::estimate {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

}  // namespace

void Outline::add(const geometry::Mesh& mesh, double height) {
  for (const auto& piece : geometry::slice_outline(mesh, height, 1e6))
    pieces_.push_back({piece.from, piece.to, tools_});
  ++tools_;
}

std::vector<std::pair<double, double>> Outline::gaps(double y) const {
  std::vector<std::vector<double>> crossings(tools_);
  for (const Piece& piece : pieces_) {
    const double a = piece.from.y(), b = piece.to.y();
    if ((a < y) == (b < y)) continue;
    crossings[piece.tool].push_back(piece.from.x() + (y - a) / (b - a) * (piece.to.x() - piece.from.x()));
  }
  std::vector<std::pair<double, double>> solid;
  for (auto& at : crossings) {
    std::sort(at.begin(), at.end());
    for (std::size_t k = 0; k + 1 < at.size(); k += 2) solid.emplace_back(at[k], at[k + 1]);
  }
  std::sort(solid.begin(), solid.end());
  std::vector<std::pair<double, double>> free;
  double reached = kInfinity;
  for (const auto& [from, to] : solid) {
    if (from > reached) free.emplace_back(reached, from);
    reached = reached == kInfinity ? to : std::max(reached, to);
  }
  return free;
}

double Outline::distance(const Eigen::Vector2d& place) const {
  double least = kInfinity;
  for (const Piece& piece : pieces_) {
    const Eigen::Vector2d along = piece.to - piece.from, off = place - piece.from;
    const double part = std::clamp(off.dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (off - part * along).squaredNorm());
  }
  return std::sqrt(least);
}

double Outline::chord(const Eigen::Vector2d& place, const Eigen::Vector2d& direction) const {
  double ahead = kInfinity, behind = kInfinity;
  for (const Piece& piece : pieces_) {
    const double a = cross(direction, piece.from - place), b = cross(direction, piece.to - place);
    if ((a < 0) == (b < 0)) continue;
    const Eigen::Vector2d meets = piece.from + a / (a - b) * (piece.to - piece.from);
    const double at = direction.dot(meets - place);
    (at < 0 ? behind : ahead) = std::min(at < 0 ? behind : ahead, std::abs(at));
  }
  return ahead + behind;
}

}  // namespace diefill::process::estimate
