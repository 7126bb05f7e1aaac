// Exception that ends a run outside the method's valid range.
#pragma once

#include <stdexcept>

namespace diefill::engine {

/// A run that has left the method's valid range. The message is one line: what was found, where, the limit,
/// what to change.
struct OutOfRange : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace diefill::engine
