// Names of HDF5 groups made from names that people gave to tools, maps and sections.
#pragma once

#include <string>
#include <vector>

namespace diefill::results {

/// One name an item, fit for HDF5 paths and unlike all others: characters beyond letters, digits, '-' and '_'
/// become
/// '_', and names met before get a number.
std::vector<std::string> group_names(const std::vector<std::string>& names);

}  // namespace diefill::results
