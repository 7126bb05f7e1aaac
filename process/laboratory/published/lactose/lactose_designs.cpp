#include "process/laboratory/published/lactose/lactose_designs.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

#include "process/input/scene_error.h"
#include "process/laboratory/published/csv_rows.h"

namespace diefill::process::laboratory {
namespace {

std::vector<double> numbers_in(const std::vector<std::string>& fields, const std::string& where) {
  std::vector<double> numbers;
  for (std::size_t k = 2; k < fields.size(); ++k) numbers.push_back(number_in(fields[k], where));
  return numbers;
}

AdhesivePowder powder_of(const std::vector<double>& n) {
  AdhesivePowder powder;
  powder.hamaker = 1e-19 * n[0];
  powder.radius = 1e-6 * n[1];
  powder.friction = n[2];
  powder.dynamic_ratio = n[3];
  powder.young = 1e6 * n[4];
  powder.unloading_ratio = n[5];
  powder.cohesion_ratio = n[6];
  powder.tangential_ratio = n[7];
  powder.restitution = n[8];
  powder.damping_ratio = n[9];
  powder.depth = n[10];
  powder.rolling = n[11];
  return powder;
}

/// 1, -1 or 0 of one factor in all runs: above, below or at the middle between its extremes.
std::vector<int> levels_of(const std::vector<std::vector<double>>& rows, std::size_t factor) {
  double least = rows.front()[factor], most = least;
  for (const auto& row : rows) least = std::min(least, row[factor]), most = std::max(most, row[factor]);
  const double middle = 0.5 * (least + most), near = 0.1 * (most - least);
  std::vector<int> levels;
  for (const auto& row : rows)
    levels.push_back(row[factor] > middle + near ? 1 : row[factor] < middle - near ? -1 : 0);
  return levels;
}

using Columns = std::vector<Eigen::VectorXd>;

Columns main_columns(const std::vector<DesignRun>& runs) {
  Columns columns;
  for (std::size_t factor = 0; factor < kFactors; ++factor) {
    Eigen::VectorXd column(static_cast<Eigen::Index>(runs.size()));
    for (std::size_t k = 0; k < runs.size(); ++k)
      column[static_cast<Eigen::Index>(k)] = runs[k].levels[factor];
    if (!column.isZero()) columns.push_back(column);
  }
  return columns;
}

/// Products of two columns, one for each string of those that agree in nearly all runs (two rows of Table 18
/// have exchanged levels).
Columns pair_columns(const Columns& mains) {
  constexpr double kSame = 0.8;
  Columns pairs;
  for (std::size_t i = 0; i < mains.size(); ++i)
    for (std::size_t j = i + 1; j < mains.size(); ++j) {
      const Eigen::VectorXd pair = mains[i].cwiseProduct(mains[j]);
      const auto same = [&](const Eigen::VectorXd& other) {
        return std::abs(pair.dot(other)) > kSame * pair.norm() * other.norm();
      };
      if (std::none_of(pairs.begin(), pairs.end(), same)) pairs.push_back(pair);
    }
  return pairs;
}

bool is_corner(const DesignRun& run) {
  return std::any_of(run.levels.begin(), run.levels.end(), [](int level) { return level != 0; });
}

}  // namespace

std::vector<DesignRun> design_runs(const std::filesystem::path& file, const std::string& table) {
  std::vector<std::vector<double>> rows;
  for_each_row(file, kFactors + 2, MissingFile::no_rows, [&](const auto& fields, const auto& where) {
    if (fields[0] == table) rows.push_back(numbers_in(fields, where));
  });
  if (rows.empty()) throw SceneError(file.string() + ": cannot be read, or has no runs of table " + table);
  std::vector<DesignRun> runs;
  for (const auto& row : rows) runs.push_back({powder_of(row), {}});
  for (std::size_t factor = 0; factor < kFactors; ++factor) {
    const auto levels = levels_of(rows, factor);
    for (std::size_t k = 0; k < runs.size(); ++k) runs[k].levels.push_back(levels[k]);
  }
  return runs;
}

double effect_of(const std::vector<DesignRun>& runs, const std::vector<double>& values, Factor factor) {
  double high = 0, low = 0, highs = 0, lows = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const int level = runs[k].levels[static_cast<std::size_t>(factor)];
    if (level > 0) high += values[k], ++highs;
    if (level < 0) low += values[k], ++lows;
  }
  return high / highs - low / lows;
}

double regression_error(const std::vector<DesignRun>& runs, const std::vector<double>& values,
                        bool with_pairs) {
  Columns columns = main_columns(runs);
  if (with_pairs)
    for (auto& pair : pair_columns(columns)) columns.push_back(std::move(pair));
  const auto rows = static_cast<Eigen::Index>(runs.size());
  Eigen::MatrixXd all(rows, static_cast<Eigen::Index>(columns.size()) + 1);
  all.col(0).setOnes();
  for (std::size_t k = 0; k < columns.size(); ++k) all.col(static_cast<Eigen::Index>(k) + 1) = columns[k];
  // The centre is predicted, not fitted.
  Eigen::MatrixXd fitted = all;
  Eigen::VectorXd wanted = Eigen::Map<const Eigen::VectorXd>(values.data(), rows);
  const Eigen::VectorXd given = wanted;
  for (Eigen::Index k = 0; k < rows; ++k)
    if (!is_corner(runs[static_cast<std::size_t>(k)])) fitted.row(k).setZero(), wanted[k] = 0;
  const Eigen::VectorXd coefficients = fitted.colPivHouseholderQr().solve(wanted);
  return 100 * ((all * coefficients - given).cwiseQuotient(given)).cwiseAbs().mean();
}

}  // namespace diefill::process::laboratory
