// Numbers on the command line within limits: CLI11's own ranges take "nan" for a number within them.
#pragma once

#include <CLI/CLI.hpp>

namespace diefill::app {

/// For options that hold a whole number, decimal and without zeros in front, from `least` to `most`.
CLI::Validator whole_number(long long least, long long most);

/// For options that hold a number from `least` to `most`, neither nan nor inf.
CLI::Validator number_within(double least, double most);

/// For options that hold a finite number above 0.
CLI::Validator number_above_zero();

}  // namespace diefill::app
