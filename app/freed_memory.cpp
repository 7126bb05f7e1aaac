#include "app/freed_memory.h"

#include <cstdlib>  // defines __GLIBC__ with the GNU C library
#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace diefill::app {

void release_freed_memory() {
#ifdef __GLIBC__
  constexpr int kBigArray = 4 * 1024 * 1024;  // bytes
  mallopt(M_MMAP_THRESHOLD, kBigArray);
#endif
}

}  // namespace diefill::app
