// SPDX-License-Identifier: 0BSD
// Board-specific functions for the mps2-an386, a Cortex-M4 at 25 MHz, as emulated by QEMU.
#pragma once

#include <stdint.h>

/// The value of a 24-bit timer that counts down at 25 MHz.
uint32_t timer(void);

/// These functions call the host by semihosting.
void print(const char* before, uint32_t number, const char* after);
void leave(int is_success);
