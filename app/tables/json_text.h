// JSON as commands print and write it: names of files may hold bytes that are no UTF-8.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace diefill::app {

/// Indented; bytes that are no UTF-8 become U+FFFD.
inline std::string json_text(const nlohmann::ordered_json& json) {
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

}  // namespace diefill::app
