// How large grains are: one size, classes, or a log-normal distribution, by number or by mass, and the sizes
// drawn from it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace diefill::engine {

/// Whether shares of a distribution count grains or weigh them.
enum class SizeBasis { number, mass };

/// One class of a discrete distribution.
struct SizeClass {
  double diameter = 0;  ///< m
  double share = 0;     ///< any unit; shares are taken relative to their sum
};

/// Range of diameters kept (m); sizes outside are never drawn and the rest is renormalised.
struct SizeCutOffs {
  double smallest = 0;
  double largest = std::numeric_limits<double>::infinity();
};

/// Distribution of grain diameters. Grains have one density, so mass goes with the cube of the diameter.
class SizeDistribution {
 public:
  /// All grains of one `diameter` in m.
  static SizeDistribution single(double diameter);

  /// Classes of diameter in m with shares by number or mass. Throws std::invalid_argument for no class within
  /// the cut-offs, diameters or shares that are not positive.
  static SizeDistribution discrete(std::vector<SizeClass> classes, SizeBasis basis,
                                   SizeCutOffs cut_offs = {});

  /// Log-normal with `median` in m (by number or by mass) and `log_deviation`, the standard deviation of ln
  /// d. A mass distribution is the number distribution of median m exp(-3 sigma^2) (Hatch and Choate 1929).
  /// Throws std::invalid_argument for values that are not positive and cut-offs that leave nothing.
  static SizeDistribution log_normal(double median, double log_deviation, SizeBasis basis,
                                     SizeCutOffs cut_offs = {});

  /// Log-normal by number with `mean` and `deviation` of the diameter in m before the cut-offs (Hu 2024,
  /// Eq. 6.1).
  static SizeDistribution log_normal_of_mean(double mean, double deviation, SizeCutOffs cut_offs = {});

  /// The diameter in m below which a share `fraction` (0 to 1) of all grains (number) or of all mass lies.
  double quantile(double fraction, SizeBasis basis) const;
  /// Share of grains or mass with diameter up to `diameter` in m.
  double fraction_below(double diameter, SizeBasis basis) const;
  /// Mean of d^power over the grains, in m^power.
  double moment(double power) const;
  double mean_diameter() const { return moment(1); }
  /// kg, of solid spheres of `density` in kg/m^3.
  double mean_mass(double density) const;

  /// The diameter in m that a uniform random number in [0, 1) stands for when grains are drawn one by one:
  /// the quantile by number.
  double sample(double uniform) const { return quantile(uniform, SizeBasis::number); }
  /// `count` diameters in m drawn from `seed`: the same on every machine.
  std::vector<double> sample(std::size_t count, std::uint64_t seed) const;

  /// m, of the classes of a discrete distribution, ascending; none for a log-normal one.
  std::vector<double> class_diameters() const;
  /// Smallest and largest diameter that can occur, in m (0 and infinity without cut-offs).
  SizeCutOffs range() const;
  /// All diameters times `scale`, shares by number unchanged (Hu 2024, Eqs. 3.8 to 3.12).
  SizeDistribution scaled(double scale) const;

 private:
  SizeDistribution() = default;
  double standard(double diameter) const;  // standard deviations of ln d from the number median
  double class_fraction(double diameter, double power) const;
  double tilted_fraction(double log_diameter, double power) const;

  std::vector<SizeClass> classes_;  // by number, shares of sum 1, ascending; empty for log-normal
  double log_median_ = 0;           // ln m, by number
  double log_deviation_ = 0;
  SizeCutOffs cut_offs_;
};

}  // namespace diefill::engine
