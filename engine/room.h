// How much memory arrays keep that are filled anew again and again.
#pragma once

#include <cstddef>
#include <vector>

namespace diefill::engine {

/// Room for `count` values in `values`, which becomes empty. Memory that would stand idle is given back: a
/// step's speed is that of the memory it has to pass through.
template <class Value>
void make_room(std::vector<Value>& values, std::size_t count) {
  if (values.capacity() > count + count / 4) std::vector<Value>().swap(values);
  values.clear();
  values.reserve(count);
}

}  // namespace diefill::engine
