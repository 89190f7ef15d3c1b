// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>

namespace contactsim::bench {

/// What a piece of work executed, of one thread.
struct OperationCount {
  std::uint64_t instructions = 0;
  std::uint64_t flops = 0;      ///< additions, multiplications, minima, maxima; a fused multiply-add is two
  std::uint64_t divisions = 0;  ///< and square roots; not among flops
  std::uint64_t loaded = 0;     ///< by vector instructions, from wherever it lay [bytes]
  std::uint64_t stored = 0;     ///< the same, spills of registers included [bytes]
};

/// Counts by the processor's trap flag: it stops after every instruction, and the handler decodes the next
/// one. So what is counted is what was executed, whatever the compiler made of the source, and no hardware
/// counters are needed, which virtual machines often lack. Every lane of a vector counts, also lanes that are
/// masked or filled up. Takes some microseconds per instruction. On x86-64 alone; elsewhere all counts are 0.
///   work  on one thread
OperationCount count_operations(const std::function<void()>& work);

}  // namespace contactsim::bench
