// The reason why a figure of a run has no value.
#pragma once

#include <string>

#include "process/results/fill_result.h"

namespace diefill::results {

/// Topic under which results keep the reasons.
inline constexpr const char* kNoValueTopic = "no value";

/// Sets a figure to no value (NaN) and stores the reason; an existing reason is kept.
void set_no_value(FillResult& result, const std::string& figure, const std::string& reason);

/// Why `figure` has no value ("solid_fraction" for the summary); empty where no reason is stored.
std::string reason_for(const FillResult& result, const std::string& figure);

/// The statement `name` of a topic; empty where there is none.
std::string statement(const FillResult& result, const std::string& topic, const std::string& name);

/// Adds a statement to a topic, which is made where it is missing.
void add_statement(FillResult& result, const std::string& topic, const std::string& name,
                   const std::string& text);

}  // namespace diefill::results
