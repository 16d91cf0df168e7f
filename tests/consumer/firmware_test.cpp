// examples/firmware, cross-compiled for a Cortex-M4 and run in QEMU, whose instruction counts are
// reproducible. The undefined symbols of the objects show the library functions that a controller
// needs.
#include <catch2/catch.hpp>

#include "consumer/projects.hpp"

namespace elgen::test {

namespace {

bool has_cross_compiler() {
  return is_installed("arm-none-eabi-gcc, its newlib or qemu-system-arm",
                      "echo '#include <math.h>' | arm-none-eabi-gcc -E - && "
                      "command -v qemu-system-arm");
}

class Firmware : public Example {
 public:
  Firmware()
      : Example("firmware", "-G Ninja -DCMAKE_TOOLCHAIN_FILE=cortex-m4.cmake '-Delgen_DIR=" +
                                (installed() / "share/cmake/elgen").string() + "'") {}

  /// The firmware's lines that begin with angle or control. ctest runs the firmware in the emulator
  /// of the toolchain file.
  [[nodiscard]] std::string test_output() const {
    const Outcome tested = run("ctest --test-dir build --verbose --timeout 60");
    CHECK(tested.status == 0);
    write("printed", tested.output);
    return run("grep -E '^1: (angle|control)' printed").output;
  }

  /// The undefined symbols of an object that do not match `allowed`, one per line.
  [[nodiscard]] std::string undefined_symbols(const std::string& object,
                                              const std::string& allowed) const {
    const Outcome listed = run("arm-none-eabi-nm -P -u build/CMakeFiles/firmware.dir/" + object);
    CHECK(listed.status == 0);
    write("needed", listed.output);
    return run("cut -d' ' -f1 needed | grep -vxE '" + allowed + "'").output;
  }
};

}  // namespace

TEST_CASE("the firmware balances its pendulum, with the same output in every run", "[.all]") {
  if (!has_cross_compiler()) return;
  const Firmware firmware;
  const std::string printed = firmware.test_output();
  INFO(printed);
  CHECK(number_after(printed, "angle ") < 2000);
  CHECK(number_after(printed, "2000 urad from ") < 2000);
  const double instructions = number_after(printed, "control law: ");
  CHECK(instructions > 20);
  CHECK(instructions < 150);
  CHECK(number_after(printed, "simulated pendulum: ") > instructions);
  CHECK(firmware.test_output() == printed);
  CHECK(is_in_readme(printed));
}

TEST_CASE("the firmware needs no heap, no doubles, and only sine and cosine from libm", "[.all]") {
  if (!has_cross_compiler()) return;
  const Firmware firmware;
  CHECK(firmware.undefined_symbols("controller.c.obj", "sinf|cosf").empty());
  CHECK(firmware.undefined_symbols("main.c.obj", "sinf|cosf|memcpy|memset|motor_torque|print|timer")
            .empty());
  const Outcome linked = firmware.run("arm-none-eabi-nm build/firmware");
  CHECK(mentions(linked.output, " T sinf\n"));
  for (const std::string name : {"malloc", "_sbrk", "__aeabi_dadd", "__aeabi_dmul", "printf"}) {
    CHECK_FALSE(mentions(linked.output, name));
  }
  const Outcome size = firmware.run("arm-none-eabi-size build/firmware | awk 'NR == 2'");
  INFO(size.output);
  const unsigned long text = std::stoul(size.output);
  CHECK(text > 1000);
  CHECK(text < 8192);
}

}  // namespace elgen::test
