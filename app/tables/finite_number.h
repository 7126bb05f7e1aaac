// A number on the command line that is one: CLI11's ranges take "nan" for a number within them.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace diefill::app {

/// For options that hold a number.
inline CLI::Validator finite_number() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0;
        const bool read = CLI::detail::lexical_cast(text, value);
        return read && std::isfinite(value) ? std::string() : "found " + text + ", expected a finite number";
      },
      "");
}

}  // namespace diefill::app
