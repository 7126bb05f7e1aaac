// Compiles loops over many contacts or grains for several instruction sets and selects the processor's best
// at run time. All give the same bits: every lane does the same IEEE operations as scalar code, without fused
// multiply-adds.
#pragma once

namespace diefill::engine {

enum class InstructionSet { baseline, avx2, avx512 };

/// The widest instruction set that this processor has.
inline InstructionSet best_instruction_set() {
#if defined(__x86_64__)
  if (__builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512dq") &&
      __builtin_cpu_supports("avx512vl"))
    return InstructionSet::avx512;
  if (__builtin_cpu_supports("avx2")) return InstructionSet::avx2;
#endif
  return InstructionSet::baseline;
}

namespace instructions {

template <class Work>
[[gnu::flatten]] void baseline(const Work& work) {
  work();
}

#if defined(__x86_64__)
template <class Work>
[[gnu::target("avx2"), gnu::flatten]] void avx2(const Work& work) {
  work();
}

template <class Work>
[[gnu::target("avx512f,avx512dq,avx512vl,prefer-vector-width=512"), gnu::flatten]] void avx512(
    const Work& work) {
  work();
}
#endif

}  // namespace instructions

/// Calls work() compiled for `set`. Everything that work() calls is inlined, so it should contain only loops
/// over arrays of plain numbers.
template <class Work>
void with_instructions(InstructionSet set, const Work& work) {
#if defined(__x86_64__)
  if (set == InstructionSet::avx512) return instructions::avx512(work);
  if (set == InstructionSet::avx2) return instructions::avx2(work);
#endif
  instructions::baseline(work);
}

}  // namespace diefill::engine
