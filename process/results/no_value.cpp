#include "process/results/no_value.h"

#include <algorithm>
#include <limits>

namespace diefill::results {

void set_no_value(FillResult& result, const std::string& figure, const std::string& reason) {
  result.figures[figure] = std::numeric_limits<double>::quiet_NaN();
  if (reason_for(result, figure).empty()) add_statement(result, kNoValueTopic, figure, reason);
}

std::string reason_for(const FillResult& result, const std::string& figure) {
  return statement(result, kNoValueTopic, figure);
}

std::string statement(const FillResult& result, const std::string& topic, const std::string& name) {
  for (const Topic& known : result.topics) {
    if (known.topic != topic) continue;
    const auto found = std::find(known.name.begin(), known.name.end(), name);
    if (found != known.name.end()) return known.text[static_cast<std::size_t>(found - known.name.begin())];
  }
  return {};
}

void add_statement(FillResult& result, const std::string& topic, const std::string& name,
                   const std::string& text) {
  auto known = std::find_if(result.topics.begin(), result.topics.end(),
                            [&](const Topic& other) { return other.topic == topic; });
  if (known == result.topics.end()) known = result.topics.insert(known, Topic{topic, {}, {}});
  known->name.push_back(name);
  known->text.push_back(text);
}

}  // namespace diefill::results
