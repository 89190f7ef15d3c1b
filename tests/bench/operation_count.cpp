// SPDX-License-Identifier: BSD-3-Clause
#include "operation_count.hpp"

#if defined(__x86_64__)
#include <signal.h>
#include <ucontext.h>
#endif

namespace contactsim::bench {

#if defined(__x86_64__)

namespace {

/// What counts of an instruction. Source: AMD64 Architecture Programmer's Manual 3 (2023), 1.2; Intel 64 and
/// IA-32 Architectures Software Developer's Manual 2 (2023), 2.1, 2.3 and 2.7.
struct Instruction {
  int map = 0;               ///< 1 of opcodes after 0F, 2 after 0F 38, 3 after 0F 3A; 0 of all others
  int opcode = 0;            ///< in its map
  int prefix = 0;            ///< 0 packed floats, 1 packed doubles, 2 a float, 3 a double
  int width = 16;            ///< of its vectors [bytes]
  bool wide = false;         ///< of doubles rather than floats, where the prefix does not tell
  bool coded = false;        ///< by VEX or EVEX
  bool one_for_all = false;  ///< memory is one number for all lanes
  bool memory = false;       ///< an operand lies in memory
};

int prefix_of(int byte) { return byte == 0x66 ? 1 : byte == 0xF3 ? 2 : byte == 0xF2 ? 3 : 0; }

/// Reads the opcode of an instruction without VEX or EVEX.
void decode_legacy(const std::uint8_t* at, Instruction& found) {
  for (; *at == 0x66 || *at == 0xF2 || *at == 0xF3 || *at == 0x2E || *at == 0x3E || *at == 0x64; ++at) {
    if (prefix_of(*at) != 0) found.prefix = prefix_of(*at);
  }
  if ((*at & 0xF0) == 0x40) ++at;
  if (*at != 0x0F || at[1] == 0x38 || at[1] == 0x3A) return;
  found.map = 1;
  found.opcode = at[1];
  found.memory = at[2] >> 6 != 3;
}

Instruction decode(const std::uint8_t* at) {
  Instruction found;
  const std::uint8_t* opcode = nullptr;
  if (at[0] == 0xC5) {
    found.map = 1;
    found.prefix = at[1] & 3;
    found.width = (at[1] & 4) != 0 ? 32 : 16;
    opcode = at + 2;
  } else if (at[0] == 0xC4) {
    found.map = at[1] & 31;
    found.prefix = at[2] & 3;
    found.wide = at[2] >> 7 != 0;
    found.width = (at[2] & 4) != 0 ? 32 : 16;
    opcode = at + 3;
  } else if (at[0] == 0x62) {
    found.map = at[1] & 7;
    found.prefix = at[2] & 3;
    found.wide = at[2] >> 7 != 0;
    found.width = 16 << ((at[3] >> 5) & 3);
    found.one_for_all = (at[3] & 16) != 0;
    opcode = at + 4;
  } else {
    decode_legacy(at, found);
    return found;
  }
  found.coded = true;
  found.opcode = *opcode;
  found.memory = opcode[1] >> 6 != 3;
  if (found.one_for_all && !found.memory) found.width = 64;  // rounding stands where the width did
  return found;
}

/// VEX and EVEX order the prefixes none, 66, F3, F2, as prefix_of does.
bool is_scalar(const Instruction& found) { return found.prefix >= 2; }

std::uint64_t lanes_of(const Instruction& found) {
  if (is_scalar(found)) return 1;
  return static_cast<std::uint64_t>(found.width / (found.prefix == 1 ? 8 : 4));
}

void count_arithmetic(const Instruction& found, OperationCount& sums) {
  if (found.map == 1) {
    switch (found.opcode) {
      case 0x58:  // add
      case 0x59:  // multiply
      case 0x5C:  // subtract
      case 0x5D:  // minimum
      case 0x5F:  // maximum
        sums.flops += lanes_of(found);
        return;
      case 0x51:  // square root
      case 0x5E:  // divide
        sums.divisions += lanes_of(found);
        return;
      default:
        return;
    }
  }
  const int form = found.opcode & 15, order = found.opcode >> 4;
  if (found.map != 2 || !found.coded || form < 6 || order < 9 || order > 11) return;
  const bool one = form >= 9 && form % 2 == 1;
  sums.flops += one ? 2 : 2 * static_cast<std::uint64_t>(found.width / (found.wide ? 8 : 4));
}

/// Bytes of the operand in memory: moves and arithmetic on vectors and their scalars.
std::uint64_t bytes_of(const Instruction& found) {
  if (found.one_for_all) return found.wide ? 8 : 4;
  const bool has_scalars = found.map == 1 && (found.opcode == 0x10 || found.opcode == 0x11 ||
                                              (found.opcode >= 0x51 && found.opcode <= 0x5F));
  if (has_scalars && is_scalar(found)) return found.prefix == 3 ? 8 : 4;
  return static_cast<std::uint64_t>(found.width);
}

bool is_vector_move(int opcode) {
  return opcode == 0x10 || opcode == 0x28 || opcode == 0x6F || (opcode >= 0x51 && opcode <= 0x5F);
}

void count_memory(const Instruction& found, OperationCount& sums) {
  if (!found.memory || found.map == 0) return;
  const int code = found.opcode;
  const bool stores =
      found.map == 1 && (code == 0x11 || code == 0x29 || code == 0x2B || code == 0x7F || code == 0xE7);
  if (stores) {
    sums.stored += bytes_of(found);
  } else if (found.coded || is_vector_move(code)) {
    sums.loaded += bytes_of(found);
  }
}

constexpr greg_t trap_flag = 0x100;

/// A signal handler knows nothing but globals.
OperationCount* counting = nullptr;
volatile sig_atomic_t is_over = 0;

void on_trap(int /*signal*/, siginfo_t* /*info*/, void* place) {
  auto& registers = static_cast<ucontext_t*>(place)->uc_mcontext.gregs;
  if (is_over) {
    registers[REG_EFL] &= ~trap_flag;
    return;
  }
  registers[REG_EFL] |= trap_flag;
  const Instruction next = decode(reinterpret_cast<const std::uint8_t*>(registers[REG_RIP]));
  ++counting->instructions;
  count_arithmetic(next, *counting);
  count_memory(next, *counting);
}

}  // namespace

OperationCount count_operations(const std::function<void()>& work) {
  OperationCount sums;
  struct sigaction action {
  }, before{};
  action.sa_sigaction = on_trap;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGTRAP, &action, &before);
  counting = &sums;
  is_over = 0;
  raise(SIGTRAP);
  work();
  is_over = 1;  // the next trap is the last one
  sigaction(SIGTRAP, &before, nullptr);
  return sums;
}

#else

OperationCount count_operations(const std::function<void()>& /*work*/) { return {}; }

#endif

}  // namespace contactsim::bench
