// A CSV of measurements as columns of numbers, whatever they mean.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "process/measured_data/measured_table.h"

namespace diefill::process {

struct MeasuredColumns {
  std::vector<MeasuredColumn> columns;
  std::string where;       ///< the file; begins messages
  std::vector<int> lines;  ///< of each row
};

/// `expected` gives the required number of columns where `count` is wrong; empty: it is right. Throws
/// SceneError as read_measured_csv() does for what is wrong with headings and numbers.
MeasuredColumns columns_in(const std::filesystem::path& file,
                           const std::function<std::string(std::size_t count)>& expected);

}  // namespace diefill::process
