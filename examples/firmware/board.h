// SPDX-License-Identifier: 0BSD
// The parts that depend on the board: mps2-an386, a Cortex-M4 at 25 MHz, as QEMU has it.
#pragma once

#include <stdint.h>

/// Counts down at 25 MHz, 24 bits.
uint32_t timer(void);

/// The following talk to the host by semihosting.
void print(const char* before, uint32_t number, const char* after);
void leave(int is_success);
