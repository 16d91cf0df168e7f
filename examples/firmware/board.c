// SPDX-License-Identifier: 0BSD
#include "board.h"

#include <stddef.h>

#define REGISTER(address) (*(volatile uint32_t*)(address))

extern uint32_t stack_top[], data_source[], data_begin[], data_end[], bss_begin[], bss_end[];
int main(void);
void reset(void);

static void semihosting(uint32_t operation, uintptr_t argument) {
  register uint32_t r0 __asm__("r0") = operation;
  register uintptr_t r1 __asm__("r1") = argument;
  __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void leave(int is_success) {
  semihosting(0x18, is_success ? 0x20026 : 0x20023);  // SYS_EXIT: application exit, run-time error
  for (;;) {
  }
}

void print(const char* before, uint32_t number, const char* after) {
  char digits[11] = "";
  char* first = digits + sizeof digits - 1;
  do {
    *--first = (char)('0' + number % 10);
    number /= 10;
  } while (number != 0);
  semihosting(0x04, (uintptr_t)before);  // SYS_WRITE0
  semihosting(0x04, (uintptr_t)first);
  semihosting(0x04, (uintptr_t)after);
}

uint32_t timer(void) { return REGISTER(0xE000E018); }

void reset(void) {
  REGISTER(0xE000ED88) |= 0xFU << 20;  // CPACR: the FPU is off until now
  __asm__ volatile("dsb\n isb");
  for (ptrdiff_t i = 0; i < data_end - data_begin; ++i) data_begin[i] = data_source[i];
  for (uint32_t* word = bss_begin; word < bss_end; ++word) *word = 0;
  REGISTER(0xE000E014) = 0xFFFFFF;  // SysTick: reload value
  REGISTER(0xE000E018) = 0;
  REGISTER(0xE000E010) = 5;  // counts the processor's clock, without interrupts
  leave(main() == 0);
}

static void fault(void) { leave(0); }

__attribute__((section(".vectors"), used)) static const struct {
  uint32_t* stack;
  void (*handlers[6])(void);
} vectors = {stack_top, {reset, fault, fault, fault, fault, fault}};
