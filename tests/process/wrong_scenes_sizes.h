// Faults in [powder.sizes].
#pragma once

#include <string>
#include <vector>

#include "tests/process/wrong_scene.h"

namespace diefill::process {

inline std::vector<WrongScene> wrong_sizes() {
  const std::string size = "grain_diameter = \"1.88 mm\"",
                    two = "[{ diameter = \"1.5 mm\", share = 0.3 }, { diameter = \"2.1 mm\", share = 0.7 }]",
                    classes = "sizes = { distribution = \"classes\", classes = " + two + " }";
  const auto spoilt = [&](const std::string& name, const std::string& table,
                          std::vector<std::string> expected) {
    return spoil("sizes_" + name, size, "sizes = " + table, std::move(expected));
  };
  return {
      spoil(
          "sizes_and_diameter", size, "grain_diameter = @\"1.88 mm\"\n" + classes,
          {"powder.grain_diameter", "found \"1.88 mm\"", "[powder.sizes] in line", "remove one of the two"}),
      spoilt("without_distribution", "@{ classes = " + two + " }",
             {"powder.sizes.distribution", "found nothing, a value is required", "\"classes\""}),
      spoilt("of_unknown_distribution", "{ distribution = @\"normal\" }",
             {"powder.sizes.distribution", "found \"normal\"", "\"classes\" or \"log-normal\""}),
      spoilt("without_classes", "@{ distribution = \"classes\" }",
             {"powder.sizes.classes", "found nothing", "diameter = \"1.5 mm\", share = 0.3"}),
      spoilt("no_classes", "{ distribution = \"classes\", classes = @[] }",
             {"powder.sizes.classes", "0 classes, allowed: 1 to 32"}),
      spoilt("class_without_share", "{ distribution = \"classes\", classes = [@{ diameter = \"1.5 mm\" }] }",
             {"powder.sizes.classes.share", "found nothing", "0.3"}),
      spoilt("class_of_no_share",
             "{ distribution = \"classes\", classes = [{ diameter = \"1.5 mm\", share = @0 }] }",
             {"powder.sizes.classes.share", "found 0", "more than 0"}),
      spoilt("class_without_unit",
             "{ distribution = \"classes\", classes = [{ diameter = @1.5, share = 1 }] }",
             {"powder.sizes.classes.diameter", "found 1.5", "expected a length with its unit"}),
      spoilt("class_twice",
             "{ distribution = \"classes\", classes = [{ diameter = \"2 mm\", share = 1 }, { diameter = @\"2 "
             "mm\", share = 2 }] }",
             {"powder.sizes.classes.diameter", "another class has this diameter"}),
      spoilt("none_left", "{ distribution = \"classes\", smallest = @\"3 mm\", classes = " + two + " }",
             {"powder.sizes.smallest", "none of the classes lies between smallest and largest"}),
      spoilt("limits_crossed",
             "{ distribution = \"log-normal\", median = \"2 mm\", log_deviation = 0.2, smallest = \"3 mm\", "
             "largest = @\"1 mm\" }",
             {"powder.sizes.largest", "it must be greater than smallest, which is 3 mm"}),
      spoilt("without_median", "@{ distribution = \"log-normal\", log_deviation = 0.2 }",
             {"powder.sizes.median", "found nothing", "\"1.9 mm\""}),
      spoilt("two_ways",
             "{ distribution = \"log-normal\", mean = \"2 mm\", deviation = \"0.2 mm\", median = @\"2 mm\" }",
             {"powder.sizes.median", "mean and deviation already define the distribution"}),
      spoilt("mean_by_mass", "{ distribution = \"log-normal\", mean = @\"2 mm\", deviation = \"0.2 mm\" }",
             {"powder.sizes.mean", "write basis = \"number\""}),
      spoilt("too_many_classes",
             "{ distribution = \"log-normal\", median = \"2 mm\", log_deviation = 0.2, number_of_classes = "
             "@99 }",
             {"powder.sizes.number_of_classes", "found 99", "2 to 32"}),
      spoilt("too_wide", "{ distribution = @\"log-normal\", median = \"2 mm\", log_deviation = 1.5 }",
             {"powder.sizes.distribution", "times the size of the smallest", "allowed: up to 50 times",
              "with smallest and largest"}),
      spoilt("misspelt",
             "{ distribution = \"log-normal\", median = \"2 mm\", @log_deviaton = 0.2, log_deviation = 0.2 }",
             {"powder.sizes.log_deviaton", "did you mean \"log_deviation\"?"}),
      spoil(
          "sizes_too_coarse", size,
          "sizes = @{ distribution = \"classes\", classes = [{ diameter = \"40 mm\", share = 1 }, { diameter "
          "= \"50 mm\", share = 1 }] }",
          {"powder.sizes", "allowed: 0.04704 mm to 9.408 mm", "coarse graining is not valid"}),
      spoilt("mean_size_without_unit",
             "{ distribution = \"classes\", mean_size = @1.5, classes = " + two + " }",
             {"powder.sizes.mean_size", "found 1.5", "expected a length with its unit"}),
  };
}

}  // namespace diefill::process
