// Builds and runs programs of tests/emit/compiled/ with emitted headers, by both compilers.
#include <catch2/catch.hpp>
#include <iostream>
#include <vector>

#include "support/installed.hpp"
#include "support/shell.hpp"

using namespace elgen;
using namespace elgen::test;

namespace {

Outcome build(const std::string& compiler, const std::string& program, const Workspace& workspace,
              const std::string& flags = "") {
  const std::string source = ELGEN_SOURCE_DIR;
  return shell(compiler +
                   " -std=c++17 -O2 -ffp-contract=off -Wall -Wextra -Wpedantic -Wconversion "
                   "-Wshadow -Werror " +
                   flags + " -I" + source + "/generated " + source + "/tests/emit/compiled/" +
                   program + " -o program",
               workspace.path());
}

/// Builds a program with each compiler and runs it. `scene` is generated first, if given.
void build_and_run(const std::string& program, const std::string& flags = "",
                   const std::string& scene = "") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Workspace workspace;
  if (!scene.empty()) {
    workspace.prepare("elgen generate -q -o . " ELGEN_SOURCE_DIR "/tests/emit/compiled/" + scene);
  }
  REQUIRE(failure_of(build(compiler, program, workspace, flags)) == "");
  CHECK(failure_of(shell("./program", workspace.path())) == "");
}

/// A command that links a program for 32-bit x86.
std::string link_command_32_bit(const std::string& compiler) {
  return "echo 'int main() {}' | " + compiler + " -m32 -x c++ -include cmath -o /dev/null -";
}

}  // namespace

TEST_CASE("in-line sines keep their digits, and library sines their bits") {
  build_and_run("angles.cpp", GENERATE("", "-march=native"));
}

TEST_CASE("packs pass through functions unmodified, every lane equal to the scalar") {
  build_and_run("packs.cpp", "-Wno-psabi -Wno-ignored-attributes");
}

TEST_CASE("a pack has to declare the type of its elements") {
  build_and_run("unnamed_element.cpp", "-Wno-psabi -DVALUE_TYPE");
  const std::string compiler = GENERATE("g++", "clang++");
  const Workspace workspace;
  const Outcome built = build(compiler, "unnamed_element.cpp", workspace, "-Wno-psabi");
  CHECK(built.status != 0);
  CHECK(mentions(built.errors, "using value_type = double;"));
}

TEST_CASE("batches agree with the functions of one state") {
  build_and_run("batch.cpp", GENERATE("", "-march=native", "-march=x86-64-v3"));
}

TEST_CASE("packs on both sides of a comparison have the bits of one state") {
  build_and_run("kinked.cpp", "-Wno-psabi -Wno-ignored-attributes -I.", "kinked.scene.toml");
}

TEST_CASE("kernels of batches agree with the functions of one state") {
  build_and_run("kernel.cpp");
}

TEST_CASE("fast-math is refused by batches or does not change their angles") {
  const std::string compiler = GENERATE("g++", "clang++");
  const std::string flags = GENERATE("-ffast-math", "-ffast-math -fno-finite-math-only",
                                     "-Ofast -fno-finite-math-only", "-funsafe-math-optimizations",
                                     "-fassociative-math -fno-signed-zeros -fno-trapping-math");
  // clang has no macro for parts of fast-math, but a pragma protects the reduction of angles.
  const bool is_refused = compiler == "g++" || flags == "-ffast-math";
  const Workspace workspace;
  const Outcome built = build(compiler, "batch.cpp", workspace, flags + " -DELGEN_ALLOW_FAST_MATH");
  INFO(compiler << " " << flags << "\n" << built.errors);
  REQUIRE((built.status != 0) == is_refused);
  if (is_refused) {
    CHECK(mentions(built.errors, "fast-math breaks the reduction of angles"));
  } else {
    CHECK(shell("./program", workspace.path()).status == 0);
  }
}

TEST_CASE("macros of other headers do not break batches") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Workspace workspace;
  CHECK(failure_of(build(compiler, "macros.cpp", workspace, "-fsyntax-only")) == "");
}

TEST_CASE("excess precision is refused by batches") {
  const std::string compiler = GENERATE("g++", "clang++");
  const Workspace workspace;
  const auto is_refused = [&](const std::string& flags) {
    const Outcome built = build(compiler, "batch.cpp", workspace,
                                flags + " -Wno-builtin-macro-redefined -fsyntax-only");
    INFO(compiler << " " << flags << "\n" << built.errors);
    const bool is_named =
        mentions(built.errors,
                 "excess precision breaks the reduction of angles: on x86 add -msse2 -mfpmath=sse");
    CHECK((built.status != 0) == is_named);
    return is_named;
  };
  for (const char* const method : {"-1", "1", "2"}) {
    CHECK(is_refused("-U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=" + std::string(method)));
  }
  // The value 16 only occurs with _Float16.
  for (const char* const method : {"0", "16"}) {
    CHECK_FALSE(is_refused("-U__FLT_EVAL_METHOD__ -D__FLT_EVAL_METHOD__=" + std::string(method)));
  }
  if (!is_installed("a library of 32-bit x86", link_command_32_bit(compiler))) return;
  CHECK(is_refused("-m32 -mno-sse2"));
  CHECK(is_refused("-m32 -msse -mno-sse2"));  // clang++ defines __FLT_EVAL_METHOD__ as 0 here
  CHECK_FALSE(is_refused("-m32 -msse2 -mfpmath=sse"));
}

TEST_CASE("batches have the same bits on every machine") {
  const Workspace workspace;
  const auto bits = [&](const std::string& compiler, const std::string& emulator) {
    const Outcome built = build(compiler, "bits.cpp", workspace);
    INFO(compiler << "\n" << built.errors);
    REQUIRE(built.status == 0);
    CHECK_FALSE(mentions(built.errors, "note: "));  // g++ notes a changed ABI
    return shell(emulator + " ./program", workspace.path()).output;
  };
  const std::string here = bits("g++", "");
  REQUIRE(here.size() == 34);
  CHECK(bits("clang++", "") == here);
  if (is_installed("a library of 32-bit x86", link_command_32_bit("g++"))) {
    CHECK(bits("g++ -m32 -msse2 -mfpmath=sse", "") == here);
  }
  struct Machine {
    std::string compiler;
    std::string emulator;
  };
  const std::vector<Machine> machines{{"aarch64-linux-gnu-g++", "qemu-aarch64"},
                                      {"arm-linux-gnueabihf-g++", "qemu-arm"},
                                      {"s390x-linux-gnu-g++", "qemu-s390x"},
                                      {"riscv64-linux-gnu-g++", "qemu-riscv64"},
                                      {"powerpc64le-linux-gnu-g++", "qemu-ppc64le"},
                                      {"mips64el-linux-gnuabi64-g++", "qemu-mips64el"}};
  for (const auto& [compiler, emulator] : machines) {
    const std::string probe = compiler + " --version && " + emulator + " --version";
    if (!is_installed(compiler + " with " + emulator, probe)) continue;
    INFO(compiler);
    CHECK(bits(compiler + " -static", emulator) == here);
  }
}

TEST_CASE("parts of fast-math are refused by functions in C++ and in C") {
  const std::string header =
      GENERATE("-std=c++17 -x c++ cart_pole/cart_pole.hpp",
               "-std=c99 -x c panda7_gravity_compensation/panda7_gravity_compensation.h");
  const std::filesystem::path folder = std::string(ELGEN_SOURCE_DIR) + "/generated";
  const std::string command = "g++ -fsyntax-only -funsafe-math-optimizations " + header;
  CHECK(mentions(shell(command, folder).errors, "fast-math reorders these equations"));
  CHECK(shell(command + " -DELGEN_ALLOW_FAST_MATH", folder).status == 0);
}

TEST_CASE("a standard before C++17 is reported") {
  const Outcome compiled = shell("g++ -std=c++14 -fsyntax-only -x c++ cart_pole/cart_pole.hpp",
                                 std::string(ELGEN_SOURCE_DIR) + "/generated");
  CHECK(mentions(compiled.errors, "these functions are C++17: compile with -std=c++17"));
}

TEST_CASE("device code can call the functions, and batches are kernels") {
  const Workspace workspace;
  const std::string folders = " -I" + (std::string(ELGEN_SOURCE_DIR) + "/generated ") +
                              ELGEN_SOURCE_DIR + "/tests/emit/compiled/device.cu -o device";
  const auto knows = [&](const std::string& question) {
    return shell(question, workspace.path()).status == 0;
  };
  std::string compiler;
  if (knows("nvcc --version")) {
    compiler = "nvcc -std=c++17 --expt-relaxed-constexpr -Xptxas -v -c";
  } else if (knows("clang++ --print-targets | grep -q nvptx64")) {
    // Without NVIDIA's headers the program itself declares the functions that it needs.
    compiler =
        "clang++ -std=c++17 -O1 -x cuda -nocudainc -nocudalib --cuda-device-only "
        "--cuda-gpu-arch=sm_70 -Wall -Wextra -Wno-unknown-cuda-version -Werror -S";
  } else {
    WARN("skipped: neither nvcc nor a clang++ that knows GPUs is here");
    return;
  }
  const Outcome built = shell(compiler + folders, workspace.path());
  INFO(compiler << "\n" << built.errors);
  CHECK(built.status == 0);
  for (const std::string& line : split_lines(built.errors)) {
    const bool is_of_kernel = mentions(line, "Function properties for ") ||
                              mentions(line, " stack frame") || mentions(line, " registers");
    if (is_of_kernel) std::cout << line << '\n';
    // The library's slow path for large angles would need a stack frame.
    if (mentions(line, " stack frame")) CHECK(mentions(line, " 0 bytes stack frame"));
  }
}

TEST_CASE("users may define the macro ELGEN_FUNCTION") {
  const Workspace workspace;
  write_text(workspace.path() / "own.cpp",
             "#define ELGEN_FUNCTION __attribute__((noinline))\n"
             "#include \"cart_pole/cart_pole.hpp\"\n"
             "double M() { return cart_pole::mass_matrix<double>({}, {})[0]; }\n");
  const Outcome built = shell(
      "g++ -std=c++17 -O2 -S own.cpp -o - -I " + (ELGEN_SOURCE_DIR + std::string("/generated")),
      workspace.path());
  REQUIRE(built.status == 0);
  CHECK(mentions(built.output, "mass_matrix"));
}
