// Stands in for geometry/cad/cad_child.cpp in the guided fuzzer: readers run where the fuzzer sees their
// coverage, and are held to a child's limit on memory by the operators below.
#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "geometry/cad/cad_child.h"

namespace {

constexpr std::ptrdiff_t kMaxMemory = std::ptrdiff_t{1} << 30;  // bytes; the rest to 2 GiB is the sanitizer's
std::atomic<std::ptrdiff_t> in_use = 0;

std::ptrdiff_t size_of(void* place) {
  return static_cast<std::ptrdiff_t>(malloc_usable_size(place));
}

}  // namespace

void* operator new(std::size_t size, const std::nothrow_t& /*none*/) noexcept {
  const bool fits = size < std::size_t{kMaxMemory} && in_use + static_cast<std::ptrdiff_t>(size) < kMaxMemory;
  void* const place = fits ? std::malloc(size) : nullptr;
  if (place != nullptr) in_use += size_of(place);
  return place;
}

void* operator new[](std::size_t size, const std::nothrow_t& none) noexcept {
  return operator new(size, none);
}

void* operator new(std::size_t size) {
  void* const place = operator new(size, std::nothrow);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}

void* operator new[](std::size_t size) {
  return operator new(size);
}

void operator delete(void* place) noexcept {
  if (place != nullptr) in_use -= size_of(place);
  std::free(place);
}

void operator delete[](void* place) noexcept {
  operator delete(place);
}

void operator delete(void* place, std::size_t /*size*/) noexcept {
  operator delete(place);
}

void operator delete[](void* place, std::size_t /*size*/) noexcept {
  operator delete(place);
}

namespace diefill::geometry {

CadParts read_in_child(const std::function<CadParts()>& read, const ChildLimits& /*limits*/) {
  try {
    return read();
  } catch (const std::bad_alloc&) {
    throw ChildError(ChildFailure::kTooMuchMemory, "it declares more data than a file of its size can hold");
  } catch (const std::exception& error) {
    throw ChildError(ChildFailure::kRefused, error.what());
  } catch (...) {
    throw ChildError(ChildFailure::kRefused, "the importer failed without a message");
  }
}

}  // namespace diefill::geometry
